#include "setup/scene_plan.hpp"

#include "bearing/contact_losses.hpp"
#include "bearing/element_inertia.hpp"
#include "setup/option_choices.hpp"
#include "setup/race_motions.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// "kFlngInd12 = 1, kFlngInd22 = 1"
std::string flange_reason(const deck::Deck& deck) {
  std::string out;
  for (const char* name : {"kFlngInd11", "kFlngInd21", "kFlngInd12", "kFlngInd22"})
    if (deck.integer(name) == 1) out += fmt::format("{}{} = 1", out.empty() ? "" : ", ", name);
  return out;
}

std::string film_reason(const bearing::Bearing& bearing) {
  const bearing::Lubrication& lubrication = *bearing.lubrication;
  const tribology::Lubricant oil = tribology::lubricant_of(lubrication);
  const double T = 0.5 * (bearing.race_temperature[1] + bearing.element_temperature);
  const double limit = oil.limiting_ratio(T);
  return fmt::format(
      "kTrac = {}, {}; {}{}", lubrication.code, oil.name,
      limit > 0.0
          ? fmt::format("limiting shear stress {:.3g} times the pressure at {:.4g} K", limit, T)
          : std::string("no limiting shear stress"),
      lubrication.hot_walls
          ? "; iTherm = 1: the surfaces have the flash temperature of each contact strip"
          : "");
}

/// Does a ball need no orientation to move: equal moments, mass center in its middle?
bool moves_as_sphere(const bearing::Bearing& bearing) {
  if (bearing.first_inertia) return false;
  const bearing::Inertia& one = bearing.element_inertia;
  return one.geometric_centre.isZero(0.0) &&
         one.moments.maxCoeff() - one.moments.minCoeff() <= 1e-9 * one.moments.maxCoeff();
}

/// "races: loss factor 0.01, impact loss 0.08 s/m"
std::string losses_of(const char* where, const bearing::Material& a, const bearing::Material& b,
                      const scene::ContactDampingOptions& options) {
  const bearing::ContactLosses losses = bearing::contact_losses(a, b);
  const double impact = options.impact_loss > 0.0 ? options.impact_loss : losses.impact_loss;
  return fmt::format("{}: loss factor {:.2g}, impact loss {:.2g} s/m", where,
                     options.factor * losses.loss_factor, options.factor * impact);
}

/// Which contacts are damped.
std::string damping_reason(const scene::ContactDampingOptions& options, const std::string& element,
                           const bearing::Bearing& bearing, const std::string& mode,
                           bool all_balanced, double light_load_ratio) {
  std::string out = "run option contactDamping = material";
  if (options.impact_loss > 0.0)
    out = fmt::format("run option contactDamping = {:g} (in s/m)", options.impact_loss);
  if (options.factor != 1.0) out = fmt::format("run option contactDamping = {:g}x", options.factor);
  const bearing::Material& of_element = bearing.element_material;
  if (all_balanced)
    out += fmt::format("; no damping at the races, because {} keeps all {}s in force balance", mode,
                       element);
  else
    out += "; " + losses_of("races", of_element, bearing.race_material[1], options) +
           (bearing.lubrication && bearing.lubrication->meniscus > 0.0 ? ", squeeze of the oil film"
                                                                       : "");
  if (light_load_ratio > 0.0)
    out += fmt::format("; lightly loaded {}s do not vibrate (quasi-static by qFac = {:g})", element,
                       light_load_ratio);
  const bearing::RollerGeometry* rollers = bearing.rollers();
  const bool flanges = rollers != nullptr && (rollers->has_flange(0) || rollers->has_flange(1));
  if (flanges && !(all_balanced && bearing.type == bearing::Type::Tapered))
    out += "; " + losses_of("flanges", of_element, bearing.race_material[1], options);
  if (!bearing.cage) return out + "; " + losses_of("neighbors", of_element, of_element, options);
  out += "; " + losses_of("pockets", of_element, bearing.cage->material, options);
  if (bearing.land_traction)
    out +=
        "; " + losses_of("guide lands", bearing.cage->material, bearing.race_material[0], options);
  return out;
}

}  // namespace

bool can_be_left_out(const scene::ScenePlan& plan, Effect effect) {
  switch (effect) {
    case Effect::ElementOrientation:
      return !plan.rollers && !plan.rigid_balls;
    case Effect::RaceTraction:
    case Effect::RollingResistance:
    case Effect::FlangeTraction:
    case Effect::PocketTraction:
    case Effect::ElementTraction:
    case Effect::LandContact:
    case Effect::LandTraction:
    case Effect::PocketFilm:
    case Effect::LandFilm:
    case Effect::ElementDrag:
    case Effect::CageDrag:
    case Effect::Gravity:
    case Effect::WearIntegrals:
    case Effect::MomentumLedger:
    case Effect::LightLoadBalance:
    case Effect::ContactDamping:
      return true;
    default:
      return false;
  }
}

