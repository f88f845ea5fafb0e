#pragma once

#include "statics/dual.hpp"
#include "statics/race_equilibrium.hpp"
#include "statics/roller_model.hpp"

#include <Eigen/Core>

#include <array>

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

/// Derivatives over the roller (0: x, 1: r, 2: tilt) and the inner race (3-7).
using RollerDual = Dual<8>;
template <class S>
using Triple = std::array<S, 3>;

/// Pose of a race in the base frame.
template <class S>
struct RacePlace {
  Triple<S> centre{};
  Triple<S> axis{S(1.0), S(0.0), S(0.0)};
  std::array<S, 5> q{};  ///< displacement (linear kinematics)
};

[[nodiscard]] RacePlace<RollerDual> outer_place(const RollerModel& model);
/// With derivatives over q.
[[nodiscard]] RacePlace<RollerDual> inner_place(const Vec5& q);

struct RollerState {
  std::size_t number = 0;
  double sin = 0.0, cos = 1.0;                  ///< of the azimuth
  Eigen::Vector3d e = Eigen::Vector3d::Zero();  ///< x, r - d_m/2 [m], tilt + axis angle [rad]
  bool known = false;                           ///< e comes from an earlier equilibrium
  bool idle = false;                            ///< at rest and touching nothing
  Eigen::Matrix<double, 3, 5> follow = Eigen::Matrix<double, 3, 5>::Zero();  ///< de/dq
};

/// Everything about one roller at one pose.
struct RollerForces {
  std::array<RollerDual, 3> residual;  ///< generalised force on e: x, r, tilt [N, N, N m]
  std::array<RollerDual, 5> load;      ///< share of the load on the inner race [N, N m]
  double largest = 0.0;                ///< largest contact load [N]
  double total = 0.0;                  ///< sum of contact loads and the centrifugal force [N]
  bool flange_loaded = false;          ///< some flange pushes
};

struct RacePair {
  const RacePlace<RollerDual>& outer;
  const RacePlace<RollerDual>& inner;
};
/// `exact_derivatives`: with the curvature of flange gaps (roller_flanges.hpp).
[[nodiscard]] RollerForces roller_forces(const RollerModel& model, const RollerState& at,
                                         const RacePair& races, bool exact_derivatives = true);

/// Pose of a roller relative to race j: values of p.
[[nodiscard]] Vec4 relative_pose(const RollerModel& model, const RollerState& at, std::size_t j,
                                 const RacePair& races);

/// Finds the roller's equilibrium; `forces` are those there. Newton on a convex potential with a
/// line search on the directional derivative; directions that nothing holds or loads stay where
/// they are, loaded ones are walked until something touches. False when there is no equilibrium.
[[nodiscard]] bool solve_roller(const RollerModel& model, const RacePair& races, RollerState& state,
                                RollerForces& forces);

// The inner race on rollers: what race_equilibrium.hpp asks of an element set.
using RollerRace = RaceState<RollerState>;
[[nodiscard]] RaceScales race_scales(const RollerModel& model);
[[nodiscard]] double reference_stiffness(const RollerModel& model, double load);
[[nodiscard]] inline bool is_conservative(const RollerModel&) { return true; }
[[nodiscard]] bool update_race(const RollerModel& model, const Vec5& q, RollerRace& state);

}  // namespace adore::statics
