#pragma once

#include "base/rotation.hpp"
#include "contact/roller_profile.hpp"

#include <algorithm>
#include <cmath>

/// A slice of one roller against the side of another one.
///
/// The slice is a circle of radius ρ about the point p of its own axis. t = (p - C)·a is where p is
/// along the axis of the other roller (middle C, unit vector a), w = C + t a, d = |w - p|, m = (w -
/// p)/d, and
///   δ = ρ + ρ'(t) - d,   ρ' the radius of the other roller at t,
/// exact for parallel axes, second order in the angle between them. f is the part of the slice that
/// lies beside the side of the other roller (without its corners). With the energy f e(δ) of a load
/// law q = e', both rollers feel opposite forces along one line through p:
///   on the slice F = -f q (m + dρ'/dt a) - e df/dt a,   -F on the other one,
/// which is minus the gradient of the energy over both poses: E knows p, C and a only, and does not
/// change when all of them move and turn together. Neither has a moment about its own axis.
/// [derived] SI.
namespace adore::contact {

/// The side of a roller between its corners.
struct RollerSide {
  RollerProfile profile;
  double low = 0.0, high = 0.0;  ///< ends [m]
};

struct RollerPairSlice {
  double overlap = 0.0;         ///< δ [m]
  double fraction = 0.0;        ///< f
  double fraction_slope = 0.0;  ///< df/dt [1/m]
  double other_radius = 0.0;    ///< ρ'(t) [m]
  double other_slope = 0.0;     ///< dρ'/dt
  double distance = 0.0;        ///< d [m]
  Vec3 m = Vec3::Zero();
};

/// @param half_slice half the width of the slice [m]
[[nodiscard]] inline RollerPairSlice roller_pair_slice(const Vec3& p, double radius,
                                                       double half_slice, const RollerSide& other,
                                                       const Vec3& C, const Vec3& a) noexcept {
  RollerPairSlice out;
  const Vec3 from = p - C;
  const double t = from.dot(a);
  const double high = std::min(t + half_slice, other.high);
  const double low = std::max(t - half_slice, other.low);
  if (!(high > low)) return out;
  out.fraction = (high - low) / (2.0 * half_slice);
  out.fraction_slope =
      ((t + half_slice < other.high ? 1.0 : 0.0) - (t - half_slice > other.low ? 1.0 : 0.0)) /
      (2.0 * half_slice);
  const double at = std::clamp(t, other.low, other.high);
  out.other_radius = roller_radius(other.profile, at);
  out.other_slope = at == t ? roller_slope(other.profile, at) : 0.0;
  const Vec3 across = t * a - from;
  out.distance = across.norm();
  out.m = across / std::max(out.distance, 1e-3 * radius);
  out.overlap = radius + out.other_radius - out.distance;
  return out;
}

}  // namespace adore::contact
