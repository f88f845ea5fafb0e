#pragma once

#include "statics/ball_position.hpp"
#include "statics/spin.hpp"

#include <array>
#include <cmath>

/// Forces on one ball between its races, and what the ball hands on to the inner race.
///
/// Geometry and normal force of race j: contact/ball_groove.hpp, contact angle α from its normal.
/// Friction of the gyroscopic moment M_g = J ω_m ω_R sin β, along the major axis of the ellipse:
/// f_j = λ_j M_g/D. Forces on the ball (axial, radial):
///   outer -Q_o (sin α_o, cos α_o) + f_o (-cos α_o, sin α_o),  inner Q_i (sin α_i, cos α_i) + f_i
///   (cos α_i, -sin α_i),
/// centrifugal (0, m d_m/2 ω_m²), in a base frame that turns at Ω with ω_m + Ω for ω_m, and the
/// field m a of its origin along e_r. On the inner race: minus its force, and the moment Rc_i P_x -
/// r_i f_i about the axis opposite to the circumferential direction. Where K varies with the angle,
/// no K' term enters and Q acts along the normal, but with Curvature::Potential
/// (contact/angle_law.hpp). Races that are tables: contact/wavy_groove.hpp, with K' of the table.
///
/// Split races: both halves of contact/split_race.hpp, each at its own angle. Where a ball touches
/// both, the spin rule, the gyroscopic moment and its friction are those of their resultant.
///
/// A ball that is about to lose its inner race cannot be driven by it: while Q_i is below 1/1000 of
/// the centrifugal force, ω_m and M_g fade (smoothly, C1) into those of a ball seated on the outer
/// race alone. Without this the forces would jump when the contact opens, and some loads would have
/// no equilibrium. Above that load nothing is changed.
namespace adore::statics {

template <class S>
struct ContactState {
  S load = 0.0, approach = 0.0;
  S n_k = 0.0, n_e = 0.0;  ///< normal from the ball into the race: on its axis, on e
  Direction<S> alpha;
  S friction = 0.0;
  S leaning = 0.0;  ///< L along c, at the center (contact/angle_law.hpp, tables)
  // Of a split race.
  S shift = 0.0;    ///< center of the arc along the race axis; of two halves their mean [m]
  S turning = 0.0;  ///< moment about P_j of all but friction, less Rc along [N m]
};

/// S: numbers of the ball, P: of the pose of the inner race.
template <class S, class P = S>
struct BallForces {
  S axial = 0.0, radial = 0.0;  ///< resultant on the ball [N]
  std::array<S, 5> race{};      ///< share of the load on the inner race, base frame [N, N m]
  std::array<GroovePosition<S, P>, 2> position;
  std::array<ContactState<S>, 2> contact;
  S orbital = 0.0, spin = 0.0, centrifugal = 0.0, gyroscopic = 0.0;
  Direction<S> beta;
  bool rolls = true;
};

/// The touch with a race that is a table.
template <class S, class P>
contact::WavyGrooveContact<S> surface_table_contact(const BallInGrooves& seat, std::size_t race,
                                                    const GroovePosition<S, P>& p) {
  const contact::WavyGroove& of = *seat.table[race];
  const S psi = seat.azimuth_in_race + p.e.z;  // to first order: the race has moved a little
  return contact::wavy_groove_contact(of, of.ratios,
                                      contact::AzimuthDirection<S>{cosine(psi), sine(psi)}, p.xi,
                                      p.eta, seat.groove.offset[race]);
}

/// Hertz's constants of a closed contact at its angle α, of the groove as it is there.
inline contact::HertzConstants local_hertz_constants(const BallInGrooves& seat, std::size_t race,
                                                     const GroovePosition<double>& p,
                                                     double alpha) {
  contact::HertzConstants out = seat.hertz[race].at(alpha);
  if (!seat.table[race]) return out;
  const auto table = surface_table_contact(seat, race, p);
  const double root = std::cbrt(table.stiffness);  // half axes over √δ become those over Q^(1/3)
  out.K *= table.stiffness;
  out.a_hat *= table.major / root;
  out.b_hat *= table.minor / root;
  out.kappa *= table.major / table.minor;
  return out;
}

/// @param half null: the race is not split
template <class S, class P>
ContactState<S> contact_state(const BallModel& m, const BallInGrooves& seat, std::size_t race,
                              const GroovePosition<S, P>& p,
                              const contact::SplitRaceHalf* half = nullptr) {
  ContactState<S> c;
  S xi = p.xi;
  if (half != nullptr) xi = xi - half->shift;
  const auto touch = contact::ball_groove_contact(xi, p.eta, seat.groove.offset[race]);
  const double sign = race == 0 ? 1.0 : -1.0;
  c.n_k = touch.n_k;
  c.n_e = touch.n_e;
  c.alpha = {sign * touch.n_k, sign * touch.n_e};
  c.approach = touch.approach;
  if (seat.table[race]) c.approach = surface_table_contact(seat, race, p).touch.approach;
  if (value_of(c.approach) > 0.0) {
    const HertzSeries& hertz = seat.hertz[race];
    const double K_reference = hertz.reference().K;
    const S root = square_root(c.approach);
    if (!(m.own_speed_share > 0.0)) {  // the conservative problem: K is constant
      c.load = contact::point_contact_load(K_reference, c.approach, root);
    } else if (hertz.law().follows) {
      const auto at = contact::hertz_constant_at_angle(hertz.law(), value_of(c.n_e));
      const double K = K_reference + m.own_speed_share * (at.K - K_reference);
      const double slope = m.own_speed_share * at.slope;
      c.load = contact::point_contact_load(chain(c.n_e, K, slope), c.approach, root);
      c.leaning = contact::angle_gradient_force(chain(c.n_e, slope, m.own_speed_share * at.bend),
                                                c.approach, root, c.n_k, touch.length);
    } else if (hertz.varying()) {
      const auto log_K = hertz.log_K(value_of(c.alpha.cos));
      const double K = K_reference * std::exp(m.own_speed_share * log_K.value);
      c.load = contact::point_contact_load(
          chain(c.alpha.cos, K, K * m.own_speed_share * log_K.slope), c.approach, root);
    } else {
      c.load = contact::point_contact_load(K_reference, c.approach, root);
    }
    if (seat.table[race]) {
      const auto table = surface_table_contact(seat, race, p);
      c.load = c.load * table.stiffness;
      c.leaning = c.leaning * table.stiffness +
                  contact::wavy_transverse_force(table, c.load, c.load, c.approach);
    }
    if (half != nullptr) {
      const auto share =
          contact::split_load_fractions(*half, c.load, root, c.n_k, c.n_e, touch.length);
      c.load = share.load * c.load;
      c.leaning = share.energy * c.leaning + share.turned;
      const auto [along, outward] = contact::meridian_force(c.load, c.leaning, c.n_k, c.n_e);
      c.shift = S(half->shift);
      c.turning = -(touch.length * c.leaning) - half->shift * outward;
    }
  }
  return c;
}

/// A half of a split race. @param p about P_j
template <class S, class P>
ContactState<S> half_contact_state(const BallModel& m, const BallInGrooves& seat, std::size_t race,
                                   const GroovePosition<S, P>& p, std::size_t half) {
  const contact::SplitRaceHalf& of = m.half[race][half];
  return contact_state(m, seat, race, p, &of);
}

/// Both halves of a split race as one contact.
template <class S, class P>
ContactState<S> split_contact_state(const BallModel& m, const BallInGrooves& seat, std::size_t race,
                                    const GroovePosition<S, P>& p) {
  const std::array<ContactState<S>, 2> c{half_contact_state(m, seat, race, p, 0),
                                         half_contact_state(m, seat, race, p, 1)};
  for (std::size_t h = 0; h < 2; ++h)
    if (!(value_of(c[1 - h].load) > 0.0) &&
        (value_of(c[h].load) > 0.0 || value_of(c[h].approach) >= value_of(c[1 - h].approach)))
      return c[h];
  ContactState<S> out;
  S along = 0.0, outward = 0.0;
  for (const ContactState<S>& one : c) {
    const auto force = contact::meridian_force(one.load, one.leaning, one.n_k, one.n_e);
    along += force.along;
    outward += force.outward;
    out.turning += one.turning;
  }
  out.load = square_root(along * along + outward * outward);
  out.n_k = -along / out.load;
  out.n_e = -outward / out.load;
  const double sign = race == 0 ? 1.0 : -1.0;
  out.alpha = {sign * out.n_k, sign * out.n_e};
  out.shift = (c[0].load * c[0].shift + c[1].load * c[1].shift) / (c[0].load + c[1].load);
  out.approach = value_of(c[0].approach) < value_of(c[1].approach) ? c[0].approach : c[1].approach;
  return out;
}

/// Spin axis of least heat, shifted by BallSite::axis_shift, with its derivatives carried over from
/// the angles and loads that it depends on.
template <class S>
Direction<S> least_heat_direction(const BallInGrooves& seat, const BallSite& site,
                                  const std::array<ContactState<S>, 2>& contact) {
  std::array<HeatContact, 2> c;
  for (std::size_t j = 0; j < 2; ++j) {
    const HertzSeries& hertz = seat.hertz[j];
    const auto log_a = hertz.log_a(value_of(contact[j].alpha.cos));
    c[j].alpha = {value_of(contact[j].alpha.sin), value_of(contact[j].alpha.cos)};
    c[j].load = value_of(contact[j].load);
    c[j].half_major = hertz.reference().a_hat * std::exp(log_a.value) * std::cbrt(c[j].load);
    c[j].log_a_slope = -c[j].alpha.sin * log_a.slope;
    c[j].aspect = hertz.reference().kappa;
    c[j].surface_radius = seat.surface_radius[j];
  }
  const LeastHeatAxis axis = least_heat_axis(c, seat.gamma, site.pitch_guess);
  S beta = axis.beta + site.axis_shift;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& alpha = contact[j].alpha;
    const auto& [s, k] = c[j].alpha;
    const S turn = k * (alpha.sin - s) - s * (alpha.cos - k);  // α minus its value
    beta = beta + axis.over_angle[j] * turn + axis.over_load[j] * (contact[j].load - c[j].load);
  }
  return {sine(beta), cosine(beta)};
}

