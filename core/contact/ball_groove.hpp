#pragma once

#include "base/scalar_math.hpp"
#include "contact/triple.hpp"

/// A ball in the groove of a race: the one statement of the geometry and of the normal force, for
/// numbers, vectors of numbers (one ball a lane) and dual numbers. SI.
///
/// d = ball centre - P_j (P_j: middle of the groove-centre circle, contact/groove.hpp), k the unit
/// vector of the race's axis. With the axial part ξ = d·k, R = |d - ξ k|, e = (d - ξ k)/R, lift η =
/// R - Rc and l = √(ξ² + η²):
///   δ = l - s,   n = (ξ k + η e)/l  from the ball into the race,   Q = K δ^1.5,   V = 0.4 K δ^2.5
///   t = k × e the rolling direction,  c = t × n = n_k e - n_e k  along the major axis
///   contact angle, positive when the inner race pushes the ball towards +x: atan2(n_k, n_e) outer,
///   atan2(-n_k, -n_e) inner
///   ∂²V/∂d² = Q' n nᵀ + (Q/l)(c cᵀ + (η/R) t tᵀ),   Q' = 1.5 K √δ
/// Vectors have their components in the azimuth frame of the ball, (e_x, e_r, e_θ). Source:
/// tests/reference/dynamics_README.md. Limits: ball centre off the race axis and outside of it on
/// its own side, d_r > 0; Hertz's theory.
namespace adore::contact {

/// Where the ball centre stands in the race.
template <class T>
struct GrooveCoordinates {
  T axial;      ///< ξ [m]
  T lift;       ///< η [m]
  T distance;   ///< R [m]
  Triple<T> e;  ///< unit vector
};

/// η is formed from d_r - Rc and a small excess, so that rounding of R does not reach the approach.
/// @param centre_radius Rc [m], a number or one a lane
template <class T, class S>
[[gnu::always_inline]] inline GrooveCoordinates<T> groove_coordinates(const Triple<T>& d,
                                                                      const Triple<T>& k,
                                                                      const S& centre_radius) {
  GrooveCoordinates<T> place;
  place.axial = dot(d, k);
  const Triple<T> p{d.x - place.axial * k.x, d.y - place.axial * k.y, d.z - place.axial * k.z};
  const T across = p.x * p.x + p.z * p.z;
  T inverse;
  place.distance =
      ScalarMath<T>::sqrt_and_inverse(ScalarMath<T>::max(p.y * p.y + across, T(1e-30)), inverse);
  place.lift = (p.y - centre_radius) + across / (place.distance + p.y);
  place.e = {p.x * inverse, p.y * inverse, p.z * inverse};
  return place;
}

/// Approach and normal, from the groove centre.
template <class T>
struct BallGrooveContact {
  T length;    ///< l [m]
  T approach;  ///< δ [m], negative when open
  T n_k, n_e;  ///< n on k and e
};

/// @param offset s = groove radius - ball radius [m], a number or one a lane
template <class T, class S>
[[gnu::always_inline]] inline BallGrooveContact<T> ball_groove_contact(const T& axial,
                                                                       const T& lift,
                                                                       const S& offset) {
  BallGrooveContact<T> touch;
  T inverse;
  touch.length = ScalarMath<T>::sqrt_and_inverse(
      ScalarMath<T>::max(axial * axial + lift * lift, T(1e-30)), inverse);
  touch.approach = touch.length - offset;
  touch.n_k = axial * inverse;
  touch.n_e = lift * inverse;
  return touch;
}

/// Q from δ > 0 and √δ (or 0 from 0).
template <class S, class T>
[[gnu::always_inline]] inline T point_contact_load(const S& K, const T& approach, const T& root) {
  return K * approach * root;
}
/// V from Q.
template <class T>
[[gnu::always_inline]] inline T point_contact_energy(const T& load, const T& approach) {
  return 0.4 * load * approach;
}

/// Principal stiffnesses of a closed contact: eigenvalues of ∂²V/∂d² along n, c and t [N/m].
struct PointContactStiffness {
  double normal = 0.0, across = 0.0, around = 0.0;
};
/// @param length l; lift_over_distance η/R
[[nodiscard]] inline PointContactStiffness point_contact_stiffness(double K, double approach,
                                                                   double load, double length,
                                                                   double lift_over_distance) {
  const double across = load / length;
  return {1.5 * K * std::sqrt(approach), across, across * lift_over_distance};
}

/// Force on the ball in the meridian plane of the race, of the load and of friction F_c along c.
template <class T>
struct MeridianForce {
  T along, outward;  ///< on k and e [N]
};
template <class T>
[[gnu::always_inline]] inline MeridianForce<T> meridian_force(const T& load, const T& friction,
                                                              const T& n_k, const T& n_e) {
  return {-load * n_k - friction * n_e, -load * n_e + friction * n_k};
}

/// Contact angle of a normal [rad]. @param race 0 outer, 1 inner
[[nodiscard]] inline double contact_angle(int race, double n_k, double n_e) {
  return race == 0 ? std::atan2(n_k, n_e) : std::atan2(-n_k, -n_e);
}

}  // namespace adore::contact
