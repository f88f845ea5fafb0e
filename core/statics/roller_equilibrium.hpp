#pragma once

#include "statics/race_equilibrium.hpp"
#include "statics/roller_model.hpp"
#include "statics/roller_place.hpp"
#include "statics/roller_state.hpp"

/// Equilibrium of one roller between two races held in place, and what it hands on to the inner
/// race: F_x = 0, F_r + F_c = 0, and about y: M_C - M_G(F_c) = gyroscopic moment, with the forces
/// of roller_forces.hpp.
namespace adore::statics {

/// Moves the roller with the inner race, unless that is a long way.
void follow_race(const RollerModel& model, const Vec5& change, RollerState& state);

/// Both races with the inner one at q: for the search of rollers, and with derivatives.
struct RacesAtDisplacement {
  Vec5 q;
  Races<PlaceDual> held;
  Races<RollerDual> moved;
};
[[nodiscard]] RacesAtDisplacement races_at_displacement(const RollerModel& model, const Vec5& q);

/// Sums over rollers.
struct RaceLoad {
  Vec5 load = Vec5::Zero();
  Mat5 stiffness = Mat5::Zero();
  double largest_contact = 0.0;
};
/// Brings one roller into equilibrium and adds what it hands on; false: there is none.
/// @param change of q since the roller was in equilibrium
[[nodiscard]] bool add_roller(const RollerModel& model, const RacesAtDisplacement& races,
                              const Vec5& change, double accuracy, RollerState& roller,
                              RaceLoad& sum);

// The inner race on rollers: what race_equilibrium.hpp asks of an element set.
using RollerRace = RaceState<RollerState>;
[[nodiscard]] RaceScales race_scales(const RollerModel& model);
[[nodiscard]] double reference_stiffness(const RollerModel& model, double load);
[[nodiscard]] inline bool is_conservative(const RollerModel&) { return true; }
[[nodiscard]] inline double initial_accuracy(const RollerModel&) { return 1e-3; }
[[nodiscard]] bool update_race(const RollerModel& model, const Vec5& q, RollerRace& state,
                               double accuracy = 0.0);

}  // namespace adore::statics