/// A value of a ball in balance of friction at the present contacts, to first order.
template <class S, class P>
S linearized_traction_value(const LinearizedTractions& of, const LinearizedTractions::Value& which,
                            const BallForces<S, P>& f, const S& rho) {
  S out = which.value + which.slope[4] * (rho - of.at.rho);
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& alpha = f.contact[j].alpha;
    const double s = of.at.sin[j], c = of.at.cos[j];
    const S turn = c * (alpha.sin - s) - s * (alpha.cos - c);
    out = out + which.slope[j] * (f.contact[j].load - of.at.load[j]) + which.slope[2 + j] * turn;
  }
  return out;
}

/// Fills speeds and moments; needs both contacts' angles.
template <class S, class P>
void add_inertia(const BallModel& m, const BallSite& site, const S& rho, BallForces<S, P>& f) {
  const BallInGrooves& seat = m.seat(site.own);
  f.orbital = m.base_orbital;
  const S& Q_o = f.contact[0].load;
  const S& Q_i = f.contact[1].load;
  if (m.per_ball_speeds && m.own_speed_share > 0.0 && value_of(Q_i) > 0.0 && value_of(Q_o) > 0.0) {
    const std::array<Direction<S>, 2> alpha{f.contact[0].alpha, f.contact[1].alpha};
    switch (site.law.axis) {
      case SpinLaw::Axis::OuterControl:
        f.beta = race_control_axis(alpha[0], seat.gamma, true);
        break;
      case SpinLaw::Axis::InnerControl:
        f.beta = race_control_axis(alpha[1], seat.gamma, false);
        break;
      case SpinLaw::Axis::Prescribed:
        f.beta = {S(std::sin(m.spin_angle)), S(std::cos(m.spin_angle))};
        break;
      case SpinLaw::Axis::LeastHeat:
        f.beta = least_heat_direction(seat, site, f.contact);
        break;
    }
    const PureRollingSpeeds<S> rolling = roll_without_slip(alpha, f.beta, seat.gamma, m.race_speed);
    f.rolls = rolling.possible;
    S weight = 1.0;
    if (value_of(Q_i) < seat.window) {
      const S t = Q_i / seat.window;
      weight = t * t * (3.0 - 2.0 * t);
    }
    weight = weight * m.own_speed_share;
    f.spin = rolling.spin;
    f.orbital = m.base_orbital + weight * (rolling.orbital - m.base_orbital);
    f.gyroscopic =
        weight * (seat.inertia * (f.orbital + m.frame_speed) * rolling.spin * f.beta.sin);
    const S per_race = f.gyroscopic / seat.diameter;
    if (site.tractions) {
      const LinearizedTractions& given = *site.tractions;
      f.orbital = linearized_traction_value(given, given.orbital, f, rho);
      for (std::size_t j = 0; j < 2; ++j)
        f.contact[j].friction = linearized_traction_value(given, given.along[j], f, rho);
    } else
      switch (site.law.share) {
        case SpinLaw::Share::Outer:
          f.contact[0].friction = 2.0 * per_race;
          break;
        case SpinLaw::Share::Equal:
          f.contact[0].friction = per_race;
          f.contact[1].friction = per_race;
          break;
        case SpinLaw::Share::ByLoad:
          f.contact[0].friction = 2.0 * per_race * Q_o / (Q_o + Q_i);
          f.contact[1].friction = 2.0 * per_race * Q_i / (Q_o + Q_i);
          break;
        case SpinLaw::Share::None:
          break;
      }
  }
  const S turning = f.orbital + m.frame_speed;
  f.centrifugal = seat.mass * 0.5 * m.balls.pitch_diameter * turning * turning;
}

