#pragma once

#include "contact/angle_law.hpp"

/// Force of a groove on a ball and how it changes with the ball's place, for numbers and vectors of
/// numbers (one ball a lane). Equations, frames and limits of contact/angle_law.hpp; a groove whose
/// constants are frozen is the case K' = 0. SI.
namespace adore::contact {

template <class T>
struct GrooveSpring {
  GrooveCoordinates<T> place;
  BallGrooveContact<T> touch;      ///< `approach` as it is, negative when open
  Triple<T> normal, side, around;  ///< n, c = t × n, t
  T K, load;                       ///< [N m^-1.5], Q [N], 0 when open
  Triple<T> force;                 ///< -∂V/∂d on the ball, 0 when open [N]
  T xx, xy, xz, yy, yz, zz;        ///< ∂²V/∂d², symmetric, 0 when open [N/m]
};

/// @param d ball centre from P_j, @param k axis of the race, both in the azimuth frame of the ball
/// @param follow null: K is that of every angle
template <class T>
[[nodiscard, gnu::always_inline]] inline GrooveSpring<T> groove_spring(
    const Triple<T>& d, const Triple<T>& k, double centre_radius, double offset, double frozen_K,
    const HertzAngleLaw* follow) {
  using M = ScalarMath<T>;
  GrooveSpring<T> s;
  s.place = groove_coordinates(d, k, centre_radius);
  s.touch = ball_groove_contact(s.place.axial, s.place.lift, offset);
  const Triple<T>& e = s.place.e;
  const T &n_k = s.touch.n_k, &n_e = s.touch.n_e, &l = s.touch.length, &R = s.place.distance;
  s.normal = {n_k * k.x + n_e * e.x, n_k * k.y + n_e * e.y, n_k * k.z + n_e * e.z};
  s.around = cross(k, e);
  s.side = cross(s.around, s.normal);

  const T depth = M::max(s.touch.approach, T(0.0));
  const T root = M::root(depth);
  const T rest = depth * root;  // δ^1.5
  s.K = T(frozen_K);
  T lean = T(0.0), coupling = T(0.0), bent = T(0.0);
  if (follow != nullptr) {
    const AngleDependentHertzConstant<T> at = hertz_constant_at_angle(*follow, n_e);
    s.K = at.K;
    lean = angle_gradient_force(at.slope, depth, root, n_k, l);
    coupling = at.slope * n_k * rest / l * (1.0 - 0.4 * depth / l);
    bent = 0.4 * (at.bend * n_k * n_k - at.slope * n_e) * rest * depth / (l * l);
  }
  s.load = point_contact_load(s.K, depth, root);
  s.force = lean * s.side - s.load * s.normal;
  const T along = 1.5 * s.K * root, across = s.load / l + bent,
          round = s.load / l * (s.place.lift / R) - lean * n_k / R;
  const Triple<T>&n = s.normal, &c = s.side, &t = s.around;
  const auto entry = [&](const T& ni, const T& nj, const T& ci, const T& cj, const T& ti,
                         const T& tj) __attribute__((always_inline)) {
    return along * ni * nj + across * ci * cj + round * ti * tj + coupling * (ni * cj + ci * nj);
  };
  s.xx = entry(n.x, n.x, c.x, c.x, t.x, t.x);
  s.xy = entry(n.x, n.y, c.x, c.y, t.x, t.y);
  s.xz = entry(n.x, n.z, c.x, c.z, t.x, t.z);
  s.yy = entry(n.y, n.y, c.y, c.y, t.y, t.y);
  s.yz = entry(n.y, n.z, c.y, c.z, t.y, t.z);
  s.zz = entry(n.z, n.z, c.z, c.z, t.z, t.z);
  return s;
}

}  // namespace adore::contact
