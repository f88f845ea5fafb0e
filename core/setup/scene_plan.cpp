#include "setup/scene_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace adore::setup {
namespace {

using scene::Effect;

bool can_push(const bearing::TractionCurve& c) {
  return c.A != 0.0 || c.B != 0.0 || c.C != 0.0 || c.D != 0.0;
}

/// The traction law named by its switch, e.g. "kTracType = 0".
std::string curve_reason(const deck::Deck& deck, const char* type,
                         const bearing::TractionCurve& curve) {
  return fmt::format("{} = {}{}", type, deck.integer(type),
                     can_push(curve) ? "" : ", all coefficients 0");
}

}  // namespace

scene::ScenePlan make_scene_plan(const deck::Deck& deck, const bearing::Bearing& bearing,
                                 const RunControl& control) {
  scene::ScenePlan plan;
  const int n = bearing.element_count();
  const std::string element = bearing.rollers() ? "roller" : "ball";
  const std::string mode = fmt::format("mode = {}", deck.integer("mode"));
  const std::string cage_switch = fmt::format("nCseg = {}", deck.integer("nCseg"));
  const bool cage = bearing.cage.has_value();
  const bool guided = cage && bearing.land_traction.has_value();

  auto effect = [&](Effect id, const std::string& name, bool on, std::string because) {
    plan.effects.push_back({id, name, on, std::move(because)});
  };
  effect(Effect::RaceContact, element + " / race contact", true, mode);
  effect(Effect::RaceTraction, element + " / race traction", can_push(bearing.race_traction),
         curve_reason(deck, "kTracType", bearing.race_traction));
  effect(Effect::CageMotion, "cage motion", cage, cage_switch);
  effect(Effect::PocketContact, element + " / pocket contact", cage, cage_switch);
  effect(Effect::PocketTraction, element + " / pocket traction",
         cage && can_push(*bearing.pocket_traction),
         cage ? curve_reason(deck, "kCPTracType", *bearing.pocket_traction) : cage_switch);
  const bool ring = !cage && n >= 2;
  effect(Effect::ElementContact, element + " / " + element + " contact", ring, cage_switch);
  effect(Effect::ElementTraction, element + " / " + element + " traction",
         ring && can_push(*bearing.element_traction),
         ring ? curve_reason(deck, "kRRTracType", *bearing.element_traction) : cage_switch);
  effect(Effect::LandContact, "cage / race guide lands", guided,
         cage ? fmt::format("nGL = {}{}", deck.integer("nGL"), guided ? "" : ", no guided land")
              : cage_switch);
  effect(Effect::LandTraction, "cage / race traction", guided && can_push(*bearing.land_traction),
         guided ? curve_reason(deck, "kCRTracType", *bearing.land_traction)
                : std::string("no guided land"));
  effect(Effect::Gravity, "gravity", bearing.gravity.norm() > 0.0,
         fmt::format("gravityVec = {:g} m/s^2, {:g} m/s^2, {:g} m/s^2", bearing.gravity.x(),
                     bearing.gravity.y(), bearing.gravity.z()));
  for (std::size_t j = 0; j < 2; ++j)
    if (!bearing.rollers() && bearing.balls().shim[j] > 0.0)
      effect(Effect::RaceContact, j == 0 ? "split outer race" : "split inner race", true,
             fmt::format("shimThickness{} > 0: contact with one half; the other half is watched in "
                         "the static solution only",
                         j + 1));

  // A perfect sphere's orientation is integrated only for elements that a file shows.
  const bool sections = control.print_option >= 1;
  for (int i = 0; i < n; ++i) {
    const bool monitored = std::find(control.monitored.begin(), control.monitored.end(), i + 1) !=
                           control.monitored.end();
    if (control.animate || monitored || (sections && i % control.print_option == 0))
      plan.oriented_elements.push_back(i);
  }
  const int oriented = static_cast<int>(plan.oriented_elements.size());
  effect(Effect::ElementOrientation, element + " orientation", oriented > 0,
         control.animate
             ? fmt::format("kAGraf = {}: all balls", control.animate_every)
             : fmt::format("{} of {} {}s in kPltElemInd or kPrtOpt", oriented, n, element));
  effect(Effect::WearIntegrals, "wear and power integrals", true, "SOL7 and PRINT show them");
  effect(Effect::MomentumLedger, "momentum ledger", true, "RUN.json and PRINT show it");
  plan.light_load_ratio = control.light_load_ratio;
  effect(Effect::LightLoadBalance, "light-load balance", control.light_load_ratio > 0.0,
         fmt::format("qFac = {:g}", control.light_load_ratio));

  auto rpm = [](double speed) { return speed * 30.0 / std::numbers::pi; };
  plan.bodies.push_back({fmt::format("balls ({})", n),
                         "x, r, theta, angular velocity: 6 degrees of freedom each", 9 * n});
  if (oriented > 0)
    plan.bodies.push_back({fmt::format("orientation of balls ({})", oriented),
                           "quaternion and total rotation", 5 * oriented});
  if (cage) plan.bodies.push_back({"cage", "6 degrees of freedom and total rotation", 14});
  plan.bodies.push_back(
      {"outer race", fmt::format("fixed, speed {:g} rpm", rpm(bearing.speed[0])), 0});
  plan.bodies.push_back(
      {"inner race", fmt::format("at the static position, speed {:g} rpm", rpm(bearing.speed[1])),
       0});
  for (const scene::BodyEntry& body : plan.bodies) plan.unknowns += body.unknowns;
  return plan;
}

}  // namespace adore::setup
