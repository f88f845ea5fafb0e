#pragma once

#include "statics/roller_forces.hpp"

#include <Eigen/Core>

/// One Newton step of a roller between races held in place, its tilt scaled to a length.
namespace adore::statics {

/// What the line search of one roller works on.
struct ScaledForces {
  Eigen::Vector3d force;
  Eigen::Matrix3d stiffness;
};
template <class S>
[[nodiscard]] ScaledForces scaled(const RollerModel& m, const Forces<S>& f,
                                  const Contacts& contacts);

/// The step as changes of RollerState::e.
[[nodiscard]] Eigen::Vector3d unscaled_step(const RollerModel& m, Eigen::Vector3d step);

/// Newton step. A contact with load Q is held along its normal by some Q/δ, but across it only by Q
/// over its radii: for light contacts that is 1e-8 of the former and less, and along a valley of
/// the potential that is as curved as the groove. Such weak modes, and those that nothing holds,
/// move only where their load is more than RollerModel::weak_floor, and only once the others are in
/// balance; without stiffness they walk along the load.
struct RollerStep {
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  bool balanced = false;  ///< but for the modes that stay
};
[[nodiscard]] RollerStep roller_step(const RollerModel& m, const ScaledForces& s, double k_ref,
                                     double rounding);

/// How the roller follows the race, -K⁻¹ ∂R/∂q, without the modes that nothing holds.
[[nodiscard]] Eigen::Matrix<double, 3, 5> race_following_matrix(const RollerModel& m,
                                                                const Forces<RollerDual>& f,
                                                                const Contacts& contacts);

}  // namespace adore::statics
