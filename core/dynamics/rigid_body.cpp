#include "dynamics/rigid_body.hpp"

#include <Eigen/LU>

namespace adore::dynamics {

Vec3 euler_rate(const Mat3& inertia, const Vec3& omega, const Vec3& moment) noexcept {
  return inertia.inverse() * (moment - omega.cross(Vec3(inertia * omega)));
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
