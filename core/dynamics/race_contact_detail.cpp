#include "dynamics/race_contacts.hpp"
#include "tribology/traction_curve.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace adore::dynamics {

RaceContactState race_contact_state(const RaceContactModel& model, const ElementViews& balls,
                                    std::size_t index, const RaceMotion& race) {
  const auto j = static_cast<std::size_t>(model.race);
  const double s = balls.sin_theta[index], c = balls.cos_theta[index], r = balls.r[index];
  const Vec3 e_r(0.0, -s, c), e_theta(0.0, -c, -s);
  const Vec3 position = balls.x[index] * Vec3::UnitX() + r * e_r;
  const Vec3 velocity = balls.x_dot[index] * Vec3::UnitX() + balls.r_dot[index] * e_r +
                        r * balls.theta_dot[index] * e_theta;
  const Vec3 omega = balls.omega_x[index] * Vec3::UnitX() + balls.omega_r[index] * e_r +
                     balls.omega_theta[index] * e_theta;
  RaceContactState state;
  state.arm = position - race.centre;
  const double axial = state.arm.dot(race.axis);
  const Vec3 radial = state.arm - axial * race.axis;
  const Vec3 e = radial.normalized();
  const double lift = radial.norm() - model.groove.centre_radius[j];
  const double l = std::hypot(axial, lift);
  state.approach = l - model.groove.offset[j];
  const double n_k = axial / l, n_e = lift / l;
  state.n = n_k * race.axis + n_e * e;
  state.t = race.axis.cross(e);
  state.c = state.t.cross(state.n);
  state.angle = model.race == bearing::kOuter ? std::atan2(n_k, n_e) : std::atan2(-n_k, -n_e);

  const Vec3 slip = race.velocity + race.speed * race.axis.cross(state.arm) +
                    race.tilt.cross(state.arm) - velocity;
  const Vec3 W = race.speed * race.axis + race.tilt - omega;
  state.motion = {slip.dot(state.c), slip.dot(state.t), W.dot(state.c), W.dot(state.t),
                  W.dot(state.n)};
  if (state.approach > 0.0) {
    state.ellipse.Q = contact::hertz_load(model.hertz.K, state.approach);
    const double size = std::cbrt(state.ellipse.Q);
    state.ellipse.a = model.hertz.a_hat * size;
    state.ellipse.b = model.hertz.b_hat * size;
    tribology::set_contact_surface(state.ellipse, model.surface, model.groove.ball_radius,
                                   model.groove.groove_radius[j], state.approach);
  }
  return state;
}

ContactEdges contact_edges(const RaceContactModel& model, double angle,
                           double half_major) noexcept {
  const auto j = static_cast<std::size_t>(model.race);
  const double radius = model.groove.groove_radius[j];
  const double span = half_major / radius;
  ContactEdges edges;
  if (model.shoulder_radius > 0.0) {
    // Distance of the contact's far end from the groove's centre circle, towards the groove bottom.
    const double drop = radius * std::cos(std::abs(angle) + span);
    const double centre = model.groove.centre_radius[j];
    edges.shoulder_depth = model.race == bearing::kOuter ? centre + drop - model.shoulder_radius
                                                         : model.shoulder_radius - (centre - drop);
  }
  edges.centre_chord = radius * std::sin(std::abs(angle) - span);
  return edges;
}

RaceContactSnapshot race_contact_detail(const RaceContactModel& model, const ElementViews& balls,
                                        std::size_t index, const RaceMotion& race, bool converged) {
  const RaceContactState state = race_contact_state(model, balls, index, race);
  RaceContactSnapshot snapshot;
  if (!(state.approach > 0.0)) return snapshot;
  const tribology::EllipseGeometry& ellipse = state.ellipse;
  snapshot.load = ellipse.Q;
  snapshot.angle = state.angle;
  snapshot.half_major = ellipse.a;
  snapshot.half_minor = ellipse.b;
  snapshot.max_pressure = 1.5 * ellipse.Q / (std::numbers::pi * ellipse.a * ellipse.b);
  snapshot.spin_to_roll = state.motion.W_c != 0.0 ? state.motion.W_n / state.motion.W_c : 0.0;
  const ContactEdges edges = contact_edges(model, state.angle, ellipse.a);
  snapshot.edge = edges.shoulder_depth;
  snapshot.centre_chord = edges.centre_chord;
  // Slip is kinematics and is reported also when traction is off; heat is then zero.
  const tribology::EllipseTraction traction =
      converged ? tribology::ellipse_traction_converged(model.curve, ellipse, state.motion)
                : tribology::ellipse_traction(model.curve, ellipse, state.motion, model.rule);
  snapshot.max_slip = traction.max_slip;
  snapshot.heat = model.traction ? traction.heat : 0.0;
  snapshot.load_slip = model.traction ? traction.load_slip : 0.0;
  return snapshot;
}

RuleError measure_rule_error(const RaceContactModel& model, const ElementViews& balls,
                             const RaceMotion& race) {
  RuleError error;
  double heat = 0.0, exact_heat = 0.0;
  for (std::size_t i = 0; i < balls.n; ++i) {
    const RaceContactState state = race_contact_state(model, balls, i, race);
    if (!(state.approach > 0.0)) continue;
    const auto exact =
        tribology::ellipse_traction_converged(model.curve, state.ellipse, state.motion);
    const auto rule =
        tribology::ellipse_traction(model.curve, state.ellipse, state.motion, model.rule);
    ++error.contacts;
    heat += rule.heat;
    exact_heat += exact.heat;
    const double full =
        tribology::traction_coefficient(model.curve, exact.max_slip) * state.ellipse.Q;
    if (!(full > 0.0)) continue;  // a frictionless law has no error
    error.force += std::pow(std::hypot(rule.F_c - exact.F_c, rule.F_t - exact.F_t) / full, 2);
    error.moment += std::pow((rule.M_n - exact.M_n) / (full * state.ellipse.a), 2);
  }
  if (error.contacts == 0) return error;
  error.force = std::sqrt(error.force / error.contacts);
  error.moment = std::sqrt(error.moment / error.contacts);
  error.heat = exact_heat > 0.0 ? heat / exact_heat - 1.0 : 0.0;
  return error;
}

}  // namespace adore::dynamics
