#pragma once

#include "scene/plan.hpp"
#include "setup/run_control.hpp"
#include "setup/user_hooks.hpp"

namespace adore::setup {

/// What a run of this deck simulates and why: bodies, degrees of freedom, effects with the deck
/// switch that decides each.
[[nodiscard]] scene::ScenePlan make_scene_plan(const deck::Deck& deck,
                                               const bearing::Bearing& bearing,
                                               const RunControl& control,
                                               const UserHooks* user = nullptr);

}  // namespace adore::setup
