#pragma once

#include "calculators/lubricant_curves.hpp"
#include "desktop/chart_page.hpp"

#include <vector>

/// A lubricant of kTrac as charts: traction over slip, viscosity over pressure, film and lambda
/// over speed. `adore plot --lubricant` draws them, AdrInput shows them beside record 10.
namespace adore::desktop {

inline constexpr const char* kLubricantPages[] = {"traction", "viscosity", "film"};

[[nodiscard]] std::vector<ChartPage> lubricant_pages(const calculators::LubricantContact& contact);

}  // namespace adore::desktop
