#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "statics/ball_race.hpp"

#include <string>
#include <vector>

/// Spin axis of least heat (kAngVel = 0) by the traction law and the oil of the deck.
///
/// The manual: the axis of each ball is the one for which the heat of both race contacts, by the
/// given traction model, is least. Over the pitch angle β at constant loads and angles,
///   E(β) = Σ_j ∫ κ_j(|u|) p |u| dA [W],
/// κ_j the curve of record 10.1, or the oil film and that curve below the critical film, as in
/// motion (contact_laws.hpp); u: spin, and slip of the curved surface, of a contact that creeps
/// freely (friction.hpp), so that E is the heat that the friction table reports. A coarse scan
/// between the two race-control angles, widened while an end is the least, brackets the root of
/// the central difference of E.
///
/// spin.hpp has the same minimum at a constant coefficient of friction, with its derivatives over
/// loads and angles. Here only the angle between the two, BallSite::axis_shift, is searched; it is
/// held during a solution of the bearing, and both are repeated until β stays within kSteadyChange.
/// Limits: rolling resistance and drag, which β does not change, are left out; a ball below the
/// load window of ball_forces.hpp, or a deck without friction at its race contacts, keeps spin.hpp.
namespace adore::statics {

/// Changes `state` and `solve`. When no equilibrium is found on the way, both are those of the
/// constant coefficient, with a note.
void solve_least_heat(const bearing::Bearing& bearing, const BallModel& model,
                      const RaceLoadCase& task, BallRace& state, RaceSolveResult& solve,
                      std::vector<Finding>& notes);

}  // namespace adore::statics
