#include "contact/wavy_groove_model.hpp"

#include "base/errors.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/race_errors.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace adore::contact {
namespace {

/// K, a and b at one approach over those of the nominal curvature; E* cancels.
std::array<double, 3> ratios(const HertzConstants& here, const HertzConstants& nominal) {
  const double K = here.K / nominal.K, root = std::cbrt(K);
  return {K, here.a_hat / nominal.a_hat * root, here.b_hat / nominal.b_hat * root};
}

void fit_constants(const bearing::BallGeometry& balls, int race, double amplitude, double angle,
                   WavyGroove& out) {
  constexpr int n = WavyGroove::kTerms;
  const auto constants = [&](double change) {
    bearing::BallGeometry here = balls;
    here.groove_factor[static_cast<std::size_t>(race)] += change;
    return hertz_constants(race_curvature(here, race, angle), 1.0);
  };
  const HertzConstants nominal = constants(0.0);
  Eigen::Matrix<double, n, n> powers;
  Eigen::Matrix<double, n, 3> values;
  for (int i = 0; i < n; ++i) {
    // One point at 0, so that the nominal groove has the ratios 1 exactly.
    const double w = i == 0 ? 0.0 : std::cos(std::numbers::pi * (i - 0.5) / (n - 1));
    for (int k = 0; k < n; ++k) powers(i, k) = std::pow(w, k);
    const auto at = ratios(constants(w * amplitude), nominal);
    for (int q = 0; q < 3; ++q) values(i, q) = at[static_cast<std::size_t>(q)];
  }
  const Eigen::Matrix<double, n, 3> c = powers.fullPivLu().solve(values);
  for (int k = 0; k < n; ++k) {
    out.stiffness[k] = c(k, 0);
    out.major[k] = c(k, 1);
    out.minor[k] = c(k, 2);
  }
}

}  // namespace

WavyGroove make_wavy_groove(const bearing::BallGeometry& balls, int race,
                            const bearing::RaceErrors& errors, double fixed_angle) {
  const auto j = static_cast<std::size_t>(race);
  const double sign = race == bearing::kOuter ? 1.0 : -1.0;
  const GrooveGeometry groove = groove_geometry(balls);
  check_whole_waves(errors);
  WavyGroove out;
  out.form = race_form(errors, groove.centre_radius[j] + sign * groove.groove_radius[j]);
  out.curvature_diameter = balls.diameter;
  out.normal_x = sign * std::sin(balls.contact_angle);
  out.normal_r = sign * std::cos(balls.contact_angle);
  const double amplitude = std::abs(errors.curvature_factor.amplitude);
  if (amplitude == 0.0) return out;
  out.varying = true;
  out.per_factor = 1.0 / amplitude;
  fit_constants(balls, race, amplitude, fixed_angle, out);
  return out;
}

}  // namespace adore::contact
