#pragma once

#include "statics/ball_model.hpp"
#include "statics/dual.hpp"
#include "statics/spin.hpp"

#include <array>
#include <cmath>
#include <limits>

/// Forces on one ball between its races, and what the ball hands on to the inner race.
///
/// Race j: V = (ξ, η) from the groove centre to the ball centre in the meridional plane of that
/// race, l = |V|, approach δ = l - s_j, load Q = K δ^1.5 along V, contact angle sin α = ±ξ/l, cos α
/// = ±η/l (+ outer, - inner). Friction of the gyroscopic moment M_g = J ω_m ω_R sin β: f_j = λ_j
/// M_g/D. Forces on the ball (axial, radial):
///   outer -Q_o (sin α_o, cos α_o) + f_o (-cos α_o, sin α_o),  inner Q_i (sin α_i, cos α_i) + f_i
///   (cos α_i, -sin α_i),
/// centrifugal (0, m d_m/2 ω_m²). On the inner race: minus its force, and the moment Rc_i P_x - r_i
/// f_i about the axis opposite to the circumferential direction. Where K varies with the angle, no
/// K' term enters: Q acts along V.
///
/// A ball that is about to lose its inner race cannot be driven by it: while Q_i is below 1/1000 of
/// the centrifugal force, ω_m and M_g fade (smoothly, C1) into those of a ball seated on the outer
/// race alone. Without this the forces would jump when the contact opens, and some loads would have
/// no equilibrium. Above that load nothing is changed.
namespace adore::statics {

/// Pose of the inner race as the balls see it.
template <class S>
struct RacePose {
  std::array<S, 3> centre{};  ///< P [m], base frame
  std::array<S, 3> axis{};    ///< unit vector
  std::array<S, 5>
      q{};  ///< x, y, z, about y, about z: displacement from the free position (linear kinematics)
};

/// Axis of a race tilted by ξ about y, then ζ about the new z: R e_x.
template <class S>
std::array<S, 3> tilted_axis(const S& about_y, const S& about_z) {
  const S cy = cosine(about_y);
  const S cz = cosine(about_z);
  return {cy * cz, sine(about_z), -(sine(about_y) * cz)};
}

template <class S>
RacePose<S> inner_pose(const BallModel& m, const std::array<S, 5>& q) {
  RacePose<S> pose;
  pose.q = q;
  if (m.exact) {
    pose.centre = {q[0] + m.groove.centre_x[1], q[1], q[2]};
    pose.axis = tilted_axis(q[3], q[4]);
  }
  return pose;
}

/// Ball centre relative to one groove centre circle, with the race's meridional directions in the
/// base frame.
template <class S>
struct GroovePosition {
  S xi = 0.0, eta = 0.0;      ///< along the race axis; radial, from the groove centre [m]
  std::array<S, 3> a{}, e{};  ///< race axis; radial direction of the ball seen from it
};

template <class S>
struct ContactState {
  S load = 0.0, approach = 0.0;
  Direction<S> alpha;
  S friction = 0.0;
};

template <class S>
struct BallForces {
  S axial = 0.0, radial = 0.0;  ///< resultant on the ball [N]
  std::array<S, 5> race{};      ///< share of the load on the inner race [N, N m]
  std::array<GroovePosition<S>, 2> position;
  std::array<ContactState<S>, 2> contact;
  S orbital = 0.0, spin = 0.0, centrifugal = 0.0, gyroscopic = 0.0;
  Direction<S> beta;
  bool rolls = true;
};

struct BallSite {
  double sin = 0.0, cos = 1.0;  ///< of the azimuth
  std::size_t own = 0;          ///< BallModel::seat
  SpinLaw law;
  double pitch_guess =
      std::numeric_limits<double>::quiet_NaN();  ///< where the least-heat search starts
};

/// Exact kinematics: race with centre P and axis a.
template <class S>
GroovePosition<S> exact_position(const BallSite& site, const S& x, const S& r,
                                 const std::array<S, 3>& centre, const std::array<S, 3>& axis,
                                 double centre_radius) {
  const std::array<S, 3> d{x - centre[0], -(r * site.sin) - centre[1], r * site.cos - centre[2]};
  GroovePosition<S> p;
  p.a = axis;
  p.xi = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
  std::array<S, 3> across;
  for (std::size_t k = 0; k < 3; ++k) {
    across[k] = d[k] - p.xi * axis[k];
  }
  const S distance =
      square_root(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    p.e[k] = across[k] / distance;
  }
  p.eta = distance - centre_radius;
  return p;
}

/// Small-angle kinematics: the groove centre of this azimuth moves by (Δx, Δr), directions stay
/// those of the base frame.
template <class S>
GroovePosition<S> linear_position(const BallModel& m, const BallSite& site, std::size_t race,
                                  const S& x, const S& rho, const S& shift_x, const S& shift_r) {
  const contact::GrooveGeometry& groove = m.seat(site.own).groove;
  GroovePosition<S> p;
  p.a = {S(1.0), S(0.0), S(0.0)};
  p.e = {S(0.0), S(-site.sin), S(site.cos)};
  p.xi = x - groove.centre_x[race] - shift_x;
  p.eta = rho - (groove.centre_radius[race] - 0.5 * m.balls.pitch_diameter) - shift_r;
  return p;
}

template <class S>
std::array<GroovePosition<S>, 2> groove_positions(const BallModel& m, const BallSite& site,
                                                  const S& x, const S& rho,
                                                  const RacePose<S>& inner) {
  std::array<GroovePosition<S>, 2> p;
  const BallSeat& seat = m.seat(site.own);
  const contact::GrooveGeometry& groove = seat.groove;
  const S r = rho + 0.5 * m.balls.pitch_diameter;
  if (!m.outer_tilted) {
    p[0] = linear_position(m, site, 0, x, rho, S(0.0), S(0.0));
  } else if (m.exact) {
    const auto axis = tilted_axis(m.outer_tilt[0], m.outer_tilt[1]);
    p[0] = exact_position(site, x, r, {S(groove.centre_x[0]), S(0.0), S(0.0)},
                          std::array<S, 3>{S(axis[0]), S(axis[1]), S(axis[2])},
                          groove.centre_radius[0]);
  } else {
    const double shift =
        groove.centre_radius[0] * (m.outer_tilt[0] * site.cos + m.outer_tilt[1] * site.sin);
    p[0] = linear_position(m, site, 0, x, rho, S(shift), S(0.0));
  }
  if (m.exact) {
    p[1] = exact_position(site, x, r, inner.centre, inner.axis, groove.centre_radius[1]);
    if (site.own != 0) {
      p[1].xi = p[1].xi - (groove.centre_x[1] - m.groove.centre_x[1]);
    }
  } else {
    const auto& q = inner.q;
    const S shift_x = q[0] + groove.centre_radius[1] * (q[3] * site.cos + q[4] * site.sin);
    p[1] = linear_position(m, site, 1, x, rho, shift_x, q[2] * site.cos - q[1] * site.sin);
  }
  if (seat.inner_slope != 0.0) {
    // Azimuth of the ball in the race minus that of its seat.
    const S ahead =
        m.exact ? -(p[1].e[1] * site.cos) - p[1].e[2] * site.sin
                : (inner.q[1] * site.cos + inner.q[2] * site.sin) * (1.0 / groove.centre_radius[1]);
    p[1].eta = p[1].eta - seat.inner_slope * ahead;
  }
  return p;
}

template <class S>
ContactState<S> contact_state(const BallModel& m, const BallSeat& seat, std::size_t race,
                              const GroovePosition<S>& p) {
  ContactState<S> c;
  const S length = square_root(p.xi * p.xi + p.eta * p.eta);
  const double sign = race == 0 ? 1.0 : -1.0;
  c.alpha = {sign * p.xi / length, sign * p.eta / length};
  c.approach = length - seat.groove.offset[race];
  if (value_of(c.approach) > 0.0) {
    const HertzSeries& hertz = seat.hertz[race];
    const double K_reference = hertz.reference().K;
    S K = K_reference;
    if (hertz.varying()) {
      const auto log_K = hertz.log_K(value_of(c.alpha.cos));
      const double value = K_reference * std::exp(m.own_speed_share * log_K.value);
      K = chain(c.alpha.cos, value, value * m.own_speed_share * log_K.slope);
    }
    c.load = K * c.approach * square_root(c.approach);
  }
  return c;
}

/// Spin axis of least heat, with its derivatives carried over from the angles and loads that it
/// depends on.
template <class S>
Direction<S> least_heat_direction(const BallSeat& seat, double guess,
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
  const LeastHeatAxis axis = least_heat_axis(c, seat.gamma, guess);
  S beta = axis.beta;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& alpha = contact[j].alpha;
    const auto& [s, k] = c[j].alpha;
    const S turn = k * (alpha.sin - s) - s * (alpha.cos - k);  // α minus its value
    beta = beta + axis.over_angle[j] * turn + axis.over_load[j] * (contact[j].load - c[j].load);
  }
  return {sine(beta), cosine(beta)};
}

