#include "dynamics/rigid_body.hpp"

#include <Eigen/LU>

namespace adore::dynamics {

Vec3 euler_rate(const Mat3& inertia, const Vec3& omega, const Vec3& moment) noexcept {
  return inertia.inverse() * (moment - omega.cross(Vec3(inertia * omega)));
}

RaceAccelerations race_accelerations(double mass, const Mat3& inertia, const Vec3& omega,
                                     const Vec3& force, const Vec3& moment,
                                     const RaceConstraints& constraints) noexcept {
  return constrained_accelerations({mass, inertia}, omega, force, moment, constraints);
}

RaceAccelerations constrained_accelerations(const ConstrainedBody& body, const Vec3& omega,
                                            const Vec3& force, const Vec3& moment,
                                            const RaceConstraints& constraints) noexcept {
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  const Vec3& c = body.arm;
  const Mat3& A = body.axes;
  Mat3 cross;  // cross v = c × v
  cross << 0.0, -c[2], c[1], c[2], 0.0, -c[0], -c[1], c[0], 0.0;
  const Mat3 about_p = body.inertia - body.mass * cross * cross;
  // Unknowns: acceleration of P in base axes, angular acceleration along the axes.
  Mat6 whole;
  whole.topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
  whole.topRightCorner<3, 3>() = -body.mass * cross * A;
  whole.bottomLeftCorner<3, 3>() = body.mass * A.transpose() * cross;
  whole.bottomRightCorner<3, 3>() = A.transpose() * about_p * A;
  Vec6 load;
  load.head<3>() = force - body.mass * omega.cross(Vec3(omega.cross(c)));
  load.tail<3>() = A.transpose() * (moment - omega.cross(Vec3(about_p * omega)));
  Mat6 rows = whole;
  Vec6 right = load;
  std::array<bool, 6> held{};
  for (int k = 0; k < 6; ++k) {
    const auto axis = static_cast<std::size_t>(k % 3);
    const bool turn = k >= 3;
    held[static_cast<std::size_t>(k)] =
        turn ? constraints.rotation[axis] : constraints.translation[axis];
    if (!held[static_cast<std::size_t>(k)]) continue;
    rows.row(k) = Vec6::Unit(k).transpose();
    right[k] = turn ? constraints.angular_acceleration[k - 3] : constraints.acceleration[k];
  }
  const Vec6 rates = rows.partialPivLu().solve(right);
  Vec6 holding = whole * rates - load;
  for (int k = 0; k < 6; ++k)
    if (!held[static_cast<std::size_t>(k)]) holding[k] = 0.0;
  return {rates.head<3>(), A * rates.tail<3>(), holding.head<3>(), A * holding.tail<3>()};
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
