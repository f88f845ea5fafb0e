#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::desktop {
namespace {

struct Prefix {
  int exponent;
  std::string_view symbol;
};
constexpr std::array<Prefix, 8> kPrefixes{
    {{-12, "p"}, {-9, "n"}, {-6, "µ"}, {-3, "m"}, {0, ""}, {3, "k"}, {6, "M"}, {9, "G"}}};

/// Largest exponent of the prefix of a unit: "km" and "ks" are not used for bearings.
int largest_prefix(std::string_view unit) {
  if (unit == "m" || unit == "s" || unit == "m/s") return 0;
  return 9;
}

bool takes_prefix(std::string_view unit) {
  constexpr std::array<std::string_view, 8> units{"m", "s", "m/s", "N", "N.m", "W", "Pa", "Hz"};
  return std::find(units.begin(), units.end(), unit) != units.end();
}

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number))
    text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  return text;
}

struct Multiple {
  double factor = 1.0;
  std::string unit;
};

/// Factor and unit text that scale `size` to 1..1000, by prefix if the unit has one, else by a
/// power of ten if the plain number would be long.
Multiple multiple_for(double size, std::string_view unit) {
  Multiple multiple{1.0, pretty_unit(unit)};
  if (!(size > 0.0)) return multiple;
  // The nudge keeps 1000 - rounding error from being shown as 1000 of the smaller unit.
  int exponent = 3 * static_cast<int>(std::floor(std::log10(size * (1.0 + 1e-9)) / 3.0));
  if (takes_prefix(unit)) {
    const int limited = std::clamp(exponent, -12, largest_prefix(unit));
    if (exponent >= -12) {
      for (const auto& prefix : kPrefixes)
        if (prefix.exponent == limited) multiple.unit = std::string(prefix.symbol) + multiple.unit;
      multiple.factor = std::pow(10.0, limited);
      if (size / multiple.factor < 1e5) return multiple;
      multiple = {1.0, pretty_unit(unit)};
    }
  } else if (size < (unit == "hr" ? 1e7 : 1e5) && size >= 0.01) {
    return multiple;
  }
  if (exponent == 0) return multiple;
  multiple.factor = std::pow(10.0, exponent);
  multiple.unit = "10" + superscript(exponent) + (multiple.unit.empty() ? "" : " " + multiple.unit);
  return multiple;
}

int decimals_for(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
}

struct Limits {
  double low, high;
};

/// A drawable range: finite and not empty. Variations below 1e-6 of the magnitude are shown as
/// constant, because files have seven digits.
Limits drawable(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high) || low > high) return {0.0, 1.0};
  low = std::clamp(low, -kLargestDrawable, kLargestDrawable);
  high = std::clamp(high, -kLargestDrawable, kLargestDrawable);
  const double size = std::max(std::abs(low), std::abs(high));
  if (size < 1e-300) return {-1.0, 1.0};
  if (high - low > 1e-6 * size) return {low, high};
  const double middle = 0.5 * (low + high);
  return {middle - 0.05 * size, middle + 0.05 * size};
}

/// Units of positions: an offset shows their motion. Loads, powers, lives, temperatures and rates
/// keep their values.
bool is_position(std::string_view unit) {
  constexpr std::array<std::string_view, 5> kPositions{"m", "in", "deg", "s", "rev"};
  return std::find(kPositions.begin(), kPositions.end(), unit) != kPositions.end();
}

constexpr double kMinSpan = 2e-5;  ///< range over value of axes with at most seven digits

/// An axis without an offset, with numbers of at most seven digits.
Limits readable(const Limits& limits, std::string_view unit) {
  const double least = kMinSpan * std::max(std::abs(limits.low), std::abs(limits.high));
  if (is_position(unit) || limits.high - limits.low >= least) return limits;
  const double middle = 0.5 * (limits.low + limits.high);
  return {middle - 0.5 * least, middle + 0.5 * least};
}

constexpr double kOffsetBelow = 2e-3;  ///< range over value of positions that get an offset

/// @param offset_below range over value below which an offset is taken out
AxisScale scaled(const Limits& limits, std::string_view unit, int parts, double offset_below) {
  AxisScale axis;
  const double span = limits.high - limits.low;
  const double size = std::max(std::abs(limits.low), std::abs(limits.high));
  double shown_size = size;
  if (span < offset_below * size) {
    const double coarse = nice_step(span, 1);  // at most the range: it contains the base
    axis.offset = std::round(0.5 * (limits.low + limits.high) / coarse) * coarse;
    axis.offset_text = pretty_quantity(axis.offset, unit, 7);
    shown_size = std::max(std::abs(limits.low - axis.offset), std::abs(limits.high - axis.offset));
  }
  const Multiple multiple = multiple_for(shown_size, unit);
  axis.factor = multiple.factor;
  axis.unit = multiple.unit;
  axis.min = axis.shown(limits.low);
  axis.max = axis.shown(limits.high);
  axis.step = nice_step(axis.max - axis.min, parts);
  axis.decimals = decimals_for(axis.step);
  return axis;
}

}  // namespace

