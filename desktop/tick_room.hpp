#pragma once

#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>

#include <vector>

/// Numbers of an axis that have room beside each other.
namespace adore::desktop {

/// Of an axis so many pixels long, the ticks whose numbers do not lie on each other: all, or fewer
/// round ones, or the outermost.
[[nodiscard]] std::vector<AxisTick> ticks_across(std::vector<AxisTick> ticks, const AxisScale& axis,
                                                 qreal length, const QFontMetricsF& letters);
/// The same of an upright axis, whose numbers stand above each other.
[[nodiscard]] std::vector<AxisTick> ticks_upwards(std::vector<AxisTick> ticks,
                                                  const AxisScale& axis, qreal length,
                                                  const QFontMetricsF& letters);

}  // namespace adore::desktop
