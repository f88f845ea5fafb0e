#pragma once

#include "calculators/lubricant_curves.hpp"
#include "desktop/chart_page.hpp"

#include <vector>

/// A lubricant of kTrac as charts: traction over slip, viscosity over pressure, film and lambda
/// over speed. Used by `adore plot --lubricant` and, for record 10, by AdrInput.
namespace adore::desktop {

inline constexpr const char* kLubricantPages[] = {"traction", "viscosity", "film"};

/// Titles name the lubricant and, if the page does not show it otherwise, the content.
enum class LubricantTitle : unsigned char { Whole, Lubricant };
[[nodiscard]] std::vector<ChartPage> lubricant_pages(const calculators::LubricantContact& contact,
                                                     LubricantTitle title = LubricantTitle::Whole);

}  // namespace adore::desktop
