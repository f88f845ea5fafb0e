#include "contact/wavy_groove_model.hpp"

#include "base/chebyshev.hpp"
#include "bearing/given_surface.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/race_errors.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace adore::contact {
namespace {

/// K, a and b at one approach over those of the nominal curvature; E* cancels.
std::array<double, 3> ratios(const HertzConstants& here, const HertzConstants& nominal) {
  const double K = here.K / nominal.K, root = std::cbrt(K);
  return {K, here.a_hat / nominal.a_hat * root, here.b_hat / nominal.b_hat * root};
}

}  // namespace

HertzConstantRatios<double> ratios_with_ball_growth(const bearing::BallGeometry& balls,
                                                    double growth, int race,
                                                    const bearing::RaceErrors& errors,
                                                    double angle) {
  HertzConstantRatios<double> out;
  const double amplitude = errors.curvature_amplitude();
  if (amplitude == 0.0) return out;
  constexpr std::size_t kPoints = 24;
  const auto constants = [&](double change) {
    bearing::BallGeometry here = balls;
    here.groove_factor[static_cast<std::size_t>(race)] += change;
    return hertz_constants(race_curvature(geometry_with_ball_growth(here, growth), race, angle),
                           1.0);
  };
  const HertzConstants nominal = constants(0.0);
  std::array<std::vector<double>, 3> values;
  for (const double w : chebyshev_points(kPoints)) {
    const auto at = ratios(constants(w * amplitude), nominal);
    for (std::size_t q = 0; q < 3; ++q) values[q].push_back(at[q]);
  }
  double* const targets[] = {out.stiffness, out.major, out.minor};
  for (std::size_t q = 0; q < 3; ++q) {
    std::vector<double> series = chebyshev_coefficients(values[q]);
    series.resize(HertzConstantRatios<double>::kTerms, 0.0);
    const std::vector<double> powers = chebyshev_to_monomial(series);
    // The nominal groove has the ratio 1.
    for (std::size_t k = 0; k < powers.size(); ++k) targets[q][k] = powers[k] / powers[0];
  }
  return out;
}

WavyGroove make_wavy_groove(const bearing::BallGeometry& balls, int race,
                            const bearing::RaceErrors& errors, double fixed_angle) {
  const auto j = static_cast<std::size_t>(race);
  const double sign = race == bearing::kOuter ? 1.0 : -1.0;
  const GrooveGeometry groove = groove_geometry(balls);
  check_integer_wave_counts(errors);
  WavyGroove out;
  const bearing::SurfaceTable* const t = bearing::table_of(errors.given.get());
  if (t == nullptr)
    out.form =
        make_race_error_model(errors, groove.centre_radius[j] + sign * groove.groove_radius[j]);
  else
    out.table = {t->height.data(),
                 t->factor.empty() ? nullptr : t->factor.data(),
                 t->around,
                 t->across,
                 t->first,
                 t->step,
                 sign};
  out.curvature_diameter = balls.diameter;
  out.normal_x = sign * std::sin(balls.contact_angle);
  out.normal_r = sign * std::cos(balls.contact_angle);
  const double amplitude = errors.curvature_amplitude();
  if (amplitude == 0.0) return out;
  out.varying = true;
  out.per_factor = 1.0 / amplitude;
  out.ratios = ratios_with_ball_growth(balls, 0.0, race, errors, fixed_angle);
  return out;
}

}  // namespace adore::contact
