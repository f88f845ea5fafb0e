#pragma once

#include "dynamics/effect.hpp"

/// One maker for each line of the catalogue; null where the plan does not ask for the effect. The
/// terms are what an effect may add to the energy ledger.
namespace adore::dynamics {

using MadeEffect = std::unique_ptr<SceneEffect>;

MadeEffect make_balls(const ScenePlan& plan);
MadeEffect make_rigid_elements(const ScenePlan& plan);
MadeEffect make_ball_orientation(const ScenePlan& plan);
MadeEffect make_races(const ScenePlan& plan);
LedgerTerms race_terms();
MadeEffect make_contact_damping(const ScenePlan& plan);
LedgerTerms contact_damping_terms();
MadeEffect make_rolling_resistance(const ScenePlan& plan);
LedgerTerms rolling_resistance_terms();
MadeEffect make_race_excitations(const ScenePlan& plan);
MadeEffect make_pocket_contact(const ScenePlan& plan);
LedgerTerms pocket_terms();
MadeEffect make_roller_pockets(const ScenePlan& plan);
MadeEffect make_roller_flanges(const ScenePlan& plan);
LedgerTerms roller_flange_terms();
MadeEffect make_element_contact(const ScenePlan& plan);
LedgerTerms element_contact_terms();
MadeEffect make_roller_neighbours(const ScenePlan& plan);
MadeEffect make_land_contact(const ScenePlan& plan);
LedgerTerms land_terms();
MadeEffect make_land_film(const ScenePlan& plan);
LedgerTerms land_film_terms();
MadeEffect make_pocket_film(const ScenePlan& plan);
LedgerTerms pocket_film_terms();
MadeEffect make_element_drag(const ScenePlan& plan);
LedgerTerms element_drag_terms();
MadeEffect make_cage_drag(const ScenePlan& plan);
LedgerTerms cage_drag_terms();
MadeEffect make_thermal_steps(const ScenePlan& plan);
LedgerTerms thermal_step_terms();
MadeEffect make_cage(const ScenePlan& plan);
LedgerTerms cage_terms();
MadeEffect make_free_races(const ScenePlan& plan);
LedgerTerms free_race_terms();
MadeEffect make_gravity(const ScenePlan& plan);
LedgerTerms gravity_terms();
MadeEffect make_turning_frame(const ScenePlan& plan);
LedgerTerms rotating_frame_ledger_terms();
MadeEffect make_momentum_ledger(const ScenePlan& plan);
MadeEffect make_race_balance(const ScenePlan& plan);
MadeEffect make_suppressed_accelerations(const ScenePlan& plan);
LedgerTerms suppressed_acceleration_terms();
MadeEffect make_light_load_balance(const ScenePlan& plan);
LedgerTerms light_load_terms();

}  // namespace adore::dynamics
