#pragma once

#include "base/errors.hpp"
#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "setup/build_imperfections.hpp"
#include "setup/user_hooks.hpp"

#include <vector>

/// Deck -> SI model: the only place where deck variables become physics, and where units end.
namespace adore::setup {

/// Features of this deck that the program cannot simulate yet, as errors that name record and
/// variable, and values without effect, as warnings. Empty if all of the deck
/// will be simulated.
[[nodiscard]] std::vector<Issue> check_buildable(const deck::Deck& deck,
                                                 const UserHooks* user = nullptr);

/// The SI model of a deck that reads without errors. `seed`: of the random imperfections of rolling
/// elements.
/// @throws InputError with every reason at once: what is not built yet (check_buildable) and
/// geometry that cannot close.
[[nodiscard]] bearing::Bearing build_bearing(const deck::Deck& deck,
                                             std::uint64_t seed = kDefaultSeed,
                                             const UserHooks* user = nullptr);

/// Record 5A alone, in the free state. @throws InputError when the grooves do not allow the
/// clearance.
[[nodiscard]] bearing::BallGeometry build_ball_geometry(const deck::Deck& deck);

}  // namespace adore::setup
