#pragma once

#include "base/rotation.hpp"
#include "base/scalar_math.hpp"
#include "bearing/bearing.hpp"
#include "contact/race_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// Race surfaces that rollers run on, in the race's own frame: x along the race axis, r = √(y² +
/// z²) from it. SI, rad.
///
/// Depth φ(X) > 0 inside the race material; n = ∇φ, a unit vector that points from the roller into
/// the race. σ = +1 outer, -1 inner. All are exact signed distances [derived]:
///   cone, R(x) = R0 - x tan α: φ = σ((r - R0) cos α + x sin α), n = σ (sin α, cos α) in (x, r)
///   cylinder: the cone with α = 0
///   groove, circle of radius r_g about (x_g, R_g): l = √((x-x_g)² + (r-R_g)²), φ = l - r_g,
///     n = (x - x_g, r - R_g)/l
///   crowned cone, the cone with a circle of radius 1/k beyond the straight part L_c about the land
///     offset o, tangent there, that recedes from the roller: with φ0, n0 of the cone, l = (x -
///     x_m) cos α - (r - r_m) sin α along its generator g from mid contact, e = max(|l - o| -
///     L_c/2, 0) and S = √(k²e² + (1 - kφ0)²)
///     φ = (2φ0 - k (e² + φ0²))/(1 + S),  n = ((1 - kφ0) n0 ∓ k e g)/S
/// The groove form holds for both races and for R_g <= 0 (a self-aligning outer race has R_g = 0).
/// Undefined on the race axis (r = 0) and on the circle of groove centres: no roller gets there.
/// φ and n are computed in contact/slice_circle.hpp.
namespace adore::contact {

/// @throws InputError when a radius is not positive, an angle not in (-π/2, π/2) (all factories).
[[nodiscard]] RaceSurface cylinder_race(int side, double radius);
[[nodiscard]] RaceSurface cone_race(int side, double radius_at_x0, double half_angle);
[[nodiscard]] RaceSurface groove_race(int side, double groove_radius, double groove_x,
                                      double groove_centre_radius);
/// A cone or cylinder with a crown; curvature 0 leaves it as it is. @param land L_c >= 0 [m]
[[nodiscard]] RaceSurface crowned_race(const RaceSurface& cone, double crown_radius, double land);

/// R = pitch diameter/2 ± D/2 ± clearance/4, upper sign outer, clearance diametral [m].
[[nodiscard]] inline double cylindrical_race_radius(int side, double pitch_diameter,
                                                    double roller_diameter,
                                                    double clearance) noexcept {
  const double sigma = side == bearing::kOuter ? 1.0 : -1.0;
  return 0.5 * pitch_diameter + sigma * (0.5 * roller_diameter + 0.25 * clearance);
}

/// Where a race is: X_race = Aᵀ(X - c). Exact for any displacement; replaces all small-angle
/// formulas.
struct RacePose {
  Vec3 centre = Vec3::Zero();    ///< c, in the frame of the roller [m]
  Mat3 axes = Mat3::Identity();  ///< A, columns are the race axes in the frame of the roller
  [[nodiscard]] Vec3 point(const Vec3& X) const { return axes.transpose() * (X - centre); }
  [[nodiscard]] Vec3 direction(const Vec3& v) const { return axes.transpose() * v; }
  [[nodiscard]] Vec3 point_from_race(const Vec3& X_race) const { return centre + axes * X_race; }
  [[nodiscard]] Vec3 direction_from_race(const Vec3& v_race) const { return axes * v_race; }
};

/// Width of a slice on the land of the race, and its derivative over the land coordinate.
struct LandWidth {
  double width = 0.0, slope = 0.0;
};
/// @param x of the slice along the land (land_coordinate)
[[nodiscard]] inline LandWidth land_width(const RaceSurface& race, double x,
                                          double width) noexcept {
  const double on_land = overlap_width(x, width, race.land_offset, race.land_width);
  if (on_land <= 0.0) return {};
  const double high = race.land_offset + 0.5 * race.land_width - x;
  const double low = race.land_offset - 0.5 * race.land_width - x;
  return {on_land, (high < 0.5 * width ? -1.0 : 0.0) + (low > -0.5 * width ? 1.0 : 0.0)};
}

}  // namespace adore::contact
