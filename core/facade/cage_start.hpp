#pragma once

#include "facade/prepare.hpp"
#include "scene/snapshot.hpp"

/// Where record 9.6 puts the cage before the first step.
namespace adore::facade {

/// Refuses a cage that starts inside rolling elements or guide lands: the contacts would push it
/// out with forces that the run has not earned. What a negative clearance of the deck clamps is
/// meant so and allowed.
/// @param start snapshot of the first instant
/// @throws InputError with the largest overlaps
void check_cage_start(const Prepared& prepared, const scene::Snapshot& start);

/// Of a start state that has no forces: refused by record 9.6 when that put the cage so far away
/// that elements are outside their pockets.
/// @throws InputError, or `error` when the cage is not the reason
[[noreturn]] void refuse_start(const Prepared& prepared, const SolverError& error);

}  // namespace adore::facade
