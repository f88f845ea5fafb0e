#include "calculators/calculators.hpp"

#include "base/errors.hpp"
#include "calculators/adapters.hpp"
#include "calculators/calculator_description.hpp"
#include "calculators/calculator_gate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace adore::calculators {

const std::vector<CalculatorInfo>& calculator_list() {
  static const std::vector<CalculatorInfo> table = {
      {"hertz", "A_hertz_point", "hertz_point",
       "elliptical Hertz contact: half axes, pressure, approach, subsurface stresses"},
      {"line-contact", "B_line_contact", "line_contact",
       "line contact: half width, pressure, subsurface stresses, and approach from published "
       "formulas"},
      {"sliced-line", "B_line_contact", "sliced_roller",
       "load and moment of a roller divided into slices, for a given approach and tilt"},
      {"slice-penetration", "rollers_slices", "slice_penetration",
       "penetration of the slices of a roller into a race in three dimensions"},
      {"slice-load", "rollers_slices", "slice_load",
       "loads of roller slices within the raceway width, from a power law or an elastic half-space "
       "law"},
      {"slice-traction", "rollers_slices", "slice_traction",
       "slip, traction, force, moment and heat of a roller (divided into slices) on a race"},
      {"race-errors", "rollers_slices", "race_errors",
       "form errors of a race along the azimuth: radius, land offset, taper, curvature factor"},
      {"roller-flange", "rollers_flange", "sphere_end",
       "gap, contact position, contact mode and load of a domed or flat roller end at a flange"},
      {"roller-corner", "rollers_flange", "corner_geometry",
       "torus geometry of the rounded corner between the side and the end of a roller"},
      {"flange-placing", "rollers_flange", "end_play",
       "flange root positions of a cylindrical race for a given total end play"},
      {"flange-load", "rollers_flange", "flange_load",
       "load, slip, friction and heat of a roller end on a flange"},
      {"roller-inertia", "rollers_inertia", "",
       "mass, mass center and moments of inertia of a roller with crown, domed ends and corners"},
      {"tapered-geometry", "rollers_tapered", "tapered_geometry",
       "geometry of a tapered bearing from the roller diameter and the two raceway angles"},
      {"tapered-speeds", "rollers_tapered", "tapered_speeds",
       "pure-rolling speeds and gyroscopic moment of a tapered roller"},
      {"rib-loads", "rollers_tapered", "rib_static",
       "race loads, rib load and rib contact of a tapered bearing under thrust"},
      {"grooved-tapered", "rollers_tapered", "grooved_tapered",
       "radius and center of the raceway profiles of a spherical tapered roller bearing"},
      {"spherical-row", "rollers_tapered", "grooved_spherical",
       "radius and center of the raceway profiles for a row of spherical rollers"},
      {"ball-statics", "C_ball_bearing", "ball_equilibrium",
       "ball loads, contact angles and stiffness of a ball bearing under load and speed"},
      {"kinematics", "E_kinematics", "kinematics", "cage speed, ball speed and defect frequencies"},
      {"traction", "lubricant_traction", "",
       "traction, film thickness and lambda of a lubricant (code kTrac) in a point contact"},
      {"traction-curve", "tribology_hypotheticalTraction", "",
       "traction coefficient versus slip, for four types of curve"},
      {"ellipse-traction", "dynamics_contact_traction", "",
       "traction, moment and heat of one contact ellipse"},
      {"hertz-traction", "tribology_hertzTraction", "",
       "traction force, moment and heat of a contact ellipse with slip and spin"},
      {"viscosity", "tribology_viscosity", "",
       "viscosity at pressure and temperature, for a lubricant code or a viscosity law"},
      {"film", "tribology_film", "", "isothermal film thickness of point and line contacts"},
      {"film-heating", "tribology_thermalFactor", "",
       "reduction of the film thickness by shear heating in the inlet"},
      {"film-starvation", "tribology_starvation", "",
       "reduction of the film thickness by starvation (oil meniscus near the contact)"},
      {"heated-film", "tribology_newtonFilm", "",
       "shear stress and heat of a Newtonian film with shear heating"},
      {"shear-thinning-film", "tribology_shearThinningFilm", "",
       "shear stress of a Carreau-Yasuda film, isothermal and with shear heating"},
      {"visco-elastic-film", "tribology_viscoelasticStrip", "",
       "traction coefficient of a viscoelastic film along one strip of a contact in the rolling "
       "direction"},
      {"flash-temperature", "tribology_flashStrip", "",
       "surface temperatures of both bodies along one strip of a sheared film in the rolling "
       "direction"},
      {"journal-film", "tribology_journalBearing", "",
       "force and torque of a cage on its guide land (short journal bearing)"},
      {"pocket-film", "tribology_pocketFilm", "",
       "wedge film and squeeze film forces in a cage pocket"},
      {"churning", "tribology_churning", "",
       "churning drag and torque of rolling elements, rings and discs in a fluid"},
      {"pocket-frame", "cage_pockets", "pocket_frame", "center and axes of a cage pocket"},
      {"ball-pocket", "cage_pockets", "ball_pocket",
       "gap, contact point and contact angles of a ball in its pocket"},
      {"pocket-law", "cage_pockets", "pocket_contact_law",
       "contact load and stiffness of a ball in its pocket (Hertz law; linear at large "
       "penetrations)"},
      {"land-law", "cage_lands", "land_law_circular",
       "load of a cage guide land for given eccentricities"},
      {"land-gap", "cage_lands", "land_gap",
       "gap of a guide land for a given cage position and orientation"},
      {"cage-inertia", "cage_inertia", "cage_inertia",
       "mass and moments of inertia of a cage with pockets"},
      {"fits", "thermal_lame", "lame_fit",
       "pressure, diameter changes and stresses of an interference fit"},
      {"growth", "thermal_growth", "", "diameter changes of a ring by rotation or temperature"},
      {"clearance", "thermal_clearance", "",
       "operating fits, clearance and contact angle of a mounted bearing, also with a split race"},
      {"material", "thermal_props", "material_property",
       "properties of a material with units and sources, at the temperature T [K] if T is given"},
      {"fluid", "thermal_props", "fluid_property",
       "properties of a coolant or churning medium at the temperature T [K]"},
      {"thermal-network", "thermal_network", "",
       "steady temperatures of shaft, races, elements, cage, housing, coolant; convection "
       "coefficients"},
      {"thermal-steps", "thermal_steps", "",
       "mean heat of each thermal step; convergence of the temperatures from step to step"},
      {"units", "thermal_units", "", "conversion of values between the SI and English systems"},
      {"load-capacity", "life_lp_capacity", "",
       "Lundberg-Palmgren load capacity of ball and roller races"},
      {"life", "life_stress_models", "",
       "life of races, rolling elements and bearing from contact loads, with a selectable life "
       "model"},
      {"life-factors", "life_factors", "", "STLE and Tallian-type life factors"},
      {"life-statistics", "life_race_bearing", "",
       "bearing life from the lives of its races (product of their survival probabilities); life "
       "at a given survival probability"},
      {"life-sum", "life_accumulation", "", "Palmgren-Miner life of a load history"},
      {"iso281", "life_iso281", "",
       "ISO 281 and ISO 76: load ratings, equivalent load, life factors a_1 and a_ISO, "
       "contamination factor, fatigue load limit C_u"},
      {"iso16281", "life_iso16281", "", "ISO 16281 reference life from contact or lamina loads"},
      {"static-safety", "rating_static", "",
       "ISO 76: equivalent static load P0, static safety factor s0, static load rating of thrust "
       "bearings"},
      {"reference-speed", "rating_reference_speed", "",
       "ISO 15312: thermal reference speed from the balance of frictional heat and dissipated "
       "heat"},
      {"oscillating-life", "rating_oscillation", "",
       "life of an oscillating bearing and the critical angle of oscillation"},
      {"minimum-load", "rating_minimum_load", "",
       "minimum load for rolling without sliding (formulas of a bearing manufacturer)"},
      {"size-limits", "rating_size_limits", "",
       "limits of size of shafts and bores (ISO 286) and of bearing rings (ISO 492)"},
      {"bearing-fit", "rating_bearing_fit", "",
       "interference from tolerance classes; clearance after mounting and in operation"},
      {"rigid-body", "motion_frames", "rigid_body", "accelerations of a rigid body"},
  };
  return table;
}

