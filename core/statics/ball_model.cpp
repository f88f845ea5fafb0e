#include "statics/ball_model.hpp"

#include "base/chebyshev.hpp"
#include "base/errors.hpp"
#include "contact/make_angle_law.hpp"
#include "statics/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::statics {
namespace {

/// Nodes that resolve a function of c with its nearest singularity at 1/γ: coefficients fall like
/// ρ^-n, ρ = 1/γ + sqrt(1/γ² - 1).
std::size_t nodes_for(double gamma) {
  const double rho = 1.0 / gamma + std::sqrt(1.0 / (gamma * gamma) - 1.0);
  return static_cast<std::size_t>(std::clamp(34.0 / std::log(rho), 8.0, 64.0)) + 2;
}

void check_material(const bearing::Material& m, const char* part) {
  if (!(std::isfinite(m.elastic_modulus) && m.elastic_modulus > 0.0)) {
    throw InputError(fmt::format("{} material: the elastic modulus is {} Pa; it must be positive",
                                 part, m.elastic_modulus));
  }
  if (!(m.poisson_ratio >= 0.0 && m.poisson_ratio <= 0.5)) {
    throw InputError(fmt::format("{} material: Poisson's ratio is {}; it must be between 0 and 0.5",
                                 part, m.poisson_ratio));
  }
}

double prescribed_pitch_angle(double angle) {
  // A spin axis is a line: angles that differ by half a turn are the same.
  return angle - std::numbers::pi * std::ceil(angle / std::numbers::pi - 0.5);
}

/// Puts the bearing into a base frame that turns about an axis parallel to X (record 9.5).
/// @param field acceleration that a body at rest at the base origin feels there [m/s²]
void set_frame(BallModel& m, double speed, const Eigen::Vector3d& field) {
  m.frame_speed = speed;
  m.field = field;
  m.moving = m.moving || speed != 0.0;
  const double turning = m.base_orbital + speed;
  const auto set = [&](BallInGrooves& seat) {
    seat.base_centrifugal = seat.mass * 0.5 * m.balls.pitch_diameter * turning * turning;
    seat.window = 1e-3 * seat.base_centrifugal;
  };
  set(m);
  for (BallInGrooves& seat : m.own) set(seat);
}

}  // namespace

HertzSeries::HertzSeries(const bearing::BallGeometry& balls, int race, double E_star,
                         double reference_angle, Curvature curvature)
    : balls_(balls),
      race_(race),
      E_star_(E_star),
      varies_with_angle_(curvature == Curvature::Actual || curvature == Curvature::Potential) {
  reference_ =
      contact::hertz_constants(contact::race_curvature(balls, race, reference_angle), E_star);
  if (!varies_with_angle_) {
    return;
  }
  if (curvature == Curvature::Potential) {
    law_ = contact::make_angle_law(balls, race, E_star);
  }
  const std::size_t n = nodes_for(balls.diameter / balls.pitch_diameter);
  std::vector<double> log_K(n);
  std::vector<double> log_a(n);
  double kappa = reference_.kappa;
  for (std::size_t k = 0; k < n; ++k) {
    const double alpha = std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
    const auto h =
        contact::hertz_sensitivity(contact::race_curvature(balls, race, alpha), E_star, kappa)
            .constants;
    kappa = h.kappa;
    log_K[k] = std::log(h.K / reference_.K);
    log_a[k] = std::log(h.a_hat / reference_.a_hat);
  }
  log_K_ = series_with_derivative(chebyshev_coefficients(log_K));
  log_a_ = series_with_derivative(chebyshev_coefficients(log_a));
}

contact::HertzConstants HertzSeries::at(double alpha) const {
  return varies_with_angle_
             ? contact::hertz_constants(contact::race_curvature(balls_, race_, alpha), E_star_)
             : reference_;
}

/// d/dx Σ c_k T_k = Σ d_k T_k with d_(k-1) = d_(k+1) + 2 k c_k, d_0 halved [mason2003].
HertzSeries::Series HertzSeries::series_with_derivative(const std::vector<double>& coefficients) {
  const std::size_t n = coefficients.size();
  Series out(n, Eigen::Array2d::Zero());
  for (std::size_t k = n; k-- > 0;) {
    out[k](0) = coefficients[k];
    if (k > 0)
      out[k - 1](1) =
          (k + 1 < n ? out[k + 1](1) : 0.0) + 2.0 * static_cast<double>(k) * coefficients[k];
  }
  if (n > 0) out[0](1) *= 0.5;
  return out;
}

