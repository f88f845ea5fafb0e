#pragma once

#include <string>
#include <string_view>

/// Axes that read well: round tick values, SI prefixes or powers of ten instead of long numbers,
/// and a base value taken out when a signal hardly moves. No Qt in here.
namespace adore::desktop {

/// shown = (value - offset) / factor; min, max and step are in shown numbers.
struct AxisScale {
  double factor = 1.0;
  double offset = 0.0;
  double min = 0.0, max = 1.0, step = 0.2;
  int decimals = 1;
  std::string unit;  ///< to be shown in brackets: "µm", "10³ rpm/s"; empty for a plain number
  std::string offset_text;  ///< "from 35.12 mm" when an offset was taken out, else empty

  [[nodiscard]] double shown(double value) const { return (value - offset) / factor; }
};

/// Numbers beyond have no place on an axis: sums and differences of them overflow.
inline constexpr double kLargestDrawable = 1e290;
/// False for NaN too.
bool is_drawable(double value);

/// The largest of 1, 2, 5 times a power of ten that divides `span` into at least `parts` parts.
double nice_step(double span, int parts);

/// Scale whose range [min, max] is the data's range rounded outwards to ticks. `unit` is a unit
/// string of the result files
/// ("m/s^2", "N.m", ""). `parts` is the number of intervals to aim for. Non-finite limits count as
/// the range 0 to 1.
AxisScale value_axis(double low, double high, std::string_view unit, int parts);

/// Scale whose range is exactly the data's range (an abscissa); ticks are multiples of `step`.
AxisScale tight_axis(double low, double high, std::string_view unit, int parts);

/// "−0.40": fixed decimals, a true minus sign, no negative zero.
std::string tick_text(double value, int decimals);

/// "m/s^2" -> "m/s²", "N.m" -> "N·m"; anything else stays.
std::string pretty_unit(std::string_view unit);

/// A number for people: `digits` significant digits, no exponent between 1e-3 and 1e6, a true minus
/// sign.
std::string pretty_number(double value, int digits = 4);

/// Number and unit with an SI prefix where the unit takes one: 3.2e-6, "m" -> "3.2 µm".
std::string pretty_quantity(double value, std::string_view unit, int digits = 4);

}  // namespace adore::desktop
