#pragma once

#include "bearing/rollers.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_flange.hpp"

/// Races and flanges of rollers after fits, temperatures and speeds. SI.
///
/// A race keeps one plane across its axis, x = x_h, and grows about the point (x_h, 0) [choice,
/// decision 140]: the thermal strain g scales it, what fit pressure and rotation add moves it
/// radially as a whole. With u the whole outward displacement at the mid contact (x_m, r_m),
///   x' = x_h + (1 + g)(x - x_h),  r' = (1 + g) r + u - g r_m.
/// Cone angles stay, radii of curvature grow by 1 + g. Both races share x_h, so that one
/// temperature of everything changes no contact: the plane of the outer groove's centres for
/// barrels (the middle of a bearing whose outer race is a sphere), the middle of the rollers, x =
/// 0, for all others.
namespace adore::contact {

struct RaceGrowth {
  double held_x = 0.0;  ///< x_h [m]
  double strain = 0.0;  ///< g
  double lift = 0.0;    ///< u - g r_m [m]

  [[nodiscard]] double x(double x_bench) const noexcept {
    return held_x + (1.0 + strain) * (x_bench - held_x);
  }
  [[nodiscard]] double r(double r_bench) const noexcept { return (1.0 + strain) * r_bench + lift; }
};

/// @param race on the bench
[[nodiscard]] inline RaceGrowth race_growth(const bearing::RacewayGrowth& growth,
                                            const RaceSurface& race, double held_x) noexcept {
  return {held_x, growth.strain, growth.radial - growth.strain * race.mid_r};
}

[[nodiscard]] inline RaceSurface grown(RaceSurface race, const RaceGrowth& growth) noexcept {
  if (race.shape != RaceSurface::Shape::Groove) {
    // The point of x = 0 has moved to growth.x(0): back to x = 0 along the generator.
    race.radius = growth.r(race.radius) + race.sin_angle / race.cos_angle * growth.x(0.0);
    race.crown_curvature /= 1.0 + growth.strain;
    race.crown_land *= 1.0 + growth.strain;
  } else {
    race.groove_radius *= 1.0 + growth.strain;
    race.groove_x = growth.x(race.groove_x);
    race.groove_centre_radius = growth.r(race.groove_centre_radius);
  }
  race.mid_x = growth.x(race.mid_x);
  race.mid_r = growth.r(race.mid_r);
  return race;
}

[[nodiscard]] inline Flange grown(Flange flange, const RaceGrowth& growth) noexcept {
  flange.root_x = growth.x(flange.root_x);
  flange.root_r = growth.r(flange.root_r);
  flange.height *= 1.0 + growth.strain;
  return flange;
}

}  // namespace adore::contact