/// Fills speeds and moments; needs both contacts' angles.
template <class S>
void add_inertia(const BallModel& m, const BallSite& site, BallForces<S>& f) {
  const BallSeat& seat = m.seat(site.own);
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
        f.beta = least_heat_direction(seat, site.pitch_guess, f.contact);
        break;
    }
    const Rolling<S> rolling = roll_without_slip(alpha, f.beta, seat.gamma, m.race_speed);
    f.rolls = rolling.possible;
    S weight = 1.0;
    if (value_of(Q_i) < seat.window) {
      const S t = Q_i / seat.window;
      weight = t * t * (3.0 - 2.0 * t);
    }
    weight = weight * m.own_speed_share;
    f.spin = rolling.spin;
    f.orbital = m.base_orbital + weight * (rolling.orbital - m.base_orbital);
    f.gyroscopic = weight * (seat.inertia * f.orbital * rolling.spin * f.beta.sin);
    const S per_race = f.gyroscopic / seat.diameter;
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
  f.centrifugal = seat.mass * 0.5 * m.balls.pitch_diameter * f.orbital * f.orbital;
}

/// Where the inner race is not round its normal leans by R'/r against the direction of growing
/// azimuth a × e: the ball also pushes it sideways, by -Q cos α R'/r at ξ a.
template <class S>
void add_sideways(const BallSeat& seat, const GroovePosition<S>& p, const ContactState<S>& c,
                  std::array<S, 5>& race) {
  const S push =
      -(c.load * c.alpha.cos) * seat.inner_slope / (p.eta + seat.groove.centre_radius[1]);
  const auto& a = p.a;
  const auto& e = p.e;
  race[0] += push * (a[1] * e[2] - a[2] * e[1]);
  race[1] += push * (a[2] * e[0] - a[0] * e[2]);
  race[2] += push * (a[0] * e[1] - a[1] * e[0]);
  race[3] += -(p.xi * push * e[1]);
  race[4] += -(p.xi * push * e[2]);
}

