#include "dynamics/system_pockets.hpp"

#include "base/errors.hpp"
#include "statics/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

double nominal_cage_speed(const bearing::Bearing& bearing) noexcept {
  const double gamma =
      bearing.balls.diameter * std::cos(bearing.balls.contact_angle) / bearing.balls.pitch_diameter;
  return statics::epicyclic_speed(bearing.speed[0], bearing.speed[1], gamma);
}

PocketSet::PocketSet(const bearing::Bearing& bearing, const std::vector<double>& azimuths) {
  const bearing::Cage& cage = *bearing.cage;
  const double D = bearing.balls.diameter;
  demand(cage.pocket == bearing::PocketShape::Cylindrical && cage.cone_angle == 0.0,
         "pocket contact is written for cylindrical pockets of a straight cage");
  ball_radius_ = 0.5 * D;
  pitch_radius_ = 0.5 * bearing.balls.pitch_diameter;
  rotation_sign_ = nominal_cage_speed(bearing) < 0.0 ? -1.0 : 1.0;
  const auto [low, high] =
      contact::wall_height(cage.outer_diameter, cage.inner_diameter, bearing.balls.pitch_diameter);
  wall_ = {0.5 * (D + cage.pocket_clearance_1), low, high};
  hole2_ = wall_.wall_radius * wall_.wall_radius;
  const double play = std::max(wall_.wall_radius - ball_radius_, 0.0);
  play2_ = play * play;
  law_ = contact::ball_pocket_law(bearing.ball_material, cage.material, D,
                                  {-1.0 / wall_.wall_radius, 0.0})
             .law;
  for (const double psi : azimuths) {
    sin_.push_back(std::sin(psi));
    cos_.push_back(std::cos(psi));
  }
  qx_.resize(azimuths.size());
  qy_.resize(azimuths.size());
  qz_.resize(azimuths.size());
}

inline void PocketSet::locate_one(const Evaluation& e, std::size_t i) noexcept {
  const Mat3& R = e.cage.to_base;
  const Vec3& p = e.cage.position;
  const BallArrays& b = e.balls;
  const double dx = b.x[i] - p[0];
  const double dy = -b.r[i] * b.sin_theta[i] - p[1];
  const double dz = b.r[i] * b.cos_theta[i] - p[2];
  const double cy = R(0, 1) * dx + R(1, 1) * dy + R(2, 1) * dz;
  const double cz = R(0, 2) * dx + R(1, 2) * dy + R(2, 2) * dz;
  qx_[i] = R(0, 0) * dx + R(1, 0) * dy + R(2, 0) * dz;
  qy_[i] = cos_[i] * cy + sin_[i] * cz;
  qz_[i] = cos_[i] * cz - sin_[i] * cy - pitch_radius_;
}

void PocketSet::locate(const Evaluation& e) noexcept {
  for (std::size_t i = 0; i < sin_.size(); ++i) locate_one(e, i);
}

void PocketSet::locate(const Evaluation& e, std::size_t i) noexcept { locate_one(e, i); }

PocketContactSnapshot PocketSet::report(std::size_t i) const {
  const contact::WallPoint wall = wall_point(i);
  return {contact::load(law_, -wall.gap), wall.gap, contact::pocket_theta(wall.m, rotation_sign_),
          contact::pocket_phi(wall.m)};
}

template <bool Traction>
void PocketBlock<Traction>::apply(Evaluation& e) noexcept {
  set_.locate(e);
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (set_.surely_open(i) && set_.inside(i)) continue;
    if (!set_.inside(i)) {
      e.valid = false;
      return;
    }
    const contact::WallPoint wall = set_.wall_point(i);
    if (wall.gap >= 0.0) continue;
    const PocketAction action = pocket_action<Traction>(set_, friction_, e, i, wall);
    if constexpr (Traction) {
      const Vec3 moment = e.to_cylindrical(i, action.arm.cross(action.friction));
      e.M_x[i] += moment[0];
      e.M_r[i] += moment[1];
      e.M_theta[i] += moment[2];
      e.heat_pockets += action.heat;
      e.wear_cage += action.N * action.slip;
    }
    const Vec3 force = e.to_cylindrical(i, action.on_ball);
    e.F_x[i] += force[0];
    e.F_r[i] += force[1];
    e.F_theta[i] += force[2];
    e.cage.add_force(-action.on_ball, action.point);
    e.elastic += contact::energy(set_.law(), -wall.gap);
  }
}

template class PocketBlock<false>;
template class PocketBlock<true>;

}  // namespace adore::dynamics