scene::ScenePlan make_scene_plan(const deck::Deck& deck, const bearing::Bearing& bearing,
                                 const RunControl& control, const RunOptions& options,
                                 const UserHooks* user) {
  scene::ScenePlan plan;
  const int n = bearing.element_count();
  const std::string element = bearing.rollers() ? "roller" : "ball";
  const std::string mode = fmt::format("mode = {}", deck.integer("mode"));
  const std::string cage_switch = fmt::format("nCseg = {}", deck.integer("nCseg"));
  const bool cage = bearing.cage.has_value();
  const bool guided = cage && bearing.land_traction.has_value();

  const long long dof = deck.integer("kDOF");
  plan.suppressed = {dof >= 1 && dof <= 4, dof == 2 || dof == 4, dof == 5,
                     cage && dof <= 2 && dof >= 1, cage && dof == 2};

  plan.rollers = bearing.rollers() != nullptr;
  const bool lobes = user != nullptr && user->balls_out_of_round;
  plan.rigid_balls = !plan.rollers && (lobes || !moves_as_sphere(bearing));
  std::vector<std::string> left_out = options.effects_off;
  if (dof == 6 && user != nullptr) {
    plan.suppressed = user->suppressed;
    plan.suppressed.cage_axial = plan.suppressed.cage_axial && cage;
    plan.suppressed.cage_tilt = plan.suppressed.cage_tilt && cage;
  }
  // A routine of the user in the place of a curve.
  const auto own_law = [&](const char* code) {
    return has_routine(user, 7) && deck.has(code) && deck.integer(code) == -1;
  };
  const auto law_reason = [&](const char* code, const char* type,
                              const bearing::TractionCurve& curve) {
    return own_law(code) ? fmt::format("{} = -1, user routine ADRX7 of {}", code, user->source)
                         : curve_reason(deck, type, curve);
  };

  auto effect = [&](Effect id, const std::string& name, bool on, std::string because) {
    if (std::erase(left_out, name) > 0) {
      if (!can_be_left_out(plan, id))
        throw InputError(
            fmt::format("run option effectsOff: {} cannot be switched off separately; it follows "
                        "from {}",
                        name, because));
      because += on ? "; switched off by run option effectsOff" : "";
      on = false;
    }
    plan.effects.push_back({id, name, on, std::move(because)});
  };
  effect(Effect::RaceContact, element + " / race contact", true, mode);
  const bool elastic = std::erase(left_out, kContactDamping) > 0;
  effect(Effect::ContactDamping, kContactDamping, !elastic,
         elastic ? std::string("run option contactDamping = 0, or effectsOff: elastic contacts. "
                               "Contact vibrations do not decay, so the largest loads, the life "
                               "and the spectra are not realistic")
                 : damping_reason(options.system.damping, element, bearing, mode,
                                  deck.integer("mode") > 0, control.light_load_ratio));
  effect(Effect::RaceTraction, element + " / race traction",
         can_push(bearing.race_traction) || bearing.lubrication || own_law("kTrac"),
         bearing.lubrication ? film_reason(bearing)
                             : law_reason("kTrac", "kTracType", bearing.race_traction));
  if (bearing.lubrication)
    effect(Effect::RollingResistance, element + " / race rolling resistance",
           bearing.lubrication->meniscus > 0.0,
           bearing.lubrication->meniscus > 0.0
               ? fmt::format(
                     "kTrac = {}, oil at the contact inlets; flanges have traction but no rolling "
                     "resistance",
                     bearing.lubrication->code)
               : std::string("strParam = 0, no oil at the contact inlets"));
  if (bearing.flange_traction) {
    effect(Effect::FlangeContact, "roller / flange contact", true, flange_reason(deck));
    effect(Effect::FlangeTraction, "roller / flange traction",
           can_push(*bearing.flange_traction) || own_law("kRFTrac"),
           law_reason("kRFTrac", "kRFTracType", *bearing.flange_traction));
  }
  effect(Effect::CageMotion, "cage motion", cage, cage_switch);
  effect(Effect::PocketContact, element + " / pocket contact", cage, cage_switch);
  effect(Effect::PocketTraction, element + " / pocket traction",
         cage && (can_push(*bearing.pocket_traction) || own_law("kCPTrac")),
         cage ? law_reason("kCPTrac", "kCPTracType", *bearing.pocket_traction) : cage_switch);
  const bool ring = !cage && n >= 2;
  effect(Effect::ElementContact, element + " / " + element + " contact", ring, cage_switch);
  effect(Effect::ElementTraction, element + " / " + element + " traction",
         ring && (can_push(*bearing.element_traction) || own_law("kRRTrac")),
         ring ? law_reason("kRRTrac", "kRRTracType", *bearing.element_traction) : cage_switch);
  effect(Effect::LandContact, "cage / race guide lands", guided,
         cage ? fmt::format("nGL = {}{}", deck.integer("nGL"), guided ? "" : ", no guided land")
              : cage_switch);
  const bool lands = plan.has(Effect::LandContact);
  effect(Effect::LandTraction, "cage / race traction",
         lands && (can_push(*bearing.land_traction) || own_law("kCRTrac")),
         guided ? law_reason("kCRTrac", "kCRTracType", *bearing.land_traction)
                : std::string("no guided land"));
  const auto films = [&](const char* flag, bool on, double viscosity) {
    std::string because = fmt::format("{} = {}", flag, deck.integer(flag));
    if (on)
      because += viscosity > 0.0 ? fmt::format(", {:g} Pa s", viscosity)
                                 : fmt::format(", {} at the cage's temperature",
                                               tribology::lubricant_of(*bearing.lubrication).name);
    return because;
  };
  if (cage) {
    const bearing::CageFilms oil = bearing.cage_films.value_or(bearing::CageFilms{});
    effect(Effect::PocketFilm, "pocket films", oil.pockets,
           films("kPocHydro", oil.pockets, oil.pocket_viscosity));
    effect(Effect::LandFilm, "guide-land films", oil.lands && lands,
           films("kGsHydro", oil.lands && guided, oil.land_viscosity));
  }
  const std::string medium = bearing.churning
                                 ? fmt::format("kChrn = {}, {}", bearing.churning->code,
                                               tribology::churning_medium(bearing).name)
                                 : std::string("kChrn = 0");
  effect(Effect::ElementDrag, element + " drag in the medium", bearing.churning.has_value(),
         medium);
  effect(Effect::CageDrag, "cage drag in the medium", bearing.churning.has_value() && cage,
         cage ? medium : cage_switch);
  effect(Effect::Gravity, "gravity", bearing.gravity.norm() > 0.0,
         fmt::format("gravityVec = {:g} m/s^2, {:g} m/s^2, {:g} m/s^2", bearing.gravity.x(),
                     bearing.gravity.y(), bearing.gravity.z()));
  for (std::size_t j = 0; j < 2; ++j)
    if (!bearing.rollers() && bearing.balls().shim[j] > 0.0)
      effect(Effect::RaceContact, j == 0 ? "split outer race" : "split inner race", true,
             fmt::format("shimThickness{} > 0: contact with each half", j + 1));

  for (std::size_t j = 0; j < 2; ++j)
    if (bearing.imperfections.race_given[j]) {
      const bool ideal = bearing.imperfections.race[j].ideal();
      effect(Effect::RaceContact, j == 0 ? "imperfect outer race" : "imperfect inner race", !ideal,
             fmt::format("kRaceGeoImp{} = {}{}", j + 1,
                         deck.integer(fmt::format("kRaceGeoImp{}", j + 1)),
                         ideal ? ", all amplitudes 0" : ""));
    }

  if (!bearing.imperfections.ball_diameter.empty()) {
    const bool unequal = bearing::has_unequal_balls(bearing);
    effect(Effect::RaceContact, "balls of unequal diameter", unequal,
           fmt::format("kReGeoImp = {}{}", deck.integer("kReGeoImp"),
                       unequal ? "" : ", all deviations 0"));
  }

  // A perfect sphere's orientation is integrated only for elements that a file shows.
  const bool sections = control.print_option >= 1;
  for (int i = 0; i < n; ++i) {
    const bool monitored = std::find(control.monitored.begin(), control.monitored.end(), i + 1) !=
                           control.monitored.end();
    if (control.animate || monitored || (sections && i % control.print_option == 0))
      plan.oriented_elements.push_back(i);
  }
  int oriented = static_cast<int>(plan.oriented_elements.size());
  const bool rigid = plan.rollers || plan.rigid_balls;
  effect(
      Effect::ElementOrientation, element + " orientation", oriented > 0 || rigid,
      plan.rollers ? std::string("contacts use the axes of all rollers; total rotation is computed "
                                 "only for rollers selected by kPltElemInd, kPrtOpt or kAGraf")
      : rigid && user != nullptr && user->balls_out_of_round
          ? fmt::format("user routine ADRX5 of {}: contacts of out-of-round balls use the "
                        "orientation of each ball; total rotation is computed only for balls "
                        "selected by kPltElemInd, kPrtOpt or kAGraf",
                        user->source)
      : rigid
          ? fmt::format(
                "kReIP = {}: the inertia axes of each ball rotate with the ball; total rotation is "
                "computed only for balls selected by kPltElemInd, kPrtOpt or kAGraf",
                deck.integer("kReIP"))
      : control.animate
          ? fmt::format("kAGraf = {}: all balls", control.animate_every)
          : fmt::format("{} of {} {}s, selected by kPltElemInd or kPrtOpt", oriented, n, element));
  if (!plan.has(Effect::ElementOrientation)) {
    plan.oriented_elements.clear();
    oriented = 0;
  }
  effect(Effect::WearIntegrals, "wear and power integrals", true, "SOL7 and PRINT show them");
  effect(Effect::MomentumLedger, "momentum ledger", true, "see RUN.json and PRINT");
  effect(Effect::SuppressedMotions, "suppressed motions", plan.suppressed.any(),
         fmt::format("kDOF = {}", dof));
  effect(Effect::ThermalSteps, "thermal steps", bearing.thermal.has_value(),
         bearing.thermal ? fmt::format("kTherm = 1, kGeoMod = {}", bearing.thermal->geometry_every)
                         : std::string("kTherm = 0"));
  const long long code = deck.integer("mode");
  plan.light_load_ratio = control.light_load_ratio;
  effect(Effect::LightLoadBalance, "light-load balance", control.light_load_ratio > 0.0,
         code > 0 ? mode : fmt::format("qFac = {:g}", control.light_load_ratio));
  if (!plan.has(Effect::LightLoadBalance)) plan.light_load_ratio = 0.0;
  // held_elements.hpp: nothing balances other rollers along their axes.
  const bool alone = bearing.rollers() != nullptr && bearing.type != bearing::Type::Tapered;
  effect(Effect::ElementBalance, fmt::format("force balance of all {}s", element), code > 0,
         mode + (code > 0 && alone ? ": in the radial direction only (rollers move freely along x)"
                                   : ""));
  effect(Effect::RaceBalance, "force balance of the inner race", code == 2, mode);

  if (!left_out.empty()) {
    std::string names;
    for (const scene::EffectEntry& entry : plan.effects)
      if (can_be_left_out(plan, entry.effect)) names += (names.empty() ? "" : ", ") + entry.name;
    throw InputError(
        fmt::format("run option effectsOff: this deck has no effect named \"{}\"; effects that "
                    "can be switched off: {}",
                    left_out.front(), names));
  }

  if (rigid)
    plan.bodies.push_back({fmt::format("{}s ({})", element, n),
                           "x, r, theta, quaternion, angular velocity: 6 degrees of freedom each",
                           13 * n});
  else
    plan.bodies.push_back({fmt::format("balls ({})", n),
                           "x, r, theta, angular velocity: 6 degrees of freedom each", 9 * n});
  if (oriented > 0 && rigid)
    plan.bodies.push_back(
        {fmt::format("rotation of {}s ({})", element, oriented), "total rotation", oriented});
  else if (oriented > 0)
    plan.bodies.push_back({fmt::format("orientation of balls ({})", oriented),
                           "quaternion and total rotation", 5 * oriented});
  if (const int pieces = cage ? bearing.cage->segments.count : 0; pieces > 1)
    plan.bodies.push_back({fmt::format("cage segments ({})", pieces),
                           "6 degrees of freedom and total rotation each", 14 * pieces});
  else if (cage)
    plan.bodies.push_back({"cage", "6 degrees of freedom and total rotation", 14});
  plan_race_motions(deck, bearing, plan, user != nullptr ? user->drives : std::array<bool, 2>{});
  plan.user_frame = user != nullptr && user->moves_frame;
  if (user != nullptr)
    for (std::size_t k = 0; k < user->active.size(); ++k)
      if (user->active[k])
        effect(Effect::RaceContact, fmt::format("user routine ADRX{}", k), true, user->source);
  for (const scene::BodyEntry& body : plan.bodies) plan.unknowns += body.unknowns;
  return plan;
}

}  // namespace adore::setup
