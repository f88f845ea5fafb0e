#pragma once

#include "base/scalar_math.hpp"

#include <limits>

/// Shape of a raceway for rollers as plain numbers: what race_surface.hpp states, for kernels too,
/// which see no header with inline library code.
namespace adore::contact {

struct RaceSurface {
  enum class Shape : unsigned char { Cone, Groove, CrownedCone } shape = Shape::Cone;
  int side = 0;                             ///< bearing::Race
  double radius = 0.0;                      ///< R0 at x = 0, cone and cylinder [m]
  double cos_angle = 1.0, sin_angle = 0.0;  ///< of α, radius falls towards +x; cone and cylinder
  double groove_radius = 0.0, groove_x = 0.0,
         groove_centre_radius = 0.0;  ///< r_g, x_g, R_g, groove only [m]
  // Land: limits where a roller can touch.
  double land_width = std::numeric_limits<double>::infinity();  ///< B along the generator [m]
  double land_offset = 0.0;                        ///< o_r from mid contact towards +x [m]
  double crown_curvature = 0.0, crown_land = 0.0;  ///< k, L_c, crowned cone only [1/m, m]
  double mid_x = 0.0, mid_r = 0.0;      ///< mid contact, where land coordinates begin [m]
  double along_x = 1.0, along_r = 0.0;  ///< unit vector of the nominal generator, (cos α, -sin α)

  [[nodiscard, gnu::always_inline]] double sigma() const noexcept { return side == 0 ? 1.0 : -1.0; }
};

/// Width of a slice of width w at x that lies on a land of width B about o: overlap of [x ± w/2]
/// with [o ± B/2] [m]; of numbers or vectors. Continuous in x, so that the load stays continuous
/// when a roller slides over the edge of the land [choice].
template <class T>
[[nodiscard, gnu::always_inline]] inline T overlap_width(const T& x, const T& width,
                                                         double land_offset, double land_width) {
  using M = ScalarMath<T>;
  const double high = land_offset + 0.5 * land_width, low = land_offset - 0.5 * land_width;
  const T half = 0.5 * width;
  return M::max(M::min(half, high - x) - M::max(-half, low - x), T(0.0));
}

/// Coordinate along the generator of a cone from mid contact, positive towards +x [m], of a contact
/// point at x on its axis. Land limits are for cones and cylinders: grooves have none.
template <class T>
[[nodiscard, gnu::always_inline]] inline T land_coordinate(const RaceSurface& race, const T& x) {
  return (x - race.mid_x) / race.cos_angle;
}

}  // namespace adore::contact
