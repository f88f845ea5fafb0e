#include "dynamics/roller_start.hpp"

#include <cmath>

namespace adore::dynamics {

std::vector<ElementStartState> start_poses(const RollerStaticResult& scene,
                                           const bearing::Bearing& bearing) {
  std::vector<ElementStartState> out;
  const statics::RollerSolution& solution = scene.solution;
  const double offset = bearing.roller_mass_offset;
  for (const statics::StaticRoller& roller : solution.rollers) {
    ElementStartState pose;
    // On (e_x, e_r, e_θ): a positive skew moves the +x end against e_θ.
    const double cosine = std::cos(roller.skew);
    const Vec3 axis(std::cos(roller.tilt) * cosine, std::sin(roller.tilt) * cosine,
                    0.0 - std::sin(roller.skew));  // no -0
    pose.azimuth = roller.azimuth;
    pose.x = roller.x + offset * axis[0];
    pose.r = roller.r + offset * axis[1];
    pose.theta_dot = roller.balanced ? roller.orbital_speed : solution.orbital_speed;
    pose.omega = (roller.balanced ? roller.spin_speed : solution.spin_speed) * axis;
    pose.omega[0] += pose.theta_dot;
    // A positive tilt lifts the +x end: a rotation about -y.
    pose.attitude = multiply(multiply(quaternion_about(Vec3::UnitX(), roller.azimuth),
                                      quaternion_about(Vec3::UnitY(), -roller.tilt)),
                             quaternion_about(Vec3::UnitZ(), roller.skew));
    out.push_back(pose);
  }
  return out;
}

statics::StaticSolution static_start(const RollerStaticResult& scene,
                                     const bearing::Bearing& bearing) {
  statics::StaticSolution out;
  static_cast<statics::RaceResult&>(out) = scene.solution;
  const std::vector<ElementStartState> poses = start_poses(scene, bearing);
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
