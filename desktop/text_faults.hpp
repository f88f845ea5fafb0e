#pragma once

#include "desktop/chart_scene.hpp"

#include <string>
#include <vector>

namespace adore::desktop {

/// Words of a page that nobody can read: texts that lie over each other or beyond the page's edge,
/// or that end in dots.
/// A sentence each; none is well.
[[nodiscard]] std::vector<std::string> text_faults(const ChartScene& scene);

}  // namespace adore::desktop