/// Everything for a ball at (x, r = d_m/2 + rho).
template <class S>
BallForces<S> ball_forces(const BallModel& m, const BallSite& site, const S& x, const S& rho,
                          const RacePose<S>& inner) {
  BallForces<S> f;
  const BallSeat& seat = m.seat(site.own);
  f.position = groove_positions(m, site, x, rho, inner);
  for (std::size_t j = 0; j < 2; ++j) {
    f.contact[j] = contact_state(m, seat, j, f.position[j]);
  }
  if (m.moving) {
    add_inertia(m, site, f);
    f.radial = f.centrifugal;
  }
  for (std::size_t j = 0; j < 2; ++j) {
    const ContactState<S>& c = f.contact[j];
    if (!(value_of(c.load) > 0.0)) {
      continue;
    }
    const double sign = j == 0 ? -1.0 : 1.0;
    const S along = sign * (c.load * c.alpha.sin +
                            c.friction * c.alpha.cos);  // on the ball, along the race axis
    const S outward = sign * (c.load * c.alpha.cos - c.friction * c.alpha.sin);
    const auto& a = f.position[j].a;
    const auto& e = f.position[j].e;
    f.axial += along * a[0] + outward * e[0];
    f.radial +=
        along * (a[2] * site.cos - a[1] * site.sin) + outward * (e[2] * site.cos - e[1] * site.sin);
    if (j == 1) {
      const S moment =
          seat.groove.centre_radius[1] * along - seat.groove.groove_radius[1] * c.friction;
      for (std::size_t k = 0; k < 3; ++k) {
        f.race[k] = along * a[k] + outward * e[k];
      }
      f.race[3] = moment * (e[2] * a[0] - e[0] * a[2]);
      f.race[4] = moment * (e[0] * a[1] - e[1] * a[0]);
      if (seat.inner_slope != 0.0) {
        add_sideways(seat, f.position[1], c, f.race);
      }
    }
  }
  return f;
}

}  // namespace adore::statics