/// Everything for a ball at (x, r = d_m/2 + rho).
template <class S, class P>
BallForces<S, P> ball_forces(const BallModel& m, const BallSite& site, const S& x, const S& rho,
                             const RacesInAzimuthFrame<P>& races) {
  BallForces<S, P> f;
  const BallInGrooves& seat = m.seat(site.own);
  f.position = groove_positions(m, site, x, rho, races);
  for (std::size_t j = 0; j < 2; ++j) {
    const GroovePosition<S, P>& p = f.position[j];
    f.contact[j] =
        m.half[j][0].is_split() ? split_contact_state(m, seat, j, p) : contact_state(m, seat, j, p);
  }
  if (m.moving) {
    add_inertia(m, site, rho, f);
    f.radial = f.centrifugal + seat.mass * (m.field.z() * site.cos - m.field.y() * site.sin);
  }
  for (std::size_t j = 0; j < 2; ++j) {
    const ContactState<S>& c = f.contact[j];
    if (!(value_of(c.load) > 0.0)) {
      continue;
    }
    const auto [along, outward] =
        contact::meridian_force(site.tractions ? S(c.load - site.tractions->into[j]) : c.load,
                                c.friction + c.leaning, c.n_k, c.n_e);
    const bool split = m.half[j][0].is_split();
    const auto& [xi, eta, a, e] = f.position[j];
    Triple<S> force = along * a + outward * e;
    f.axial += force.x;
    f.radial += force.y;
    if (j == 1) {
      const contact::GrooveGeometry& groove = seat.groove;
      const S about = split ? S(c.turning - c.shift * c.friction * c.n_k)
                            : S(-((groove.offset[1] + c.approach) * c.leaning));
      Triple<S> moment =
          (groove.centre_radius[1] * along - groove.groove_radius[1] * c.friction + about) *
          cross(e, a);
      if (seat.inner_slope != 0.0) {
        // Where the inner race is not round its normal leans by R'/r against the direction of
        // growing azimuth a × e: the ball also pushes it sideways, by -Q cos α R'/r at ξ a.
        const S push = -(c.load * c.alpha.cos) * seat.inner_slope / (eta + groove.centre_radius[1]);
        force = force + push * cross(a, e);
        moment = moment - (xi * push) * e;
      }
      if (seat.table[1]) {
        const auto at = surface_table_contact(seat, 1, f.position[1]);
        const S R = eta + groove.centre_radius[1];
        const S push = contact::wavy_tangential_force(at, c.load, S(0.0), c.approach, R);
        const S recess = at.touch.length - groove.offset[1] - c.approach;
        force = force + push * cross(a, e);
        moment = moment - (xi * push) * e - (recess * c.leaning) * cross(e, a);
      }
      const Triple<S> on_race = contact::from_azimuth(force, site.sin, site.cos);
      const Triple<S> turned = contact::from_azimuth(moment, site.sin, site.cos);
      f.race = {on_race.x, on_race.y, on_race.z, turned.y, turned.z};
    }
  }
  return f;
}

/// The same for an inner race in a given pose.
template <class S>
BallForces<S> ball_forces(const BallModel& m, const BallSite& site, const S& x, const S& rho,
                          const RacePose<S>& inner) {
  return ball_forces(m, site, x, rho, races_in_azimuth_frame(m, site, inner));
}

}  // namespace adore::statics
