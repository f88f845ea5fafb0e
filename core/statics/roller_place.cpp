#include "statics/roller_place.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace adore::statics {
namespace {

/// Largest penetration of a roller into race j; negative: the gap.
double penetration(const RollerModel& m, const RollerState& at, std::size_t j, const Vec5& q) {
  const Vec4 p = relative_pose(m, at, j, q);
  const RollerContactGeometry& body = m.body(at.number);
  PairPotential unused;
  std::vector<SliceResult> each(m.results(body));
  add_race(m, body, j, p, unused, each);
  return std::max_element(each.begin(), each.end(),
                          [](const auto& a, const auto& b) { return a.delta < b.delta; })
      ->delta;
}

}  // namespace

Eigen::Vector3d middle_roller_position(const RollerModel& m, const RollerState& state,
                                       const Vec5& q) {
  const double moved = 0.5 * (q(2) * state.cos - q(1) * state.sin);
  const double turned = -0.5 * (q(3) * state.cos + q(4) * state.sin);
  const double from_outer = -0.5 * (m.outer_tilt[0] * state.cos + m.outer_tilt[1] * state.sin);
  const bool held = m.rollers.axis_angle != 0.0;
  return {held ? 0.5 * q(0) : 0.0, moved, turned + from_outer};
}

Eigen::Vector3d initial_roller_position(const RollerModel& m, const RollerState& state,
                                        const Vec5& q) {
  if (m.moving) {
    RollerState seated = state;
    seated.e = {0.0, 0.0, -(m.outer_tilt[0] * state.cos + m.outer_tilt[1] * state.sin)};
    const double missing = line_approach(m, m.centrifugal) - penetration(m, seated, 0, q);
    seated.e(0) = missing * std::sin(m.rollers.race_angle[0]);
    seated.e(1) = missing * std::cos(m.rollers.race_angle[0]);
    if (penetration(m, seated, 1, q) <= 0.0) {
      return seated.e;
    }
  }
  return middle_roller_position(m, state, q);
}

Vec4 relative_pose(const RollerModel& m, const RollerState& at, std::size_t j, const Vec5& q) {
  return relative(m, roller_at<double>(m, at), at, races_at<double>(m, q)[j], j).values();
}

}  // namespace adore::statics
