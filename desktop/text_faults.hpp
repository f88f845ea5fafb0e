#pragma once

#include "desktop/chart_scene.hpp"

#include <string>
#include <vector>

namespace adore::desktop {

/// Unreadable texts of a page: texts that overlap or extend beyond the page edge, or that end in
/// dots.
/// One sentence each; none: no faults.
[[nodiscard]] std::vector<std::string> text_faults(const ChartScene& scene);

}  // namespace adore::desktop
