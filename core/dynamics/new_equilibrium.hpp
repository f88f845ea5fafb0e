#pragma once

#include "dynamics/system.hpp"
#include "statics/roller_statics.hpp"

#include <span>
#include <string>

/// A bearing in motion whose equilibrium changes at once: thermal step, growth of the rings during
/// a speed ramp, another load, speed, geometry or material at a continuation, start from the state
/// of another mode. Its state is split into
///   place = quasi-static place + departure.
/// The quasi-static places are those of statics/element_places.hpp at the present azimuths: of the
/// inner race under its loads where it moves under them (free races, mode 2), else where it is
/// prescribed; of the elements with the race where it is. They move to the new equilibrium at once,
/// as in a change that is slow against the contact vibrations. Departures (vibration, whirl) are
/// carried over. Loads that are specified stay specified.
///
/// Departures of a race shrink by √(k_old/k_new) of its stiffness k, which keeps their energy; they
/// do not grow. Departures of an element shrink until its contact loads are no larger than before
/// the change and in the new equilibrium, each by 10 %: a departure in a gap becomes none in a
/// contact.
/// Velocities and spins stay where the races keep their speeds. Where they change, speeds of pure
/// rolling take their new values, and departures from them (slip, whirl of the cage) are scaled by
/// the ratio of the race speeds, at most 1.
///
/// A cage of one piece keeps its relative place in clearances that become smaller (guide lands,
/// pockets along the pitch circle), so that growth presses no body into another one.
///
/// Excess energy: potential energy of the departures at constant angular momentum of the orbits,
/// after the change less before it. It is what the change itself puts into vibration [derived].
///
/// Limits: segments of a cage and axial clearances stay where they are; friction, forces of the
/// cage and loads of user routines enter the difference of both equilibria to first order only;
/// waves of races are those under the nominal azimuths; two free races share no displacement: the
/// inner one takes it.
namespace adore::dynamics {

struct EquilibriumChange {
  bool moved = false;
  std::string why_not;         ///< reason for a missing equilibrium [a clause]
  double largest_shift = 0.0;  ///< of an element or the race [m]
  double excess = 0.0;         ///< [J]
  double elastic = 0.0;        ///< larger elastic energy of both equilibria, with a floor [J]
  [[nodiscard]] double ratio() const noexcept { return elastic > 0.0 ? excess / elastic : 0.0; }
};

/// A system with what its equilibrium depends on. The plan outlives this.
struct EquilibriumContext {
  System& system;
  const ScenePlan& plan;
  statics::BallStaticsOptions balls;  ///< with the laws of the motion
  statics::RollerOptions rollers;
};

/// @param y_before state of `before` at t_before
/// @param y state of `after` at t: as y_before, its races where `after` prescribes them. Changed.
[[nodiscard]] EquilibriumChange move_to_equilibrium(const EquilibriumContext& before,
                                                    double t_before,
                                                    std::span<const double> y_before,
                                                    const EquilibriumContext& after, double t,
                                                    std::span<double> y);

/// Excess energy of a start: of the departures of y from its equilibrium. Velocities have no part:
/// those that the deck specifies are exempt.
[[nodiscard]] EquilibriumChange assess_start_excess_energy(const EquilibriumContext& scene,
                                                           double t, std::span<const double> y);

/// Books a change between two steps in the integrals of effect "thermal steps": stored energy and
/// momenta after less before. Integrals of y are those of y_before.
/// @throws SolverError when a state is not valid
void book_change(System& before, std::span<const double> y_before, System& after, double t,
                 std::span<double> y);

/// Above the first ratio a change is reported, above the second it is an error.
inline constexpr double kExcessWarned = 0.1, kExcessRefused = 1.0;

}  // namespace adore::dynamics
