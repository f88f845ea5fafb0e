#pragma once

#include "bearing/bearing.hpp"
#include "setup/user_hooks.hpp"

/// Surfaces that routines of the user give, ADRX5 of elements and ADRX6 of races, asked once while
/// the bearing is built: what they answer becomes the deviations that decks give in records 5G.
///
/// ADRX6: radius and groove factor over the turn become series of up to 255 waves through 512
/// places around; as many between them tell the error. What varies across (beyond the taper of a
/// straight raceway), or jumps over the turn, becomes a table (surface_table.hpp).
/// ADRX5: the radius of an element over its axis x and its azimuth ψ. Of a roller
///   f(x) + c(ψ) + x t(ψ),   c and t without mean:
/// f at the middles of its slices and between, c and t as series of up to 255 waves, which turn
/// with the roller (dynamics/effects/roller_races.hpp). More than 1 % from such a sum is refused,
/// and so are balls that are not round. The equilibrium has f alone.
namespace adore::setup {

/// @throws InputError
void apply_user_element_surfaces(const UserHooks& user, bearing::Bearing& bearing);
void apply_user_race_surface(const UserHooks& user, std::size_t race, bearing::Bearing& bearing);

}  // namespace adore::setup
