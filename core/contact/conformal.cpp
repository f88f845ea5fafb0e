#include "contact/conformal.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

namespace adore::contact {

CappedHertz capped_hertz(double K, double a1, double ball_radius, double E_star, double cap_ratio) {
  if (!(ball_radius > 0.0) || !(E_star > 0.0) || !(cap_ratio > 0.0))
    throw InputError(fmt::format(
        "ball in pocket: ball radius {} m, contact modulus {} Pa and cap ratio {} must all "
        "be positive",
        ball_radius, E_star, cap_ratio));
  CappedHertz law;
  if (!std::isfinite(K) || !std::isfinite(a1)) {
    law.K = 0.0;
    law.slope_cap = 2.0 * E_star * cap_ratio * ball_radius;
    return law;
  }
  const double root = cap_ratio * ball_radius / a1;
  law.K = K;
  law.delta_cap = root * root;
  law.slope_cap = 1.5 * K * root;
  law.load_cap = K * root * root * root;
  return law;
}

PocketLaw ball_pocket_law(double E_star, double ball_diameter,
                          const std::array<double, 2>& wall_curvature, double cap_ratio) {
  if (!(ball_diameter > 0.0))
    throw InputError(
        fmt::format("ball in pocket: the ball diameter {} m must be positive", ball_diameter));
  const double ball = 2.0 / ball_diameter, least = 1e-6 * ball;
  const double c1 = std::max(ball + wall_curvature[0], least);
  const double c2 = std::max(ball + wall_curvature[1], least);
  PocketLaw result;
  result.E_star = E_star;
  result.hertz = hertz_constants({std::min(c1, c2), std::max(c1, c2)}, E_star);
  const double a1 = result.hertz.a_hat * std::cbrt(result.hertz.K);
  result.law = capped_hertz(result.hertz.K, a1, 0.5 * ball_diameter, E_star, cap_ratio);
  return result;
}

PocketLaw ball_pocket_law(const bearing::Material& ball, const bearing::Material& cage,
                          double ball_diameter, const std::array<double, 2>& wall_curvature,
                          double cap_ratio) {
  return ball_pocket_law(bearing::contact_modulus(ball, cage), ball_diameter, wall_curvature,
                         cap_ratio);
}

}  // namespace adore::contact
