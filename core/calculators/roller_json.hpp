#pragma once

#include "calculators/json_access.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_profile.hpp"
#include "contact/slice_contact.hpp"

/// Common parts of the roller families: inputs to values (keys in
/// tests/reference/rollers_README.md).
namespace adore::calculators {

[[nodiscard]] inline int race_from_json(const Json& j) {
  return j.at("side") == "outer" ? bearing::kOuter : bearing::kInner;
}

/// "roller" object, checked; sizes that a case leaves out are zero, a missing crown is straight.
[[nodiscard]] inline contact::RollerProfile roller_profile(const Json& j) {
  contact::RollerProfile p;
  p.kind = j.value("profile", "crowned") == "arc" ? contact::RollerProfile::Kind::Arc
                                                  : contact::RollerProfile::Kind::Crowned;
  p.diameter = get(j, "dia");
  p.length = get(j, "length");
  p.half_angle = j.value("half_angle", 0.0);
  if (j.contains("crown_radius")) p.crown_radius = get(j, "crown_radius");
  p.central_length = j.value("central_length", 0.0);
  p.land_offset = j.value("land_offset", 0.0);
  require(p.central_length <= p.length && std::abs(p.land_offset) <= 0.5 * p.length,
          fmt::format("the land of the roller (central_length {} m, land_offset {} m) is outside "
                      "its length of {} m. Enter smaller values.",
                      p.central_length, p.land_offset, p.length));
  p.corner_radius = {j.value("corner_radius_1", 0.0), j.value("corner_radius_2", 0.0)};
  contact::check_roller_profile(p);
  return p;
}

struct RollerAxisPose {
  Vec3 centre, axis;
};
[[nodiscard]] inline RollerAxisPose read_roller_axis_pose(const Json& pose) {
  return {Vec3(get(pose, "x"), 0.0, get(pose, "r")),
          contact::roller_axis(get(pose, "tilt"), get(pose, "skew"))};
}

}  // namespace adore::calculators
