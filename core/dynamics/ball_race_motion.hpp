#pragma once

#include "contact/ball_groove.hpp"
#include "tribology/ellipse_sum.hpp"

/// Slip of a ball on a race in the axes of their contact, for numbers and for vectors of numbers
/// (one ball a lane). Vectors in the azimuth frame of the ball, (e_x, e_r, e_θ); the rest as in
/// race_contacts.hpp. Seen by the race kernels.
namespace adore::dynamics {

/// Race and ball as rigid bodies. S: a number, or of lanes that differ one a lane.
template <class T, class S = double>
struct BallRaceMotion {
  contact::Triple<T> race_velocity;  ///< of P_j [m/s]
  contact::Triple<T> tilt;           ///< angular velocity of the race across its axis [rad/s]
  S race_speed = 0.0;                ///< Ω about its axis [rad/s]
  bool tilts = false;                ///< tilt is not 0
  contact::Triple<T> ball_velocity;  ///< of its center [m/s]
  contact::Triple<T> ball_omega;     ///< [rad/s]
  T orbital_speed;                   ///< θ̇, read for the entrainment only [rad/s]
  S ball_radius = 0.0;               ///< likewise [m]
};

/// With w = V_P + tilt × d - V_ball and ω = tilt - ω_ball:
///   u_c = w·c, u_t = w·t + Ω R, W = Ω k + ω on (c, t, n)
///   entrainment = ½ (u_t - W_c h) - h (ω_ball - θ̇ e_x)·c,  h = r_ball: mean of both surfaces'
///   velocities at ξ = η = 0 along t in the frame that orbits with the ball;
///   curvature = 1/r_ball - n_e/(R + r_ball n_e): of both bodies along t, R the distance of the
///   ball's center from the race axis.
/// @param d ball center from P_j; k race axis; approach_rate dδ/dt in a race of revolution, w·n < 0
/// [m/s]
template <class T, class S>
[[gnu::always_inline]] inline tribology::EllipseMotion<T> ellipse_motion(
    const BallRaceMotion<T, S>& m, const contact::Triple<T>& d, const contact::Triple<T>& k,
    const contact::Triple<T>& t, const contact::GrooveCoordinates<T>& place,
    const contact::BallGrooveContact<T>& touch, T& approach_rate) {
  using contact::dot;
  contact::Triple<T> w = m.race_velocity - m.ball_velocity;
  contact::Triple<T> omega = m.ball_omega;
  if (m.tilts) {  // across k: W_k below is not touched
    w = w + cross(m.tilt, d);
    omega = omega - m.tilt;
  }
  const contact::Triple<T>& e = place.e;
  const T W_k = m.race_speed - dot(omega, k), W_e = -dot(omega, e);
  tribology::EllipseMotion<T> out;
  const T w_k = dot(w, k), w_e = dot(w, e);
  approach_rate = -(touch.n_k * w_k + touch.n_e * w_e);
  out.u_c = touch.n_k * w_e - touch.n_e * w_k;
  out.u_t = dot(w, t) + m.race_speed * place.distance;
  out.W_c = touch.n_k * W_e - touch.n_e * W_k;
  out.W_t = -dot(omega, t);
  out.W_n = touch.n_k * W_k + touch.n_e * W_e;
  const T spin_c = touch.n_k * dot(m.ball_omega, e) - touch.n_e * dot(m.ball_omega, k);
  const T orbit_c = m.orbital_speed * (touch.n_k * e.x - touch.n_e * k.x);
  out.entrainment = 0.5 * (out.u_t - out.W_c * m.ball_radius) - m.ball_radius * (spin_c - orbit_c);
  out.curvature = 1.0 / m.ball_radius - touch.n_e / (place.distance + m.ball_radius * touch.n_e);
  return out;
}

}  // namespace adore::dynamics
