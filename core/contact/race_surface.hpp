#pragma once

#include "base/rotation.hpp"
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
/// The groove form holds for both races and for R_g <= 0 (a self-aligning outer race has R_g = 0).
/// Undefined on the race axis (r = 0) and on the circle of groove centres: no roller gets there.
namespace adore::contact {

/// @throws InputError when a radius is not positive, an angle not in (-π/2, π/2) (all factories).
[[nodiscard]] RaceSurface cylinder_race(int side, double radius);
[[nodiscard]] RaceSurface cone_race(int side, double radius_at_x0, double half_angle);
[[nodiscard]] RaceSurface groove_race(int side, double groove_radius, double groove_x,
                                      double groove_centre_radius);

/// R = pitch diameter/2 ± D/2 ± clearance/4, upper sign outer, clearance diametral [m].
[[nodiscard]] inline double cylinder_radius(int side, double pitch_diameter, double roller_diameter,
                                            double clearance) noexcept {
  const double sigma = side == bearing::kOuter ? 1.0 : -1.0;
  return 0.5 * pitch_diameter + sigma * (0.5 * roller_diameter + 0.25 * clearance);
}

struct DepthAndNormal {
  double depth = 0.0;  ///< φ [m]
  Vec3 normal;         ///< n, race frame
};
/// φ and n at a point in the race frame. Hot path: no throw, no allocation.
[[nodiscard]] inline DepthAndNormal race_depth(const RaceSurface& race, const Vec3& X) noexcept {
  const double r = std::sqrt(X[1] * X[1] + X[2] * X[2]);
  double phi = 0.0, nx = 0.0, nr = 0.0;
  if (race.shape == RaceSurface::Shape::Cone) {
    const double sigma = race.sigma();
    phi = sigma * ((r - race.radius) * race.cos_angle + X[0] * race.sin_angle);
    nx = sigma * race.sin_angle;
    nr = sigma * race.cos_angle;
  } else {
    const double x = X[0] - race.groove_x, y = r - race.groove_centre_radius;
    const double l = std::sqrt(x * x + y * y);
    phi = l - race.groove_radius;
    nx = x / l;
    nr = y / l;
  }
  const double over_r = nr / r;
  return {phi, Vec3(nx, X[1] * over_r, X[2] * over_r)};
}

/// Direction of n without its length, for iterations that need no more: one root and no division.
[[nodiscard]] inline Vec3 race_direction(const RaceSurface& race, const Vec3& X) noexcept {
  const double r = std::sqrt(X[1] * X[1] + X[2] * X[2]);
  double x = race.sin_angle, y = race.cos_angle;
  if (race.shape == RaceSurface::Shape::Cone) {
    const double sigma = race.sigma();
    x *= sigma;
    y *= sigma;
  } else {
    x = X[0] - race.groove_x;
    y = r - race.groove_centre_radius;
  }
  return {x * r, y * X[1], y * X[2]};
}

/// Curvature of the race around its axis where its normal is n, to be added to 1/ρ of the roller
/// [1/m]: -n_r/r, that is +cos α/r inner, -cos α/r outer.
[[nodiscard]] inline double race_rolling_curvature(const Vec3& normal, const Vec3& X) noexcept {
  return -(normal[1] * X[1] + normal[2] * X[2]) / (X[1] * X[1] + X[2] * X[2]);
}

/// Where a race is: X_race = Aᵀ(X - c). Exact for any displacement; replaces all small-angle
/// formulas.
struct RacePose {
  Vec3 centre = Vec3::Zero();    ///< c, in the frame of the roller [m]
  Mat3 axes = Mat3::Identity();  ///< A, columns are the race axes in the frame of the roller
  [[nodiscard]] Vec3 point(const Vec3& X) const { return axes.transpose() * (X - centre); }
  [[nodiscard]] Vec3 direction(const Vec3& v) const { return axes.transpose() * v; }
  [[nodiscard]] Vec3 point_back(const Vec3& X_race) const { return centre + axes * X_race; }
  [[nodiscard]] Vec3 direction_back(const Vec3& v_race) const { return axes * v_race; }
};

/// Coordinate of a point along the nominal generator of the race from mid contact, positive towards
/// +x [m]; for cylinders x - x_mid. Errors of the race do not turn it.
[[nodiscard]] inline double land_coordinate(const RaceSurface& race, const Vec3& X_race) noexcept {
  const double x = (X_race[0] - race.mid_x) * race.along_x;
  if (race.along_r == 0.0) return x;
  const double r = std::sqrt(X_race[1] * X_race[1] + X_race[2] * X_race[2]);
  return x + (r - race.mid_r) * race.along_r;
}

/// Width of a slice of width w at x that lies on a land of width B about o: overlap of [x ± w/2]
/// with [o ± B/2] [m]. Continuous in x, so that the load stays continuous when a roller slides over
/// the edge of the land [choice].
[[nodiscard]] inline double overlap_width(double x, double width, double land_offset,
                                          double land_width) noexcept {
  const double upper = std::min(0.5 * width, land_offset + 0.5 * land_width - x);
  const double lower = std::max(-0.5 * width, land_offset - 0.5 * land_width - x);
  return std::max(upper - lower, 0.0);
}

}  // namespace adore::contact
