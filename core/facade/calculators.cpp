#include "facade/calculators.hpp"

#include "base/errors.hpp"
#include "facade/reference/adapters.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::facade {

const std::vector<CalculatorInfo>& calculators() {
  static const std::vector<CalculatorInfo> table = {
      {"hertz", "A_hertz_point", "hertz_point",
       "elliptical Hertz contact: sizes, pressure, approach, subsurface stresses"},
      {"ball-statics", "C_ball_bearing", "ball_equilibrium",
       "ball bearing under load and speed: loads, angles, stiffness"},
      {"kinematics", "E_kinematics", "kinematics", "cage and ball speeds, defect frequencies"},
      {"traction-curve", "tribology_hypotheticalTraction", "",
       "traction coefficient over slip, four prescriptions"},
      {"ellipse-traction", "dynamics_contact_traction", "",
       "traction, moment and heat of one contact ellipse"},
      {"hertz-traction", "tribology_hertzTraction", "",
       "traction over an ellipse with slip and spin"},
      {"pocket-frame", "cage_pockets", "pocket_frame", "centre and axes of a cage pocket"},
      {"ball-pocket", "cage_pockets", "ball_pocket",
       "gap, contact point and angles of a ball in its pocket"},
      {"pocket-law", "cage_pockets", "pocket_contact_law",
       "load and energy of the capped Hertz law"},
      {"land-law", "cage_lands", "land_law_circular",
       "load of a cage guide land over its eccentricity"},
      {"land-gap", "cage_lands", "land_gap", "gap of a guide land for a cage pose"},
      {"cage-inertia", "cage_inertia", "cage_inertia",
       "mass and moments of inertia of a cage with pockets"},
      {"load-capacity", "life_lp_capacity", "",
       "Lundberg-Palmgren load capacity of ball and roller races"},
      {"life", "life_stress_models", "",
       "life of races, elements and bearing by one model from contact loads"},
      {"life-factors", "life_factors", "", "STLE and Tallian-type life factors"},
      {"life-statistics", "life_race_bearing", "", "race lives, product law, survival probability"},
      {"life-sum", "life_accumulation", "", "Palmgren-Miner life of a load history"},
      {"iso281", "life_iso281", "",
       "ISO 281 and ISO 76 ratings, equivalent load, a_ISO, contamination, a_1, C_u"},
      {"iso16281", "life_iso16281", "", "ISO 16281 reference life from contact or lamina loads"},
      {"rigid-body", "motion_frames", "rigid_body", "accelerations of a rigid body"},
  };
  return table;
}

nlohmann::json calculate(std::string_view name, const nlohmann::json& input) {
  const auto& table = calculators();
  const auto named = std::find_if(table.begin(), table.end(),
                                  [&](const CalculatorInfo& info) { return info.name == name; });
  const std::string family = named != table.end() ? named->family : std::string(name);
  const auto adapters = reference::all_adapters();
  const auto adapter =
      std::find_if(adapters.begin(), adapters.end(),
                   [&](const reference::Adapter& a) { return a.family == family; });
  if (adapter == adapters.end())
    throw InputError(
        fmt::format("there is no calculator named \"{}\"; `adore calc --list` shows them", name));

  if (!input.is_object())
    throw InputError(fmt::format("calculator {} takes one JSON object of inputs", name));
  nlohmann::json the_case = input.contains("inputs") ? input : nlohmann::json{{"inputs", input}};
  if (!the_case.contains("id")) the_case["id"] = name;
  if (!the_case.contains("kind") && named != table.end() && !named->kind.empty())
    the_case["kind"] = named->kind;
  std::optional<nlohmann::json> result;
  try {
    result = adapter->run(the_case);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(
        fmt::format("calculator {}: an input is missing or has the wrong type ({}); "
                    "tests/reference explains the inputs of "
                    "family {}",
                    name, error.what(), family));
  }
  if (!result)
    throw InputError(fmt::format(
        "calculator {} does not understand these inputs; see family {} in tests/reference", name,
        family));
  return *result;
}

}  // namespace adore::facade
