#include "contact/race_errors.hpp"

namespace adore::contact {

RaceSurface race_with_error(const RaceSurface& ideal, const LocalRaceError& error,
                            double curvature_diameter,
                            const std::array<double, 2>& nominal_normal) noexcept {
  RaceSurface race = ideal;
  race.land_offset += error.land_offset;
  if (race.shape == RaceSurface::Shape::Groove) {
    const double growth = error.curvature_factor * curvature_diameter;
    race.groove_radius += growth;
    race.groove_x -= growth * nominal_normal[0];
    race.groove_centre_radius += error.radius - growth * nominal_normal[1];
    return race;
  }
  const double mid_radius =
      ideal.radius - ideal.mid_x * ideal.sin_angle / ideal.cos_angle + error.radius;
  if (error.taper != 0.0) {
    const double angle = std::atan2(ideal.sin_angle, ideal.cos_angle) - error.taper;
    race.cos_angle = std::cos(angle);
    race.sin_angle = std::sin(angle);
  }
  race.radius = mid_radius + race.mid_x * race.sin_angle / race.cos_angle;
  return race;
}

}  // namespace adore::contact
