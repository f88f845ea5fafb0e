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

}  // namespace adore::facade
