#pragma once

#include "scene/plan.hpp"
#include "setup/run_control.hpp"
#include "setup/user_hooks.hpp"

namespace adore::setup {

/// Content of a run of this deck, with reasons: bodies, degrees of freedom, effects with the deck
/// switch of each, without those that the run options leave out.
/// @throws InputError when an effect cannot be left out, or contacts cannot be damped
[[nodiscard]] scene::ScenePlan make_scene_plan(const deck::Deck& deck,
                                               const bearing::Bearing& bearing,
                                               const RunControl& control, const RunOptions& options,
                                               const UserHooks* user = nullptr);

/// Can run option effectsOff leave it out? Not bodies, modes and motions of a deck:
/// those have separate variables.
[[nodiscard]] bool can_be_left_out(const scene::ScenePlan& plan, scene::Effect effect);

}  // namespace adore::setup