namespace {

std::string see_description(std::string_view name) {
  return fmt::format("`adore calc {} --describe` lists the inputs and shows an example", name);
}

/// The name in single or double quotes within a text; empty when there is none.
std::string quoted(std::string_view text) {
  const std::size_t first = text.find('\'', text.find("key"));
  const std::size_t last = first == std::string_view::npos ? first : text.find('\'', first + 1);
  return last == std::string_view::npos ? std::string()
                                        : std::string(text.substr(first + 1, last - first - 1));
}

/// A sentence for an error of the JSON library: a missing key, or a value of another type. Only
/// inputs that the schema cannot require come here, and families without a schema.
std::string misfit(std::string_view name, const nlohmann::json::exception& error) {
  constexpr int kNoSuchKey = 403;
  const std::string key = quoted(error.what());
  if (error.id == kNoSuchKey && !key.empty())
    return fmt::format("calculator {}: the input {} is missing; {}", name, key,
                       see_description(name));
  return fmt::format("calculator {}: an input is missing or of the wrong type; {}", name,
                     see_description(name));
}

/// The condition of a demand() without its place in the source.
std::string_view reason(std::string_view what) {
  const std::size_t begin = what.rfind(": "), end = what.rfind(" (this is");
  if (begin == std::string_view::npos) return what;
  return what.substr(begin + 2, end == std::string_view::npos ? end : end - begin - 2);
}

}  // namespace

