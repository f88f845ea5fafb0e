#pragma once

#include "statics/roller_equilibrium.hpp"
#include "statics/roller_statics.hpp"

/// Rollers of an equilibrium in balance of friction. SI.
///
/// Without friction a roller has no skew. The friction of its rib turns it until skew answers it:
/// skew makes both races push it along its axis to opposite sides, which tilts it and moves the
/// loads along it. Here each roller with load at both races has place, tilt, skew, spin and orbit
/// from G(u, q) = 0, the balance of roller_motion_forces.hpp, at the displacement q of the inner
/// race. Linearly implicit steps of friction_flow.hpp find it, from the place without friction and
/// the skew and speeds of the roller before. Its share L(u, q) of the load follows the race with
///   dL/dq = L_q - L_u G_u⁻¹ G_q,
/// so that displacement, loads and stiffness of the bearing (race_equilibrium.hpp), moments,
/// pressures and lives follow. Derivatives are differences where the search begins and where it
/// ends; between them each evaluation corrects them (Broyden's update). A roller keeps its
/// equilibrium without friction where there is no balance, one with more than kLargestSkew, or one
/// that skew leaves while the other unknowns follow at once (∂G_ψ/∂ψ > 0 then:
/// condensed_slope()); where a race or the search for the bearing loses it; and after
/// kMaxEvaluations evaluations. RollerSolution::friction reports that. Cylindrical rollers that no
/// flange loads stay where they are along the bearing. Not balanced: barrels without a flange,
/// which skew until their pocket stops them (decision 261); one elliptical contact per race and
/// linear kinematics, which motion does not have either.
namespace adore::statics {

/// False: rollers have the equilibrium without friction (option, races that do not turn against
/// each other, nothing that resists, or the cases above).
[[nodiscard]] bool has_friction_balance(const bearing::Bearing& bearing,
                                        const RollerOptions& options);

/// The bearing with friction from one without; false: as it was, and `result` says why.
/// @param out displacement, load, stiffness, rollers and iterations change; summaries do not
bool solve_roller_friction_balance(const bearing::Bearing& bearing, const RollerOptions& options,
                                   const RollerModel& model, const RaceLoadCase& task,
                                   const RollerRace& race, RollerSolution& out);

}  // namespace adore::statics
