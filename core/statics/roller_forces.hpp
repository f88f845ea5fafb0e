#pragma once

#include "statics/roller_pose.hpp"

#include <array>

/// Forces of both races and their flanges on a roller, and what it hands on to the inner race.
///
/// From U(x', r', t, f) of slice_potential.hpp the force and the moment about C on the roller are
///   F = -(U_x A + U_r e + (U_t f - U_f t)/r' y'),   M = -a × (U_t e + U_f y')  [derived]
/// with the pose of roller_pose.hpp. Force on the inner race's shaft side: F and M + d × F about
/// the race's reference point.
namespace adore::statics {

/// What the races do to a roller, by relative coordinates.
struct Contacts {
  std::array<PairPotential, 2> race, flanges;
  double largest = 0.0;        ///< contact load [N]
  double total = 0.0;          ///< sum of contact loads and the centrifugal force [N]
  bool flange_loaded = false;  ///< some flange pushes
};
template <class S>
[[nodiscard]] Contacts contacts_at(const RollerModel& m, const RollerState& at,
                                   const Pose<S>& pose);

/// Flanges of race j. `with_curvature`: roller_flanges.hpp.
[[nodiscard]] PairPotential flange_potential(const RollerContactGeometry& body, std::size_t j,
                                             const Vec4& p, bool with_curvature);

/// What they make of it.
template <class S>
struct Forces {
  std::array<S, 3> residual;  ///< generalised force on the roller: x, r, tilt [N, N, N m]
  std::array<S, 5> load;      ///< share of the load on the inner race [N, N m]; RollerDual only
};
template <class S>
[[nodiscard]] Forces<S> forces_of(const RollerModel& m, const RollerState& at, const Pose<S>& pose,
                                  const Contacts& contacts);

}  // namespace adore::statics
