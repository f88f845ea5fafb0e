#include "desktop/tick_room.hpp"

#include <QString>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace adore::desktop {
namespace {

/// @param room that two neighbors need from middle to middle
template <class Room>
std::vector<AxisTick> thinned(std::vector<AxisTick> ticks, const AxisScale& axis, qreal length,
                              Room room) {
  const auto apart = [&](const std::vector<AxisTick>& some) {
    for (std::size_t i = 1; i < some.size(); ++i)
      if ((some[i].at - some[i - 1].at) / (axis.max - axis.min) * length <
          room(some[i - 1], some[i]))
        return false;
    return true;
  };
  if (ticks.size() < 2 || apart(ticks)) return ticks;
  // Of a logarithmic axis every first step is a power of ten.
  for (const double every : {1.0, 2.0, 5.0, 10.0}) {
    std::vector<AxisTick> fewer;
    std::copy_if(ticks.begin(), ticks.end(), std::back_inserter(fewer), [&](const AxisTick& tick) {
      return std::abs(std::remainder(tick.at / axis.step, every)) < 1e-6;
    });
    if (fewer.size() < 2) break;  // two numbers make a scale
    if (apart(fewer)) return fewer;
  }
  std::vector<AxisTick> ends{ticks.front(), ticks.back()};
  if (!apart(ends)) ends.pop_back();
  return ends;
}

}  // namespace

std::vector<AxisTick> fit_horizontal_ticks(std::vector<AxisTick> ticks, const AxisScale& axis,
                                           qreal length, const QFontMetricsF& letters) {
  constexpr qreal kBetween = 6.0;
  const auto width = [&](const AxisTick& tick) {
    return letters.horizontalAdvance(QString::fromStdString(tick.text));
  };
  return thinned(std::move(ticks), axis, length, [&](const AxisTick& a, const AxisTick& b) {
    return 0.5 * (width(a) + width(b)) + kBetween;
  });
}

std::vector<AxisTick> fit_vertical_ticks(std::vector<AxisTick> ticks, const AxisScale& axis,
                                         qreal length, const QFontMetricsF& letters) {
  constexpr qreal kBetween = 3.0;  // digits do not reach below their line
  return thinned(
      std::move(ticks), axis, length,
      [room = letters.capHeight() + kBetween](const AxisTick&, const AxisTick&) { return room; });
}

}  // namespace adore::desktop
