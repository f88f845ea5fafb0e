#include "dynamics/rigid_body.hpp"

#include <Eigen/LU>

namespace adore::dynamics {

Vec3 euler_rate(const Mat3& inertia, const Vec3& omega, const Vec3& moment) noexcept {
  return inertia.inverse() * (moment - omega.cross(Vec3(inertia * omega)));
}

RaceAccelerations race_accelerations(double mass, const Mat3& inertia, const Vec3& omega,
                                     const Vec3& force, const Vec3& moment,
                                     const RaceConstraints& constraints) noexcept {
  RaceAccelerations result;
  const Vec3 gyroscopic = omega.cross(Vec3(inertia * omega));
  // Rows of prescribed components become α = given; the others stay Euler's.
  Mat3 rows = inertia;
  Vec3 right = moment - gyroscopic;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    result.acceleration[k] =
        constraints.translation[axis] ? constraints.acceleration[k] : force[k] / mass;
    if (!constraints.rotation[axis]) continue;
    rows.row(k) = Vec3::Unit(k).transpose();
    right[k] = constraints.angular_acceleration[k];
  }
  result.angular_acceleration = rows.inverse() * right;
  result.holding_force = mass * result.acceleration - force;
  result.holding_moment = inertia * result.angular_acceleration + gyroscopic - moment;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    if (!constraints.translation[axis]) result.holding_force[k] = 0.0;
    if (!constraints.rotation[axis]) result.holding_moment[k] = 0.0;
  }
  return result;
}

CageStart cage_start(double epicyclic, double speed_ratio, double whirl_ratio, const Vec3& locus,
                     const Vec3& offset, const Vec3& angles) noexcept {
  CageStart start;
  start.cage_speed = speed_ratio * epicyclic;
  start.whirl_speed = whirl_ratio * start.cage_speed;
  start.mass_centre = locus + offset;
  start.mass_centre_velocity = start.whirl_speed * Vec3::UnitX().cross(offset);
  start.orientation = quaternion_from_angles(angles);
  start.omega_body = passive_matrix(angles) * Vec3(start.cage_speed, 0.0, 0.0);
  return start;
}

}  // namespace adore::dynamics
