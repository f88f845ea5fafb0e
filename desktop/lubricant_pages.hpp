#pragma once

#include "calculators/lubricant_curves.hpp"
#include "desktop/chart_page.hpp"

#include <vector>

/// A lubricant of kTrac as charts: traction over slip, viscosity over pressure, film and lambda
/// over speed. `adore plot --lubricant` draws them, AdrInput shows them beside record 10.
namespace adore::desktop {

inline constexpr const char* kLubricantPages[] = {"traction", "viscosity", "film"};

/// Titles name the lubricant and, where nothing beside the page says it, what is drawn.
enum class LubricantTitle : unsigned char { Whole, Lubricant };
[[nodiscard]] std::vector<ChartPage> lubricant_pages(const calculators::LubricantContact& contact,
                                                     LubricantTitle title = LubricantTitle::Whole);

}  // namespace adore::desktop
