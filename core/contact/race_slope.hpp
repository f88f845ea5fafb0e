#pragma once

#include "base/scalar_math.hpp"
#include "contact/race_shape.hpp"
#include "contact/slice_circle.hpp"

/// How the depth of a point in a race changes with the azimuth at which the race's surface is taken
/// (race_wave.hpp); the point stays. For numbers and for a slice a lane, for kernels too. SI.
///   cone    ∂φ/∂ψ = σ (-R' cos α + α' (x cos α - (r - R0) sin α - x_mid/cos α)),  α' = -taper'
///   crowned cone, φ0' that of the cone:  ∂φ/∂ψ = n·n0 φ0' + n·g (l' - o'),
///     l' = -α' ((x - x_m) sin α + (r - r_m) cos α)
///   groove  ∂φ/∂ψ = -n_x x_g' - n_r R_g' - r_g'
/// and of the width w of a slice on a land whose offset o moves: ∂w/∂o. [derived]
namespace adore::contact {

/// Per radian of azimuth.
struct RaceAzimuthSlope {
  double radius = 0.0, angle = 0.0;                                        ///< R', α'; cones
  double groove_radius = 0.0, groove_x = 0.0, groove_centre_radius = 0.0;  ///< grooves
  double land_offset = 0.0;
  const double* rise = nullptr;  ///< of tables: ∂δ_k/∂ψ by slice (contact/slice_table.hpp) [m/rad]
};

/// @param at depth and directions at X
template <class T>
[[nodiscard, gnu::always_inline]] inline T depth_slope_over_azimuth(const RaceSurface& race,
                                                                    const RaceAzimuthSlope& slope,
                                                                    const Triple<T>& X,
                                                                    const SurfaceDepth<T>& at) {
  if (race.shape == RaceSurface::Shape::Groove) {
    // meridian = (n_r, -n_x e): n_r and n_x are its parts.
    return -at.n.x * slope.groove_x - at.meridian.x * slope.groove_centre_radius -
           slope.groove_radius;
  }
  const T r = ScalarMath<T>::copysign(ScalarMath<T>::sqrt(X.y * X.y + X.z * X.z), X.z);
  const T arm =
      X.x * race.cos_angle - (r - race.radius) * race.sin_angle - race.mid_x / race.cos_angle;
  const T cone = race.sigma() * (slope.angle * arm - slope.radius * race.cos_angle);
  if (race.shape == RaceSurface::Shape::Cone) return cone;
  const T n_x = at.n.x, n_r = at.meridian.x;
  const T along =
      -slope.angle * ((X.x - race.mid_x) * race.sin_angle + (r - race.mid_r) * race.cos_angle) -
      slope.land_offset;
  return race.sigma() * (n_x * race.sin_angle + n_r * race.cos_angle) * cone +
         (n_x * race.cos_angle - n_r * race.sin_angle) * along;
}

/// Of overlap_width (race_surface.hpp) over the land's offset, where the slice touches the land.
template <class T>
[[nodiscard, gnu::always_inline]] inline T width_slope_over_offset(const T& x, const T& width,
                                                                   double land_offset,
                                                                   double land_width) {
  using M = ScalarMath<T>;
  const double high = land_offset + 0.5 * land_width, low = land_offset - 0.5 * land_width;
  const T half = 0.5 * width;
  return M::pick(high - x < half, T(1.0), T(0.0)) - M::pick(low - x > -half, T(1.0), T(0.0));
}

}  // namespace adore::contact
