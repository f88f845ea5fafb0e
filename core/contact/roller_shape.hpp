#pragma once

#include "bearing/rollers.hpp"
#include "contact/roller_profile.hpp"

#include <algorithm>

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
  if (rollers.shape == bearing::RollerShape::Logarithmic) {
    p.crown_radius = std::numeric_limits<double>::infinity();
    p.central_length = p.length;
  }
  return p;
}

}  // namespace adore::contact