double min_axis_span(std::string_view unit) {
  struct Least {
    std::string_view unit;
    double span;
  };
  constexpr std::array<Least, 15> kLeast{{{"m", 1e-10},
                                          {"in", 4e-9},
                                          {"m/s", 1e-8},
                                          {"in/s", 4e-7},
                                          {"m/s^2", 1e-5},
                                          {"in/s^2", 4e-4},
                                          {"deg", 1e-6},
                                          {"rpm", 1e-6},
                                          {"rpm/s", 1e-3},
                                          {"N", 1e-6},
                                          {"lbf", 2e-7},
                                          {"N.m", 1e-9},
                                          {"lbf.in", 1e-8},
                                          {"K", 1e-3},
                                          {"R", 1e-3}}};
  for (const Least& least : kLeast)
    if (least.unit == unit) return least.span;
  return 0.0;
}

double nice_step(double span, int parts) {
  const double raw = span / std::max(parts, 1);
  if (!(raw > 0.0) || !std::isfinite(raw)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * power <= raw * (1.0 + 1e-9)) return digit * power;
  return power;
}

AxisScale value_axis(double low, double high, std::string_view unit, int parts) {
  AxisScale axis = scaled(readable(drawable(low, high), unit), unit, parts,
                          is_position(unit) ? kOffsetBelow : 0.0);
  const double data_min = axis.min, data_max = axis.max;
  const auto round_out = [&] {
    // Rounding errors must not add an empty tick interval.
    axis.min = axis.step * std::floor(data_min / axis.step + 1e-6);
    axis.max = axis.step * std::ceil(data_max / axis.step - 1e-6);
  };
  round_out();
  if (axis.max - axis.min > (parts + 1.5) * axis.step) {
    axis.step = nice_step(data_max - data_min, std::max(1, parts / 2));
    axis.decimals = decimals_for(axis.step);
    round_out();
  }
  // A part of the axis with almost no values is not useful: a gap of -2 µm needs no -100 µm.
  constexpr double kLittle = 0.15;
  const double second = axis.min + axis.step, second_last = axis.max - axis.step;
  if (data_min < second && second - data_min < kLittle * axis.step &&
      second < second_last + 0.5 * axis.step)
    axis.min = data_min;
  if (data_max > second_last && data_max - second_last < kLittle * axis.step &&
      axis.min < second_last - 0.5 * axis.step)
    axis.max = data_max;
  // A margin between lines and the frame, so that they are completely visible.
  const double air = 0.03 * (axis.max - axis.min);
  if (data_min < axis.min + air) axis.min -= air;
  if (data_max > axis.max - air) axis.max += air;
  return axis;
}

AxisScale tight_axis(double low, double high, std::string_view unit, int parts) {
  // The exact range: enlarged values of other units get an offset when they need eight digits.
  return scaled(drawable(low, high), unit, parts, is_position(unit) ? kOffsetBelow : kMinSpan);
}

void take_common_unit(AxisScale& axis, const std::vector<AxisScale>& all) {
  constexpr double kLong = 1e4, kThousand = 1e3;
  double largest = 0.0, common = 0.0;
  for (const AxisScale& one : all) {
    const double size = std::max(std::abs(one.min), std::abs(one.max)) * one.factor;
    if (one.log || one.offset != 0.0 || !(size > largest)) continue;
    largest = size;
    common = one.factor;
  }
  const auto is = [](double factor, double of) { return std::abs(factor - of) < 1e-6 * of; };
  const bool smaller = std::any_of(all.begin(), all.end(), [&](const AxisScale& one) {
    return one.offset == 0.0 && one.factor < 0.5 * common;
  });
  if (smaller && largest / (common / kThousand) < kLong) common /= kThousand;
  const auto named = std::find_if(all.begin(), all.end(),
                                  [&](const AxisScale& one) { return is(one.factor, common); });
  const double ratio = axis.factor / common;
  if (axis.log || axis.offset != 0.0 || named == all.end() ||
      (!is(ratio, kThousand) && !is(ratio, 1.0 / kThousand)))
    return;
  axis.factor = common;
  axis.unit = named->unit;
  axis.min *= ratio;
  axis.max *= ratio;
  axis.step *= ratio;
  axis.decimals = decimals_for(axis.step);
}

