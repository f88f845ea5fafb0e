#pragma once

#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>

#include <vector>

/// Numbers of an axis that do not overlap.
namespace adore::desktop {

/// Ticks of an axis with that many pixels whose numbers do not overlap: all, or fewer round ones,
/// or the outermost.
[[nodiscard]] std::vector<AxisTick> fit_horizontal_ticks(std::vector<AxisTick> ticks,
                                                         const AxisScale& axis, qreal length,
                                                         const QFontMetricsF& letters);
/// The same for a vertical axis, whose numbers are above each other.
[[nodiscard]] std::vector<AxisTick> fit_vertical_ticks(std::vector<AxisTick> ticks,
                                                       const AxisScale& axis, qreal length,
                                                       const QFontMetricsF& letters);

}  // namespace adore::desktop