nlohmann::json calculate(std::string_view name, const nlohmann::json& input,
                         std::span<const Adapter> more) {
  const auto& table = calculator_list();
  const auto named = std::find_if(table.begin(), table.end(),
                                  [&](const CalculatorInfo& info) { return info.name == name; });
  const std::string family = named != table.end() ? named->family : std::string(name);
  std::vector<Adapter> adapters = component_adapters();
  adapters.insert(adapters.end(), more.begin(), more.end());
  std::erase_if(adapters, [&](const Adapter& a) { return a.family != family; });
  if (adapters.empty())
    throw InputError(fmt::format(
        "there is no calculator named \"{}\"; `adore calc --list` lists all calculators", name));

  if (!input.is_object())
    throw InputError(fmt::format("calculator {}: the input must be one JSON object", name));
  nlohmann::json the_case = input.contains("inputs") ? input : nlohmann::json{{"inputs", input}};
  if (!the_case.at("inputs").is_object())
    throw InputError(fmt::format("calculator {}: \"inputs\" must be one JSON object", name));
  if (!the_case.contains("id")) the_case["id"] = name;
  the_case = check_inputs(family, named != table.end() ? named->kind : std::string(), the_case);
  std::optional<nlohmann::json> result;
  try {
    for (const Adapter& adapter : adapters)
      if (!result) result = adapter.run(the_case);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(misfit(name, error));
  } catch (const std::logic_error& error) {
    // The numbers go straight to the library, so a precondition that fails there is theirs.
    throw InputError(fmt::format("calculator {} does not accept these inputs ({}); {}", name,
                                 reason(error.what()), see_description(name)));
  }
  if (!result && named == table.end()) {
    std::string members;
    for (const CalculatorInfo& info : table)
      if (info.family == family) members += (members.empty() ? "" : ", ") + std::string(info.name);
    throw InputError(
        fmt::format("{} is a family of reference cases. The inputs fit none of its kinds of "
                    "calculation. Add \"kind\", or use one of its calculators: {}",
                    name, members.empty() ? "none" : members));
  }
  if (!result)
    throw InputError(
        fmt::format("calculator {}: the inputs fit none of its kinds of calculation; {}", name,
                    see_description(name)));
  check_results(family, name, *result);
  nlohmann::json units = result_units(family, *result);
  if (result->is_object() && !result->contains("units")) (*result)["units"] = std::move(units);
  return *result;
}

}  // namespace adore::calculators
