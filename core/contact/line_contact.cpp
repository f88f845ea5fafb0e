#include "contact/line_contact.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "bearing/bearing.hpp"

#include <fmt/format.h>

namespace adore::contact {
namespace {

double compliance(const bearing::Material& m) {
  if (!(std::isfinite(m.elastic_modulus) && m.elastic_modulus > 0.0))
    throw InputError(
        fmt::format("line contact: an elastic modulus is {} Pa; it must be a positive number",
                    m.elastic_modulus));
  return (1.0 - m.poisson_ratio * m.poisson_ratio) / (kPi * m.elastic_modulus);
}

void require_load(double load, double length) {
  if (!(load > 0.0 && length > 0.0))
    throw InputError(
        fmt::format("line contact: load {} N and length {} m must both be positive", load, length));
}

/// δ = q (A - B ln q).
struct LogLine {
  double A, B;
};

LogLine log_line(const HalfSpaceLaw& law, double roller_radius, double race_curvature) {
  const double log_beta =
      std::log(4.0 / (kPi * law.E_star * (1.0 / roller_radius + race_curvature)));
  const double nu = law.race_poisson_ratio;
  return {law.roller_compliance * (2.0 * std::log(4.0 * roller_radius) - 1.0 - log_beta) +
              law.race_compliance * (2.0 * std::log(2.0 * law.depth) - nu / (1.0 - nu) - log_beta),
          law.roller_compliance + law.race_compliance};
}

}  // namespace

double approach_palmgren_steel(double load, double length) {
  require_load(load, length);
  return 1e-3 * 3.84e-5 * std::pow(load, 0.9) / std::pow(1e3 * length, 0.8);
}

double approach_palmgren(double load, double length, const bearing::Material& one,
                         const bearing::Material& two) {
  require_load(load, length);
  return 3.81 * std::pow((compliance(one) + compliance(two)) * load, 0.9) / std::pow(length, 0.8);
}

double approach_lundberg(double load, double length, const bearing::Material& both, double gamma,
                         int race) {
  require_load(load, length);
  const double g = load * (1.0 - both.poisson_ratio * both.poisson_ratio);
  const double side = race == bearing::kInner ? 1.0 - gamma : 1.0 + gamma;
  const double stiffness = kPi * both.elastic_modulus * length;
  return 2.0 * g / stiffness * std::log(stiffness * length / (g * side));
}

double approach_half_cylinder(double q, const bearing::Material& cylinder, double radius,
                              double half_width) {
  return q * compliance(cylinder) * (2.0 * std::log(4.0 * radius / half_width) - 1.0);
}

HalfSpaceLaw half_space_law(const bearing::Material& roller, const bearing::Material& race,
                            double depth) {
  if (!(std::isfinite(depth) && depth > 0.0))
    throw InputError(
        fmt::format("half-space law: the depth of the race is {} m; it must be positive (the "
                    "thickness of the ring)",
                    depth));
  HalfSpaceLaw law;
  law.roller_compliance = compliance(roller);
  law.race_compliance = compliance(race);
  law.E_star = bearing::contact_modulus(roller, race);
  law.depth = depth;
  law.race_poisson_ratio = race.poisson_ratio;
  return law;
}

double half_space_approach(const HalfSpaceLaw& law, double q, double roller_radius,
                           double race_curvature) noexcept {
  const auto [A, B] = log_line(law, roller_radius, race_curvature);
  const double last = A / B - 2.0;  // ln q where the tangent takes over
  const double x = std::log(q);
  if (x <= last) return q * (A - B * x);
  const double edge = std::exp(last);
  return B * (2.0 * edge + (q - edge));
}

SliceLoad slice_load(const HalfSpaceLaw& law, double width, double delta, double roller_radius,
                     double race_curvature) noexcept {
  if (delta <= 0.0 || width <= 0.0) return {};
  const auto [A, B] = log_line(law, roller_radius, race_curvature);
  const double last = A / B - 2.0, edge = std::exp(last);
  if (delta >= 2.0 * B * edge) return {width * (edge + delta / B - 2.0 * edge), width / B};
  // Any start up to `last` will do; the bracket is 15 to 30 times B in bearings.
  const double log_delta = std::log(delta);
  double x = std::min(log_delta - std::log(20.0 * B), last);
  for (int n = 0; n < 50; ++n) {
    const double bracket = A - B * x;
    const double step = (log_delta - x - std::log(bracket)) / (1.0 - B / bracket);
    x = std::min(x + step, last);
    if (std::abs(step) < 1e-15 * (1.0 + std::abs(x))) break;
  }
  const double q = std::exp(x);
  return {width * q, width / (A - B * x - B)};
}

}  // namespace adore::contact