HertzSeries::Value HertzSeries::evaluate(const Series& series, double c) noexcept {
  if (series.empty()) {
    return {};
  }
  Eigen::Array2d b1 = Eigen::Array2d::Zero(), b2 = Eigen::Array2d::Zero();
  // One product and one sum wait for the last value, the rest is done before.
  const double twice = 2.0 * c;
  for (std::size_t k = series.size() - 1; k > 0; --k) {
    const Eigen::Array2d b = (series[k] - b2) + twice * b1;
    b2 = b1;
    b1 = b;
  }
  const Eigen::Array2d sum = series[0] + c * b1 - b2;
  return {sum(0), sum(1)};
}

SpinLaw first_spin_law(const bearing::Bearing& bearing, const BallStaticsOptions& options) {
  using Axis = SpinLaw::Axis;
  using Share = SpinLaw::Share;
  switch (options.control) {
    case Control::Outer:
      return {Axis::OuterControl, Share::Outer};
    case Control::Inner:
      return {Axis::InnerControl, Share::Equal};
    case Control::Equal:
      return {Axis::OuterControl, Share::Equal};
    case Control::None:
      return {Axis::OuterControl, Share::None};
    case Control::FromBearing:
      break;
  }
  switch (bearing.spin_rule) {
    case bearing::SpinRule::MinimumHeat:
      return {Axis::LeastHeat, Share::ByLoad};
    case bearing::SpinRule::Prescribed:
      return {Axis::Prescribed, Share::ByLoad};
    case bearing::SpinRule::RaceControl:
      break;
  }
  return {Axis::OuterControl, Share::Outer};
}

BallModel make_ball_model(const bearing::Bearing& bearing, const BallStaticsOptions& options) {
  if (bearing.element_count() < 1) {
    throw InputError(
        fmt::format("ball bearing: {} balls; there must be at least one", bearing.element_count()));
  }
  check_material(bearing.element_material, "ball");
  check_material(bearing.race_material[0], "outer race");
  check_material(bearing.race_material[1], "inner race");

  BallModel m;
  m.balls = bearing.balls();
  m.groove = contact::groove_geometry(bearing.balls());
  m.diameter = bearing.balls().diameter;
  m.gamma = bearing.balls().diameter / bearing.balls().pitch_diameter;
  m.mass = bearing.element_inertia.mass;
  m.inertia = bearing.element_inertia.moments.x();
  m.race_speed = bearing.speed;
  if (!(std::isfinite(m.mass) && m.mass >= 0.0 && std::isfinite(m.race_speed[0]) &&
        std::isfinite(m.race_speed[1]))) {
    throw InputError(
        fmt::format("ball bearing: the ball mass is {} kg, and the race speeds are {} and {} "
                    "rad/s. All must be finite numbers, and the mass must not be negative",
                    m.mass, m.race_speed[0], m.race_speed[1]));
  }
  m.moving = m.race_speed[0] != 0.0 || m.race_speed[1] != 0.0;
  m.per_ball_speeds = m.moving && options.orbit == Orbit::PerBall;
  m.exact = options.kinematics == RingKinematics::Exact;
  m.outer_tilt = bearing.constraints.outer_misalignment;
  m.outer_tilted = m.outer_tilt[0] != 0.0 || m.outer_tilt[1] != 0.0;
  m.spin_angle = prescribed_pitch_angle(bearing.spin_angle);

  for (std::size_t j = 0; j < 2; ++j) {
    m.half[j] = contact::split_race_halves(m.balls, m.groove, static_cast<int>(j));
    m.split = m.split || m.half[j][0].is_split();
  }
  const double free_angle = bearing.balls().contact_angle;
  for (std::size_t j = 0; j < 2; ++j) {
    const double E_star =
        bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
    const double angle =
        options.curvature == Curvature::Fixed ? options.fixed_angle[j] : free_angle;
    m.hertz[j] =
        HertzSeries(bearing.balls(), static_cast<int>(j), E_star, angle, options.curvature);
    const double f = bearing.balls().groove_factor[j];
    m.surface_radius[j] = 2.0 * f * bearing.balls().diameter / (2.0 * f + 1.0);
  }
  if (m.moving) {
    const double angle = options.orbit == Orbit::Nominal ? free_angle : 0.0;
    m.base_orbital =
        epicyclic_speeds(bearing.element_count(), bearing.balls().diameter,
                         bearing.balls().pitch_diameter, angle, m.race_speed[0], m.race_speed[1])
            .cage_speed;
    m.base_centrifugal =
        m.mass * 0.5 * bearing.balls().pitch_diameter * m.base_orbital * m.base_orbital;
    m.window = 1e-3 * m.base_centrifugal;
  }
  m.azimuth.resize(static_cast<std::size_t>(bearing.element_count()));
  for (int k = 0; k < bearing.element_count(); ++k) {
    m.azimuth[static_cast<std::size_t>(k)] =
        options.first_azimuth + 2.0 * std::numbers::pi * k / bearing.element_count();
  }
  add_imperfect_balls(m, bearing, options);
  if (options.frame) set_frame(m, options.frame->speed, options.frame->field());
  return m;
}

}  // namespace adore::statics
