#include "contact/ball_groove.hpp"
#include "contact/wavy_groove.hpp"
#include "dynamics/ball_race_motion.hpp"
#include "dynamics/race_contacts.hpp"

#include <cmath>
#include <numbers>

namespace adore::dynamics {

namespace {

using contact::Triple;

/// Where one ball meets one race, in the azimuth frame of the ball.
struct Meeting {
  double s, c;
  Triple<double> k, d;  ///< race axis, ball centre from P_j
  contact::GrooveCoordinates<double> place;
  contact::WavyGrooveContact<double> wavy;  ///< of a race of revolution: without its change

  [[nodiscard]] Triple<double> to_azimuth(const Vec3& v) const {
    return contact::to_azimuth(Triple<double>{v[0], v[1], v[2]}, s, c);
  }
  [[nodiscard]] Vec3 to_base(const Triple<double>& v) const {
    const Triple<double> base = contact::from_azimuth(v, s, c);
    return {base.x, base.y, base.z};
  }
  [[nodiscard]] Triple<double> n() const { return wavy.touch.n_k * k + wavy.touch.n_e * place.e; }
  [[nodiscard]] Triple<double> t() const { return cross(k, place.e); }
};

Meeting meeting_of(const RaceContactModel& model, const ElementViews& balls, std::size_t index,
                   const RaceMotion& race) noexcept {
  const auto j = static_cast<std::size_t>(model.race);
  Meeting out{balls.sin_theta[index], balls.cos_theta[index], {}, {}, {}, {{}, 0.0, 0.0}};
  out.k = out.to_azimuth(race.axis);
  const Triple<double> centre = out.to_azimuth(race.centre);
  out.d = {balls.x[index] - centre.x, balls.r[index] - centre.y, -centre.z};
  out.place = contact::groove_coordinates(out.d, out.k, model.groove.centre_radius[j]);
  if (model.wavy)
    out.wavy = contact::wavy_groove_contact(
        *model.wavy, model.wavy->ratios,
        contact::azimuth_in_race(out.k, out.place.e, out.to_azimuth(race.zero())), out.place.axial,
        out.place.lift, model.groove.offset[j]);
  else
    out.wavy.touch =
        contact::ball_groove_contact(out.place.axial, out.place.lift, model.groove.offset[j]);
  if (model.wavy && model.wavy->forms != nullptr) {
    const auto base = [&](const Triple<double>& v) {
      return contact::from_azimuth(v, out.s, out.c);
    };
    const Triple<double> n = out.n(), t = out.t();
    const contact::Lobe lobe =
        contact::lobe_at(*model.wavy->forms, index, base(n), base(cross(t, n)), base(t));
    contact::add_lobe(out.wavy, lobe.height, lobe.c, lobe.t);
  }
  return out;
}

}  // namespace

RaceContactState race_contact_state(const RaceContactModel& model, const ElementViews& balls,
                                    std::size_t index, const RaceMotion& of_race) {
  RaceMotion race = of_race;
  if (model.half.is_split()) {
    const Vec3 shift = model.half.shift * race.axis;
    race.centre += shift;
    race.velocity += race.tilt.cross(shift);
  }
  const auto j = static_cast<std::size_t>(model.race);
  const Meeting at = meeting_of(model, balls, index, race);
  const double s = at.s, c = at.c, r = balls.r[index];
  const contact::WavyGrooveContact<double>& wavy = at.wavy;
  const contact::BallGrooveContact<double>& touch = wavy.touch;
  const Triple<double> n = at.n(), t = at.t();

  RaceContactState state;
  state.arm = Vec3(balls.x[index], -r * s, r * c) - race.centre;
  state.approach = touch.approach;
  state.n = at.to_base(n);
  state.t = at.to_base(t);
  state.c = at.to_base(cross(t, n));
  state.angle = contact::contact_angle(model.race, touch.n_k, touch.n_e);
  const double theta_dot = balls.theta_dot[index];
  const BallRaceMotion<double> pair{
      at.to_azimuth(race.velocity),
      at.to_azimuth(race.tilt),
      race.speed,
      true,
      {balls.x_dot[index], balls.r_dot[index], r * theta_dot},
      {balls.omega_x[index], balls.omega_r[index], balls.omega_theta[index]},
      theta_dot,
      model.groove.ball_radius};
  state.motion = ellipse_motion(pair, at.d, at.k, t, at.place, touch, state.approach_rate);
  state.approach_rate -= wavy.turn / at.place.distance * state.motion.u_t;
  state.approach_rate -= wavy.lean * state.motion.u_c;
  state.approach_rate -= wavy.lobe_t * state.motion.W_c - wavy.lobe_c * state.motion.W_t;
  if (state.approach > 0.0) {
    if (model.angle.follows) {
      const double root = std::sqrt(state.approach);
      const double K = contact::polynomial(model.angle.K, touch.n_e);
      state.ellipse.Q = contact::point_contact_load(K, state.approach, root);
      state.ellipse.a = contact::polynomial(model.angle.major, touch.n_e) * root;
      state.ellipse.b = contact::polynomial(model.angle.minor, touch.n_e) * root;
    } else {
      state.ellipse.Q = contact::hertz_load(model.hertz.K, state.approach);
      const double size = std::cbrt(state.ellipse.Q);
      state.ellipse.a = model.hertz.a_hat * size;
      state.ellipse.b = model.hertz.b_hat * size;
    }
    if (model.wavy) {
      state.ellipse.Q *= wavy.stiffness;
      state.ellipse.a *= wavy.major;
      state.ellipse.b *= wavy.minor;
    }
    const double Q = state.elastic = state.ellipse.Q;
    if (model.half.is_split()) {
      const contact::SplitLoadFractions<double> share = contact::split_load_fractions(
          model.half, Q, std::sqrt(state.approach), touch.n_k, touch.n_e, touch.length);
      state.share = share.load, state.turned = share.turned, state.energy = share.energy;
    }
    if (contact::is_damped(model.damping))
      state.ellipse.Q = contact::damped_load(model.damping, Q, 1.5 * Q / state.approach,
                                             state.approach, state.approach_rate);
    tribology::set_contact_surface(state.ellipse, model.surface, model.groove.ball_radius,
                                   model.groove.groove_radius[j], state.approach);
  }
  return state;
}

double race_rolling_heat(const RaceContactModel& model, const tribology::RollingResistance& rolling,
                         const RaceContactState& state) noexcept {
  const tribology::EllipseGeometry& g = state.ellipse;
  if (!(g.Q > 0.0)) return 0.0;
  const tribology::EllipseKinematics& m = state.motion;
  const double radius = model.groove.ball_radius;
  const double F = state.share * rolling.force(tribology::ContactConditions<double>{
                                     g.Q, 1.5 * g.Q / (std::numbers::pi * g.a * g.b), g.a, g.b,
                                     m.entrainment, tribology::middle_slip(g, m), m.curvature});
  return F * ((2.0 / (m.curvature * radius) - 1.0) * m.u_t + radius * m.W_c);
}

namespace {

/// @param traction of a state -> its integrals and the largest slip
template <class Traction>
RaceContactSnapshot detail_of(const RaceContactModel& model, const RaceContactState& state,
                              const Traction& traction_of) {
  RaceContactSnapshot snapshot;
  if (!(state.approach > 0.0) || !(state.share > 0.0)) return snapshot;
  const tribology::EllipseGeometry& ellipse = state.ellipse;
  snapshot.load = state.share * ellipse.Q;
  snapshot.damping_heat = state.share * (ellipse.Q - state.elastic) * state.approach_rate;
  snapshot.angle = state.angle;
  snapshot.half_major = ellipse.a;
  snapshot.half_minor = ellipse.b;
  snapshot.max_pressure = 1.5 * ellipse.Q / (std::numbers::pi * ellipse.a * ellipse.b);
  snapshot.spin_to_roll = state.motion.W_c != 0.0 ? state.motion.W_n / state.motion.W_c : 0.0;
  const contact::ContactEdges edges = contact::contact_edges(model.groove, model.race, state.angle,
                                                             ellipse.a, model.shoulder_radius);
  snapshot.edge = edges.shoulder_depth;
  snapshot.centre_chord = edges.centre_chord;
  // Slip is kinematics and is reported also when traction is off; heat is then zero.
  const tribology::EllipseTraction traction = traction_of(state);
  if (model.traction && model.law.has_film()) {
    const tribology::LocalFilm<double> film = model.law.film(
        {ellipse.Q, snapshot.max_pressure, ellipse.a, ellipse.b, state.motion.entrainment,
         tribology::middle_slip(ellipse, state.motion), state.motion.curvature});
    snapshot.film = film.thickness;
    snapshot.least_film = film.thinnest;
    snapshot.rolling_speed = std::abs(state.motion.entrainment);
  }
  snapshot.max_slip = traction.max_slip;
  snapshot.heat = model.traction ? state.share * traction.heat : 0.0;
  snapshot.load_slip = model.traction ? state.share * traction.load_slip : 0.0;
  return snapshot;
}

}  // namespace

RaceContactSnapshot race_contact_detail(const RaceContactModel& model, const ElementViews& balls,
                                        std::size_t index, const RaceMotion& race, bool converged) {
  return detail_of(
      model, race_contact_state(model, balls, index, race), [&](const RaceContactState& at) {
        return converged
                   ? tribology::ellipse_traction_converged(model.law, at.ellipse, at.motion)
                   : tribology::ellipse_traction(model.law, at.ellipse, at.motion, model.rule);
      });
}

RaceContactSnapshot race_contact_detail(const RaceContactModel& model, const ElementViews& balls,
                                        std::size_t index, const RaceMotion& race,
                                        const ContactSums& known) {
  return detail_of(model, race_contact_state(model, balls, index, race),
                   [&](const RaceContactState& at) {
                     tribology::EllipseTraction out;
                     out.heat = known.heat / at.share;
                     out.load_slip = known.load_slip / at.share;
                     out.max_slip = tribology::largest_slip(at.ellipse, at.motion);
                     return out;
                   });
}

QuadratureRuleError measure_rule_error(const RaceContactModel& model, const ElementViews& balls,
                                       const RaceMotion& race) {
  QuadratureRuleError error;
  double heat = 0.0, exact_heat = 0.0;
  for (std::size_t i = 0; i < balls.n; ++i) {
    const RaceContactState state = race_contact_state(model, balls, i, race);
    if (!(state.approach > 0.0)) continue;
    const auto exact =
        tribology::ellipse_traction_converged(model.law, state.ellipse, state.motion);
    const auto rule =
        tribology::ellipse_traction(model.law, state.ellipse, state.motion, model.rule);
    ++error.contacts;
    heat += rule.heat;
    exact_heat += exact.heat;
    const double full = model.law.coefficient(exact.max_slip) * state.ellipse.Q;
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
