#include "bearing/size_limits.hpp"

#include "base/errors.hpp"
#include "bearing/rating_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace adore::bearing {
namespace {

using Json = nlohmann::json;

// Steps of sizes [mm]; r and s have finer ones.
constexpr std::array kSteps = {3.0,   6.0,   10.0,  18.0,  30.0,  50.0,  80.0, 120.0,
                               180.0, 250.0, 315.0, 400.0, 500.0, 630.0, 800.0};
constexpr std::array kFineSteps = {3.0,   6.0,   10.0,  14.0,  18.0,  24.0,  30.0,  40.0,  50.0,
                                   65.0,  80.0,  100.0, 120.0, 140.0, 160.0, 180.0, 200.0, 225.0,
                                   250.0, 280.0, 315.0, 355.0, 400.0, 450.0, 500.0};
constexpr double kLargestSmall = 500.0;  ///< formulas of i up to here [mm]

/// Rounded to the nearest step of the tables [um].
double rounded(double value) {
  const double step = value < 100.0 ? 1.0 : value < 200.0 ? 5.0 : 10.0;
  return step * std::floor(value / step + 0.5);
}
double whole(double value) { return std::floor(value + 0.5); }

struct Step {
  double over = 0.0, to = 0.0;  ///< [mm]
  [[nodiscard]] double mean() const { return std::sqrt(over * to); }
};

template <std::size_t N>
Step step_of(const std::array<double, N>& steps, double size) {
  for (std::size_t k = 1; k < N; ++k)
    if (size > steps[k - 1] && size <= steps[k] + 1e-9) return {steps[k - 1], steps[k]};
  throw InputError(fmt::format(
      "size {:.6g} mm: outside the available range of ISO 286. Enter a size above {:g} mm "
      "and up to {:g} mm.",
      size, steps.front(), steps.back()));
}

/// Value of the row that begins at `over`; empty: none.
std::optional<double> listed(const Json& rows, double over) {
  for (const Json& row : rows)
    if (row.at(0).get<double>() == over) return row.at(1).get<double>();
  return std::nullopt;
}

double grade_micrometers(int grade, double size) {
  constexpr std::array<double, 7> kFactors = {7.0, 10.0, 16.0, 25.0, 40.0, 64.0, 100.0};
  if (grade < 1 || grade > 11)
    throw InputError(
        fmt::format("tolerance grade {}: not available. Enter a grade from 1 to 11.", grade));
  const Step step = step_of(kSteps, size);
  for (const Json& row : rating_data("size_limits").at("grade_exceptions"))
    if (row.at(0) == grade && row.at(1).get<double>() == step.over) return row.at(2).get<double>();
  const double D = step.mean();
  const double i = step.to <= kLargestSmall ? 0.45 * std::cbrt(D) + 0.001 * D : 0.004 * D + 2.1;
  if (grade >= 5) return rounded(kFactors.at(static_cast<std::size_t>(grade - 5)) * i);
  const double first = 0.8 + 0.02 * D;
  return whole(first * std::pow(kFactors[0] * i / first, 0.25 * (grade - 1)));
}

/// IT7 + 0 to 5.
double p_position(double size) {
  const double more =
      listed(rating_data("size_limits").at("p_above_IT7"), step_of(kSteps, size).over)
          .value_or(0.0);
  return grade_micrometers(7, size) + more;
}

double s_position(double size) {
  const Step step = step_of(kSteps, size);
  if (const auto more = listed(rating_data("size_limits").at("s_above_IT8"), step.over))
    return grade_micrometers(8, size) + *more;
  return grade_micrometers(7, size) + 0.4 * step_of(kFineSteps, size).mean();
}

/// Limit of a shaft next to the zero line: the upper one of d to h, the lower one of k to s [um].
double shaft_position(char letter, int grade, double size) {
  const Step step = step_of(kSteps, size);
  const double D = step.mean();
  switch (letter) {
    case 'd':
      return -whole(16.0 * std::pow(D, 0.44));
    case 'e':
      return -whole(11.0 * std::pow(D, 0.41));
    case 'f':
      return -whole(5.5 * std::pow(D, 0.41));
    case 'g':
      return -whole(2.5 * std::pow(D, 0.34));
    case 'k':
      return grade >= 4 && grade <= 7 ? whole(0.6 * std::cbrt(D)) : 0.0;
    case 'm':
      return grade_micrometers(7, size) - grade_micrometers(6, size);
    case 'n':
      return listed(rating_data("size_limits").at("n_exceptions"), step.over)
          .value_or(whole(5.0 * std::pow(D, 0.34)));
    case 'p':
      return p_position(size);
    case 'r':
      return whole(std::sqrt(p_position(size) * s_position(size)));
    case 's':
      return whole(s_position(size));
    default:
      return 0.0;
  }
}

SizeLimits limits(double lower, double tolerance) {
  constexpr double kMicrometer = 1e-6;
  return {lower * kMicrometer, (lower + tolerance) * kMicrometer};
}

[[noreturn]] void refuse(std::string_view code, const std::string& why) {
  throw InputError(fmt::format(
      "tolerance class {}: {}. Enter a shaft class (d to h, j5, j6, js, k, m, n, p, r or s) or a "
      "hole class (D to H, J6, J7, JS, K, M, N or P) with its grade, such as k6 or H7.",
      code, why));
}

/// j and J, from their tables.
SizeLimits tabulated(std::string_view code, bool hole, int grade, double size) {
  const Json& data = rating_data("size_limits");
  const double tolerance = grade_micrometers(grade, size);
  const std::string name = hole                       ? fmt::format("J{}_upper", grade)
                           : grade == 5 || grade == 6 ? std::string("j5_j6_lower")
                                                      : std::string();
  const std::optional<double> value =
      data.contains(name) ? listed(data.at(name), step_of(kSteps, size).over) : std::nullopt;
  if (!value) refuse(code, "not available for this grade and size");
  return limits(hole ? *value - tolerance : *value, tolerance);
}

}  // namespace

