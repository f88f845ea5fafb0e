#include "life/reference_speed.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "bearing/rating_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::life {
namespace {

/// nu n below which the oil torque is constant [mm^2/s rpm].
constexpr double kConstantTorqueLimit = 2000.0;

/// Root x > 0 of a x^5 + b x^3 = c: convex and increasing, Newton from above.
double solve(double a, double b, double c) {
  double x =
      std::min(a > 0.0 ? std::pow(c / a, 0.2) : HUGE_VAL, b > 0.0 ? std::cbrt(c / b) : HUGE_VAL);
  constexpr int kSteps = 60;
  for (int k = 0; k < kSteps; ++k) {
    const double x2 = x * x;
    const double step = (a * x2 * x2 * x + b * x2 * x - c) / (5.0 * a * x2 * x2 + 3.0 * b * x2);
    x -= step;
    if (std::abs(step) <= 1e-14 * x) break;
  }
  return x;
}

}  // namespace

FrictionFactors reference_friction_factors(std::string_view series) {
  const double share = bearing::rating_data("reference_conditions").at("radial").at("load_share");
  std::string known;
  for (const auto& row : bearing::rating_data("friction_factors").at("rows")) {
    const auto& name = row.at("series").get_ref<const std::string&>();
    if (name == series)
      return {row.at("f0r"), row.at("f1_factor").get<double>() *
                                 std::pow(share, row.at("f1_exponent").get<double>())};
    known += (known.empty() ? "" : ", ") + name;
  }
  throw InputError(fmt::format(
      "series {}: no friction factors are known. Enter one of {}, or enter f0r and f1r.", series,
      known));
}

ReferenceSpeed reference_speed(const ReferenceBearing& b) {
  const auto require = [](bool met, const char* text) {
    if (!met) throw InputError(text);
  };
  require(b.bore > 0.0 && b.outside > b.bore,
          "bore and outside diameter: the bore must be above 0 and below the outside diameter. "
          "Enter both.");
  require(b.thrust_roller || b.width > 0.0,
          "width: it must be above 0. Enter the width (tapered bearings: the total width).");
  require(b.static_rating > 0.0, "C0: it must be above 0. Enter the static rating in N.");
  require(
      b.friction.f0r > 0.0 && b.friction.f1r >= 0.0,
      "f0r must be above 0, and f1r must be 0 or more. Enter both values, or enter the series.");
  const auto& conditions = bearing::rating_data("reference_conditions");
  const auto& kind = conditions.at(b.thrust_roller ? "thrust" : "radial");
  const double nu = kind.at("viscosity_mm2_s"), seat = conditions.at("seat_mm2");
  const double d = 1e3 * b.bore, D = 1e3 * b.outside, dm = 0.5 * (d + D);
  const double area = b.thrust_roller ? 0.5 * kPi * (D * D - d * d) : kPi * 1e3 * b.width * (D + d);
  const double flow =
      kind.at("heat_flow_W_mm2").get<double>() *
      (area > seat ? std::pow(area / seat, kind.at("exponent").get<double>()) : 1.0);
  ReferenceSpeed out;
  out.load = kind.at("load_share").get<double>() * b.static_rating;
  const double M1 = b.friction.f1r * out.load * dm;
  const double per_speed = kPi / 30e3;  // W per N mm and rpm
  const double oil = 1e-7 * b.friction.f0r * dm * dm * dm;
  double n =
      std::pow(solve(per_speed * oil * std::pow(nu, 2.0 / 3.0), per_speed * M1, flow * area), 3.0);
  if (nu * n < kConstantTorqueLimit) n = flow * area / (per_speed * (160.0 * oil + M1));
  const double M0 =
      oil * std::max(std::pow(nu * n, 2.0 / 3.0), nu * n < kConstantTorqueLimit ? 160.0 : 0.0);
  out.speed = n;
  out.seat_area = 1e-6 * area;
  out.heat_flow = 1e6 * flow;
  out.heat = flow * area;
  out.load_torque = 1e-3 * M1;
  out.oil_torque = 1e-3 * M0;
  return out;
}

}  // namespace adore::life
