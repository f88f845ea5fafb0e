#include "results/motion.hpp"

#include "base/constants.hpp"
#include "base/rotation.hpp"

#include <cmath>

namespace adore::results {
namespace {

constexpr double kOnAxis = 1e-12;  // [m], far below any clearance or deflection

}  // namespace

DirectionAngles direction_angles(const Vec3& v) { return {direction_theta(v), direction_phi(v)}; }

double direction_theta(const Vec3& v) {
  if (!(v.squaredNorm() > 0.0)) return 0.0;
  return tilt_of_axis(Vec3(v.x(), v.y(), -v.z()).normalized())[0];
}

double direction_phi(const Vec3& v) {
  if (!(v.squaredNorm() > 0.0)) return 0.0;
  return tilt_of_axis(Vec3(v.x(), v.y(), -v.z()).normalized())[1];
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

Vec3 body_x_axis(const scene::Quat& orientation) {
  return rotation_matrix(normalize_quaternion(orientation)).col(0);
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

std::string_view name_of(CageLengthScale::Of of) {
  switch (of) {
    case CageLengthScale::Of::GuideLands:
      return "guide lands";
    case CageLengthScale::Of::Pockets:
      return "pockets";
    case CageLengthScale::Of::UnitOfLength:
      break;
  }
  return "unit of length";
}

CageLengthScale cage_length_scale(const bearing::Cage& cage, double unit_length) {
  double sum = 0.0;
  int lands = 0;
  for (const bearing::GuideLand& land : cage.lands) {
    if (land.guide == bearing::GuideLand::Guide::None) continue;
    sum += land.clearance / 2.0;
    ++lands;
  }
  if (lands > 0 && sum > 0.0) return {sum / lands, CageLengthScale::Of::GuideLands};
  if (cage.pocket_clearance_1 > 0.0)
    return {cage.pocket_clearance_1 / 2.0, CageLengthScale::Of::Pockets};
  return {unit_length, CageLengthScale::Of::UnitOfLength};
}

double average_wear_rate(const bearing::Material& material, double load_slip_integral,
                         double time) {
  if (!(time > 0.0) || !(material.hardness > 0.0)) return 0.0;
  return material.wear_coefficient / (material.hardness * time) * load_slip_integral;
}

}  // namespace adore::results