namespace {

/// The prefix for a range of decades with few digits: 10 kHz and more instead of 10000 Hz, unless
/// small numbers get too long then.
Multiple multiple_of_decades(double low, double high, std::string_view unit) {
  constexpr double kLong = 1e4, kShortest = 9e-4;
  Multiple out{1.0, pretty_unit(unit)};
  if (!takes_prefix(unit) || high < kLong * (1.0 - 1e-9)) return out;
  const Multiple scaled = multiple_for(high, unit);
  return low / scaled.factor < kShortest ? out : scaled;
}

}  // namespace

AxisScale log_axis(double low, double high, std::string_view unit, bool tight, double room) {
  constexpr double kSmallest = 1e-300, kMostDecades = 40.0;
  if (!(high > kSmallest) || !std::isfinite(high)) low = 1.0, high = 10.0;
  low = std::max({std::isfinite(low) && low > 0.0 ? low : 0.0, kSmallest,
                  high * std::pow(10.0, -kMostDecades)});
  AxisScale axis;
  axis.log = true;
  const Multiple multiple = multiple_of_decades(low, high, unit);
  axis.factor = multiple.factor;
  axis.unit = multiple.unit;
  axis.min = axis.shown(low);
  axis.max = axis.shown(high);
  if (!tight || !(axis.max - axis.min > 1e-6)) {
    axis.min = std::floor(axis.min + 1e-9);
    axis.max = std::ceil(axis.max - 1e-9);
    if (axis.max - axis.min < 1.0) axis.max = axis.min + 1.0;
  }
  const double decades = axis.max - axis.min;
  axis.step = std::max(1.0, std::ceil(decades / 10.0));
  axis.decimals = 0;
  constexpr double kFew = 2.5, kNarrowest = 0.301;  // from 1 to 2 [decades]
  axis.between = decades < kFew || (axis.step == 1.0 && decades <= kNarrowest * room);
  return axis;
}

std::vector<AxisTick> axis_ticks(const AxisScale& axis) {
  constexpr std::size_t kMostTicks = 200;
  std::vector<AxisTick> out;
  const double slack = 1e-6 * axis.step;
  const auto add = [&](double at, std::string text) {
    if (at >= axis.min - slack && at <= axis.max + slack && out.size() < kMostTicks)
      out.push_back({at, std::move(text)});
  };
  if (!axis.log) {
    for (double k = std::ceil((axis.min - slack) / axis.step);
         k * axis.step <= axis.max + slack && out.size() < kMostTicks; ++k)
      add(k * axis.step, tick_text(k * axis.step, axis.decimals));
    return out;
  }
  const bool plain = axis.min > -3.5 && axis.max < 5.5;
  for (double decade = axis.step * std::floor(axis.min / axis.step); decade <= axis.max + slack;
       decade += axis.step)
    for (const int digit : {1, 2, 5}) {
      if (digit > 1 && !axis.between) continue;
      const double value = digit * std::pow(10.0, decade);
      add(std::log10(value),
          plain        ? pretty_number(value, 3)
          : digit == 1 ? "10" + superscript(static_cast<int>(std::lround(decade)))
                       : fmt::format("{}·10{}", digit, superscript(static_cast<int>(decade))));
    }
  return out;
}

std::string tick_text(double value, int decimals) {
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "−" : "") + digits;
}

std::string pretty_unit(std::string_view unit) {
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == '^' && i + 1 < unit.size() && (unit[i + 1] == '2' || unit[i + 1] == '3'))
      text += unit[++i] == '2' ? "²" : "³";
    else if (unit[i] == '.')
      text += "·";
    else
      text += unit[i];
  }
  return text;
}

std::string pretty_number(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const double size = std::abs(value);
  const std::string sign = value < 0 ? "−" : "";
  if (size == 0.0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  if (size >= 1e-3 && size < 1e6) {
    // Whole numbers keep all their digits; zeros at the end of a fraction go.
    std::string text = fmt::format("{:.{}f}", size, std::max(0, digits - 1 - exponent));
    if (text.find('.') != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
    return sign + text;
  }
  return sign + fmt::format("{:.{}g}", size / std::pow(10.0, exponent), digits) + "·10" +
         superscript(exponent);
}

std::string pretty_quantity(double value, std::string_view unit, int digits) {
  if (!takes_prefix(unit) || value == 0.0 || !std::isfinite(value)) {
    const std::string name = pretty_unit(unit);
    return pretty_number(value, digits) + (name.empty() ? "" : " " + name);
  }
  const Multiple multiple = multiple_for(std::abs(value), unit);
  return pretty_number(value / multiple.factor, digits) + " " + multiple.unit;
}

}  // namespace adore::desktop
