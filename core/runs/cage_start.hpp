#pragma once

#include "runs/prepare.hpp"
#include "scene/snapshot.hpp"

/// Start position of the cage by record 9.6.
namespace adore::runs {

/// Rejects a cage that starts inside rolling elements or guide lands: the contacts would push it
/// out with unrealistic forces. Clamping by a negative clearance of the deck is
/// intended and allowed.
/// @param start snapshot of the first instant
/// @throws InputError with the largest overlaps
void check_cage_start(const Prepared& prepared, const scene::Snapshot& start);

/// For a start state without forces: rejected with record 9.6 when it puts the cage so far away
/// that elements are outside their pockets.
/// @throws InputError, or `error` when the cage is not the reason
[[noreturn]] void reject_cage_start(const Prepared& prepared, const SolverError& error);

}  // namespace adore::runs
