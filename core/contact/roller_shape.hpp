#pragma once

#include "bearing/rollers.hpp"
#include "contact/roller_profile.hpp"

#include <algorithm>
#include <cmath>

/// From the rollers of a bearing to the profile that contact geometry reads.
namespace adore::contact {

/// A nominal roller plus what one roller has more. A logarithmic roller is straight here: its drop
/// is taken off the slices.
[[nodiscard]] inline RollerProfile roller_profile(const bearing::RollerGeometry& rollers,
                                                  const bearing::RollerDeviation& more = {}) {
  RollerProfile p;
  p.kind = rollers.shape == bearing::RollerShape::Arc ? RollerProfile::Kind::Arc
                                                      : RollerProfile::Kind::Crowned;
  p.diameter = rollers.diameter + more.diameter;
  p.length = rollers.length + more.length;
  p.half_angle = rollers.half_angle;
  p.crown_radius = rollers.crown_radius + more.crown_radius;
  p.central_length = std::min(rollers.central_length + more.central_length, p.length);
  p.land_offset = more.land_offset;
  p.corner_radius = rollers.corner_radius;
  p.end_radius = rollers.end_radius;
  p.form = more.form;
  if (rollers.shape == bearing::RollerShape::Logarithmic) {
    p.crown_radius = std::numeric_limits<double>::infinity();
    p.central_length = p.length;
  }
  return p;
}

/// Relative curvatures of a roller and a race at mid contact [1/m].
struct RollerRaceCurvature {
  double rolling = 0.0;  ///< 2 cos ν/D -+ cos α/R, upper sign outer race
  double along = 0.0;    ///< 1/Rc - 1/r_g along the roller; <= 0: no crown that is rounder
};
/// @param groove_radius r_g; infinite for a straight raceway [m]
[[nodiscard]] inline RollerRaceCurvature roller_race_curvature(
    const bearing::RollerGeometry& rollers, const RollerProfile& profile, int race,
    double groove_radius) {
  const double of_race =
      std::cos(rollers.race_angle[static_cast<std::size_t>(race)]) / rollers.race_radius(race);
  return {2.0 / profile.diameter * std::cos(profile.half_angle) + (race == 0 ? -of_race : of_race),
          1.0 / profile.crown_radius - 1.0 / groove_radius};
}

}  // namespace adore::contact
