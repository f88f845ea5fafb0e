#pragma once

#include <QColor>

namespace adore::desktop {

/// Color of a value between the lowest (0) and the highest (1): dark blue over green to yellow
/// (viridis). Its lightness increases, so that it can be read in gray, too.
[[nodiscard]] QColor heat_color(double share);

}  // namespace adore::desktop
