#pragma once

#include "base/constants.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "bearing/bearing.hpp"
#include "calculators/adapter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// Small conversions between JSON and the library's values, for the adapters of the reference
/// cases.
namespace adore::calculators {

inline constexpr double kRpm = kPi / 30.0;
inline constexpr std::array<const char*, 5> kDisplacement{"ux", "uy", "uz", "thy", "thz"};
inline constexpr std::array<const char*, 5> kLoad{"Fx", "Fy", "Fz", "My", "Mz"};

[[nodiscard]] inline Vec3 vec3(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}
[[nodiscard]] inline Vec3 vec3_or_zero(const Json& inputs, const char* key) {
  return inputs.contains(key) ? vec3(inputs[key]) : Vec3::Zero();
}
[[nodiscard]] inline Json json(const Vec3& v) { return Json::array({v[0], v[1], v[2]}); }
[[nodiscard]] inline Json json(const Quat& q) { return Json::array({q[0], q[1], q[2], q[3]}); }
[[nodiscard]] inline Json json(const Mat3& m) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(json(Vec3(m.row(i))));
  return rows;
}
[[nodiscard]] inline Quat quaternion(const Json& j) {
  return normalize_quaternion(
      {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>(), j.at(3).get<double>()});
}
[[nodiscard]] inline double get(const Json& inputs, const char* key) {
  return inputs.at(key).get<double>();
}

/// Limits of counts, those of the deck; every work and memory that follows from them stays bounded.
inline constexpr int kMostElements = 10'000, kMostSlices = 1'000;

/// A whole number within its range; no adapter reads an integer in another way. @throws InputError
[[nodiscard]] inline int whole(const Json& inputs, const char* key, int least, int most) {
  const Json& value = inputs.at(key);
  const double number = value.get<double>();
  if (!(number >= least) || !(number <= most) || number != std::round(number))
    throw InputError(
        fmt::format("{} is {}; give a whole number from {} to {}", key, value.dump(), least, most));
  return static_cast<int>(number);
}
[[nodiscard]] inline int whole_or(const Json& inputs, const char* key, int fallback, int least,
                                  int most) {
  return inputs.contains(key) ? whole(inputs, key, least, most) : fallback;
}
/// A condition between several inputs, which the schema of one input cannot state.
/// @throws InputError with the text
inline void require(bool condition, const std::string& text) {
  if (!condition) throw InputError(text);
}

/// Z elements of diameter D on the pitch diameter d_m touch when d_m sin(π/Z) = D.
inline void require_elements_fit(int count, double diameter, double pitch_diameter) {
  const double chord = pitch_diameter * std::sin(kPi / std::max(count, 2));
  require(diameter <= chord * (1.0 + 1e-9),
          fmt::format("{} of diameter {:.4g} do not fit on the pitch diameter {:.4g}: the largest "
                      "possible element diameter is {:.4g}. Enter fewer or smaller elements",
                      counted(count, "element"), diameter, pitch_diameter, chord));
}
[[nodiscard]] inline std::string kind_of(const Json& the_case) {
  return the_case.value("kind", std::string());
}
/// The case's kind or, if it has none, that of its inputs.
[[nodiscard]] inline std::string kind(const Json& the_case) {
  const std::string own = kind_of(the_case);
  return own.empty() ? the_case.at("inputs").value("kind", std::string()) : own;
}

/// κ(u) of the dynamics families: {"type": "two_slope" or "exponential", A, B, C, um or D}.
[[nodiscard]] inline bearing::TractionCurve traction_law(const Json& law) {
  bearing::TractionCurve curve;
  const bool two_slope = law.at("type") == "two_slope";
  curve.form = two_slope ? bearing::TractionCurve::Form::TwoSlope
                         : bearing::TractionCurve::Form::Exponential;
  curve.A = get(law, "A");
  curve.B = get(law, "B");
  curve.C = get(law, "C");
  (two_slope ? curve.u0 : curve.D) = get(law, two_slope ? "um" : "D");
  return curve;
}

}  // namespace adore::calculators