double grade_tolerance(int grade, double nominal) {
  return 1e-6 * grade_micrometers(grade, 1e3 * nominal);
}

SizeLimits size_limits(std::string_view tolerance_class, double nominal) {
  const std::size_t digit = tolerance_class.find_first_of("0123456789");
  int grade = 0;
  if (digit == std::string_view::npos || digit == 0)
    refuse(tolerance_class, "not a tolerance class");
  const std::string_view number = tolerance_class.substr(digit);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), grade);
  if (error != std::errc() || end != number.data() + number.size())
    refuse(tolerance_class, "not a tolerance class");
  const std::string letters(tolerance_class.substr(0, digit));
  const bool hole = std::isupper(static_cast<unsigned char>(letters[0])) != 0;
  std::string shaft;
  for (const char c : letters) {
    if ((std::isupper(static_cast<unsigned char>(c)) != 0) != hole)
      refuse(tolerance_class, "mixes upper and lower case");
    shaft += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const double size = 1e3 * nominal;
  const double tolerance = grade_micrometers(grade, size);
  if (shaft == "js") return limits(-0.5 * tolerance, tolerance);
  if (shaft == "j") return tabulated(tolerance_class, hole, grade, size);
  static constexpr std::string_view kLetters = "defghkmnprs";
  if (shaft.size() != 1 || kLetters.find(shaft[0]) == std::string_view::npos ||
      (hole && (shaft[0] == 'r' || shaft[0] == 's')))
    refuse(tolerance_class, "not available");
  if (size > kLargestSmall && shaft[0] > 'h')
    refuse(tolerance_class,
           "not available above 500 mm; only classes d to h, js, D to H and JS are available up to "
           "800 mm");
  if (shaft[0] <= 'h') {
    const double position = shaft_position(shaft[0], grade, size);
    return hole ? limits(-position, tolerance) : limits(position - tolerance, tolerance);
  }
  if (!hole) return limits(shaft_position(shaft[0], grade, size), tolerance);
  // Holes of fits with equal interference to the shaft basis: K, M, N up to grade 8, P up to 7.
  const bool raised = grade >= 4 && grade <= (shaft[0] == 'p' ? 7 : 8);
  if (shaft[0] == 'k' && !raised) refuse(tolerance_class, "not available for this grade");
  const double upper = -shaft_position(shaft[0], shaft[0] == 'k' ? 6 : grade, size) +
                       (raised ? tolerance - grade_micrometers(grade - 1, size) : 0.0);
  return limits(upper - tolerance, tolerance);
}

}  // namespace adore::bearing
