#include "validation/adapters.hpp"

#include "calculators/adapters.hpp"
#include "validation/cases_dynamics.hpp"
#include "validation/cases_motion.hpp"

namespace adore::validation {
namespace {

struct Entry {
  std::string_view family, functions;
};

/// Motions state theirs with the result (Motion::add_evaluation_record).
constexpr Entry kEntries[] = {
    {"A_hertz_point", "contact::hertz_constants, contact::subsurface_stress"},
    {"B_line_contact", "contact::line_pressure, contact::line_subsurface_stress"},
    {"C_ball_bearing", "statics::solve_ball_statics"},
    {"D_roller_bearing", "statics::solve_roller_statics, contact::rib_loads"},
    {"E_kinematics", "statics::epicyclic_speeds"},
    {"P_published", "statics::solve_ball_statics, statics::epicyclic_speeds"},
    {"cage_inertia", "contact::cage_solid_inertia"},
    {"cage_lands", "contact::land_load, contact::min_land_gap"},
    {"cage_pockets", "contact::nearest_walls, contact::ball_pocket_law"},
    {"dynamics_contact_traction", "tribology::ellipse_traction_converged"},
    {"life_accumulation", "life::damage_rate, life::equivalent_load"},
    {"life_factors", "life::film_factor, life::stle_factor"},
    {"life_identities", "life::lundberg_palmgren_life, life::race_life"},
    {"life_iso16281", "life::iso_reference_life_ball, life::iso_reference_life_roller"},
    {"life_iso281", "life::iso_dynamic_rating, life::iso_life_factor"},
    {"life_lp_capacity", "life::point_capacity, life::line_capacity"},
    {"life_race_bearing", "life::race_life, life::combined_life"},
    {"life_stress_models", "life::lundberg_palmgren_life, contact::hertz_constants"},
    {"motion_constraints", "dynamics::ConstrainedBall, dynamics::solve_mode2"},
    {"motion_excitations", "dynamics::vibration, dynamics::varying_rotation"},
    {"motion_frames", "dynamics::race_accelerations, dynamics::euler_rate"},
    {"rating_bearing_fit", "bearing::interference, bearing::size_limits, thermal::mount"},
    {"rating_minimum_load", "life::minimum_load_of_balls, life::minimum_load_of_rollers"},
    {"rating_oscillation", "life::oscillation"},
    {"rating_reference_speed", "life::reference_speed"},
    {"rating_size_limits", "bearing::size_limits, bearing::bore_tolerance"},
    {"rating_static", "life::static_factors, life::equivalent_static_load"},
    {"rollers_flange", "contact::flange_contact, contact::flange_load"},
    {"rollers_inertia", "contact::roller_inertia"},
    {"rollers_slices", "contact::line_resultant, contact::slice_load"},
    {"rollers_tapered", "contact::rolling_speeds"},
    {"thermal_clearance", "thermal::operating_clearance"},
    {"thermal_growth", "thermal::centrifugal_displacement"},
    {"thermal_lame", "thermal::fit_pressure, thermal::pressure_displacement"},
    {"thermal_network", "thermal::solve_nodal_network, thermal::solve_ladder"},
    {"thermal_props", "tribology::fluid_properties, bearing::material_sheet"},
    {"thermal_steps", "thermal::assess_thermal_steps"},
    {"thermal_units", "deck::unit::kLength"},
    {"tribology_churning", "tribology::sphere_drag, tribology::cylinder_drag"},
    {"tribology_film", "tribology::line_film"},
    {"tribology_flashStrip", "tribology::flash_strip"},
    {"tribology_hertzTraction", "tribology::film_shear_stress"},
    {"tribology_hypotheticalTraction", "tribology::traction_curve"},
    {"tribology_journalBearing", "tribology::journal_force"},
    {"tribology_newtonFilm", "tribology::film_shear_between_walls"},
    {"tribology_pocketFilm", "tribology::point_wedge_force, tribology::sphere_squeeze_force"},
    {"tribology_shearThinningFilm", "tribology::shear_thinning_stress"},
    {"tribology_starvation", "tribology::starvation_factor"},
    {"tribology_thermalFactor", "tribology::thermal_reduction_raw"},
    {"tribology_viscoelasticStrip", "tribology::strip_coefficient"},
    {"tribology_viscosity", "tribology::viscosity_law"},
};

}  // namespace

std::vector<Adapter> all_adapters() {
  std::vector<Adapter> all = component_adapters();
  for (std::vector<Adapter> some : {motion_adapters(), dynamics_adapters()})
    for (Adapter& adapter : some) all.push_back(std::move(adapter));
  return all;
}

std::string_view evaluated_library_functions(std::string_view family) {
  for (const Entry& entry : kEntries)
    if (entry.family == family) return entry.functions;
  return {};
}

}  // namespace adore::validation
