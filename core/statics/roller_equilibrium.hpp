#pragma once

#include "statics/race_equilibrium.hpp"
#include "statics/roller_model.hpp"

#include <Eigen/Core>

/// Equilibrium of one roller between two races held in place, and what it hands on to the inner
/// race.
///
/// Azimuth frame: x along the bearing, z radially outward, y = z × x. Pose relative to race (centre
/// c, axis A): d = C - c, x' = d·A, r' e = d - x'A, y' = e × A, t = a·e, f = a·y'. From U(x', r',
/// t, f) the force and the moment about C on the roller are  [derived]
///   F = -(U_x A + U_r e + (U_t f - U_f t)/r' y'),   M = -a × (U_t e + U_f y').
/// An inner race that is not round has R(ψ) = R + R' (ψ - ψ_k) near roller k: U at r' - R' (ψ -
/// ψ_k), so that its normals lean and push sideways. The slope of the outer race pushes the roller
/// against its cage, which has no effect here. Equilibrium: F_x = 0, F_r + F_c = 0, and about y:
/// M_C - M_G(F_c) = gyroscopic moment. Force on the inner race's shaft side: F and M + d × F about
/// the race's reference point.
namespace adore::statics {

struct RollerState {
  std::size_t number = 0;
  double sin = 0.0, cos = 1.0;                  ///< of the azimuth
  Eigen::Vector3d e = Eigen::Vector3d::Zero();  ///< x, r - d_m/2 [m], tilt + axis angle [rad]
  bool known = false;                           ///< e comes from an earlier equilibrium
  bool idle = false;                            ///< at rest and touching nothing
  Eigen::Matrix<double, 3, 5> follow = Eigen::Matrix<double, 3, 5>::Zero();  ///< de/dq
};

/// Moves the roller with the inner race, unless that is a long way.
void follow_race(const RollerModel& model, const Vec5& change, RollerState& state);

/// Pose of a roller relative to race j where the inner race is at q: p of slice_potential.hpp.
[[nodiscard]] Vec4 relative_pose(const RollerModel& model, const RollerState& at, std::size_t j,
                                 const Vec5& q);

// The inner race on rollers: what race_equilibrium.hpp asks of an element set.
using RollerRace = RaceState<RollerState>;
[[nodiscard]] RaceScales race_scales(const RollerModel& model);
[[nodiscard]] double reference_stiffness(const RollerModel& model, double load);
[[nodiscard]] inline bool is_conservative(const RollerModel&) { return true; }
[[nodiscard]] inline double first_accuracy(const RollerModel&) { return 1e-3; }
[[nodiscard]] bool update_race(const RollerModel& model, const Vec5& q, RollerRace& state,
                               double accuracy = 0.0);

}  // namespace adore::statics
