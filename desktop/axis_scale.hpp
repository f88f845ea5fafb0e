#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// Readable axes: round tick values, SI prefixes or powers of ten instead of long numbers, and an
/// offset for nearly constant signals. No Qt.
namespace adore::desktop {

/// shown = (value - offset) / factor; min, max and step are in shown numbers.
struct AxisScale {
  double factor = 1.0;
  double offset = 0.0;
  double min = 0.0, max = 1.0, step = 0.2;
  int decimals = 1;
  std::string unit;  ///< to be shown in brackets: "µm", "10³ rpm/s"; empty for a plain number
  std::string offset_text;  ///< "35.12 mm" if this offset was removed from the numbers, else empty

  bool log = false;      ///< shown = log10(value / factor): one decade per shown unit
  bool between = false;  ///< of a logarithmic one: 2 and 5 times each power of ten are ticks, too

  [[nodiscard]] double shown(double value) const {
    return log ? std::log10(value / factor) : (value - offset) / factor;
  }
  [[nodiscard]] double value(double at) const {
    return log ? std::pow(10.0, at) * factor : at * factor + offset;
  }
};

/// A tick in shown numbers and its text.
struct AxisTick {
  double at = 0.0;
  std::string text;
};
/// Of the whole range, at most 200.
[[nodiscard]] std::vector<AxisTick> axis_ticks(const AxisScale& axis);

/// Larger numbers cannot be shown on an axis: sums and differences of them overflow.
inline constexpr double kLargestDrawable = 1e290;
/// False for NaN too.
inline bool is_drawable(double value) { return std::abs(value) <= kLargestDrawable; }

/// Valid range of values of an axis.
struct Extent {
  double low = std::numeric_limits<double>::infinity(),
         high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    if (!is_drawable(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(const Extent& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  [[nodiscard]] bool empty() const { return low > high; }
};

/// Smallest range of an axis for a unit of the result files: smaller changes are rounding. A
/// ten-billionth of a meter is the size of an atom; 0 for a unit without such a limit.
double min_axis_span(std::string_view unit);

/// The largest of 1, 2, 5 times a power of ten that divides `span` into at least `parts` parts.
double nice_step(double span, int parts);

/// Scale whose range [min, max] is the data's range rounded outward to ticks. `unit` is a unit
/// string of the result files
/// ("m/s^2", "N.m", ""). Nearly constant positions (m, in, deg, s, rev) get an offset; loads,
/// powers, lives and all others keep their values. `parts` is the number of intervals to aim for.
/// Non-finite limits count as the range 0 to 1.
AxisScale value_axis(double low, double high, std::string_view unit, int parts);

/// Scale with exactly the range of the data (an abscissa); ticks are multiples of `step`.
AxisScale tight_axis(double low, double high, std::string_view unit, int parts);

/// Selects a common prefix of all axes of a unit on a page: that of the largest numbers, or the
/// next smaller one if a smaller one occurs and no number gets five digits before the point. Axes
/// with an offset, or more than a factor of 1000 away, keep theirs.
void take_common_unit(AxisScale& axis, const std::vector<AxisScale>& all);

/// Logarithmic scale over the positive part of the range: whole decades around it, or exactly the
/// range when `tight`. A range without positive numbers counts as 1 to 10. So many labels as `room`
/// fit one after the other: it decides which ticks there are.
AxisScale log_axis(double low, double high, std::string_view unit, bool tight = false,
                   double room = 0.0);

/// "−0.40": fixed decimals, a true minus sign, no negative zero.
std::string tick_text(double value, int decimals);

/// "m/s^2" -> "m/s²", "N.m" -> "N·m"; anything else stays.
std::string pretty_unit(std::string_view unit);

/// A formatted number: `digits` significant digits, no exponent between 1e-3 and 1e6, a true minus
/// sign.
std::string pretty_number(double value, int digits = 4);

/// Number and unit with an SI prefix if the unit has one: 3.2e-6, "m" -> "3.2 µm".
std::string pretty_quantity(double value, std::string_view unit, int digits = 4);

}  // namespace adore::desktop
