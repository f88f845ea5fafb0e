#include "results/motion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::results {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOnAxis = 1e-12;  // [m], far below any clearance or deflection

Eigen::Matrix3d rotation(const scene::Quat& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

}  // namespace

Direction theta_phi(const Vec3& v) {
  const double size = v.norm();
  if (!(size > 0.0)) return {};
  return {std::atan2(v.z(), v.x()), std::asin(std::clamp(v.y() / size, -1.0, 1.0))};
}

OrbitMotion orbit_motion(const Vec3& position, const Vec3& velocity, const Vec3& acceleration) {
  OrbitMotion orbit;
  orbit.r = std::hypot(position.y(), position.z());
  if (orbit.r > kOnAxis) {
    const double sine = -position.y() / orbit.r, cosine = position.z() / orbit.r;
    const auto radial = [&](const Vec3& v) { return -sine * v.y() + cosine * v.z(); };
    const auto tangential = [&](const Vec3& v) { return -cosine * v.y() - sine * v.z(); };
    orbit.theta = std::atan2(0.0 - position.y(), position.z());  // no -0: -180 deg would be shown
    orbit.r_dot = radial(velocity);
    orbit.theta_dot = tangential(velocity) / orbit.r;
    orbit.r_ddot = radial(acceleration) + orbit.r * orbit.theta_dot * orbit.theta_dot;
    orbit.theta_ddot = (tangential(acceleration) - 2.0 * orbit.r_dot * orbit.theta_dot) / orbit.r;
    return orbit;
  }
  const double speed = std::hypot(velocity.y(), velocity.z());
  const Vec3& direction = speed > 0.0 ? velocity : acceleration;
  orbit.theta = std::atan2(0.0 - direction.y(), direction.z());
  if (direction.y() == 0.0 && direction.z() == 0.0) orbit.theta = 0.0;
  orbit.r_dot = speed;
  orbit.r_ddot =
      -std::sin(orbit.theta) * acceleration.y() + std::cos(orbit.theta) * acceleration.z();
  return orbit;
}

Vec3 body_x_axis(const scene::Quat& orientation) { return rotation(orientation).col(0); }

std::array<double, 3> transformation_angles(const scene::Quat& orientation) {
  const Eigen::Matrix3d R = rotation(orientation);
  const double sine = std::clamp(R(0, 2), -1.0, 1.0);
  if (std::abs(sine) > 1.0 - 1e-14)
    return {std::atan2(R(2, 1), R(1, 1)), std::copysign(kPi / 2.0, sine), 0.0};
  return {std::atan2(-R(1, 2), R(2, 2)), std::asin(sine), std::atan2(-R(0, 1), R(0, 0))};
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * kPi); }

double nearest_branch(double angle, double previous) {
  return angle + 2.0 * kPi * std::round((previous - angle) / (2.0 * kPi));
}

double faster_race_speed(const scene::Snapshot& snapshot) {
  std::array<double, 2> speed{};
  for (std::size_t race = 0; race < 2; ++race) {
    const scene::RaceSnapshot& body = snapshot.races[race];
    speed[race] = body.omega.dot(body_x_axis(body.orientation));
  }
  return std::abs(speed[0]) > std::abs(speed[1]) ? speed[0] : speed[1];
}

double cage_clearance_scale(const bearing::Cage& cage, double unit_length) {
  double sum = 0.0;
  int lands = 0;
  for (const bearing::GuideLand& land : cage.lands) {
    if (land.guide == bearing::GuideLand::Guide::None) continue;
    sum += land.clearance / 2.0;
    ++lands;
  }
  if (lands > 0 && sum > 0.0) return sum / lands;
  if (cage.pocket_clearance_1 > 0.0) return cage.pocket_clearance_1 / 2.0;
  return unit_length;
}

double average_wear_rate(const bearing::Material& material, double load_slip_integral,
                         double time) {
  if (!(time > 0.0) || !(material.hardness > 0.0)) return 0.0;
  return material.wear_coefficient / (material.hardness * time) * load_slip_integral;
}

}  // namespace adore::results
