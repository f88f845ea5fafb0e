#include "dynamics/roller_start.hpp"

#include <cmath>

namespace adore::dynamics {

std::vector<ElementPose> start_poses(const RollerScene& scene, const bearing::Bearing& bearing) {
  std::vector<ElementPose> out;
  const statics::RollerSolution& solution = scene.solution;
  const double offset = bearing.roller_mass_offset;
  for (const statics::StaticRoller& roller : solution.rollers) {
    ElementPose pose;
    const double along = std::cos(roller.tilt), outward = std::sin(roller.tilt);
    pose.azimuth = roller.azimuth;
    pose.x = roller.x + offset * along;
    pose.r = roller.r + offset * outward;
    pose.theta_dot = solution.orbital_speed;
    pose.omega = solution.spin_speed * Vec3(along, outward, 0.0);
    pose.omega[0] += solution.orbital_speed;
    // A positive tilt lifts the +x end: a rotation about -y.
    pose.attitude = multiply(quaternion_about(Vec3::UnitX(), roller.azimuth),
                             quaternion_about(Vec3::UnitY(), -roller.tilt));
    out.push_back(pose);
  }
  return out;
}

statics::StaticSolution static_start(const RollerScene& scene, const bearing::Bearing& bearing) {
  statics::StaticSolution out;
  static_cast<statics::RaceResult&>(out) = scene.solution;
  const std::vector<ElementPose> poses = start_poses(scene, bearing);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const statics::StaticRoller& roller = scene.solution.rollers[i];
    statics::StaticBall element;
    element.azimuth = poses[i].azimuth;
    element.x = poses[i].x;
    element.r = poses[i].r;
    element.orbital_speed = poses[i].theta_dot;
    element.omega_x = poses[i].omega[0];
    element.omega_r = poses[i].omega[1];
    element.omega_theta = poses[i].omega[2];
    for (std::size_t j = 0; j < 2; ++j) {
      element.Q[j] = roller.race[j].load;
      element.alpha[j] = roller.race[j].contact_angle;
      element.delta[j] = roller.race[j].delta;
    }
    out.balls.push_back(element);
  }
  return out;
}

}  // namespace adore::dynamics
