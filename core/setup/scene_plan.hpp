#pragma once

#include "scene/plan.hpp"
#include "setup/run_control.hpp"
#include "setup/user_hooks.hpp"

namespace adore::setup {

/// What a run of this deck simulates and why: bodies, degrees of freedom, effects with the deck
/// switch that decides each, without those that the run options leave out.
/// @throws InputError when an effect cannot be left out, or contacts cannot be damped
[[nodiscard]] scene::ScenePlan make_scene_plan(const deck::Deck& deck,
                                               const bearing::Bearing& bearing,
                                               const RunControl& control, const RunOptions& options,
                                               const UserHooks* user = nullptr);

/// Can run option effectsOff leave it out? Not what bodies, modes and motions of a deck are made
/// of: those have variables of their own.
[[nodiscard]] bool can_be_left_out(const scene::ScenePlan& plan, scene::Effect effect);

}  // namespace adore::setup
