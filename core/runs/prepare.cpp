#include "runs/prepare.hpp"

#include "base/counted.hpp"
#include "base/input_file.hpp"
#include "base/interrupted.hpp"
#include "base/json_text.hpp"
#include "base/version.hpp"
#include "deck/defaults.hpp"
#include "deck/monitored_bodies.hpp"
#include "deck/unit_text.hpp"
#include "dynamics/race_contacts.hpp"
#include "dynamics/roller_start.hpp"
#include "dynamics/scene_estimate.hpp"
#include "life/contact_strength.hpp"
#include "listing/ball_warnings.hpp"
#include "runs/film_precision.hpp"
#include "runs/judge_steps.hpp"
#include "runs/law_ranges.hpp"
#include "runs/option_file.hpp"
#include "runs/pilot.hpp"
#include "runs/run_span.hpp"
#include "runs/static_plan.hpp"
#include "runs/static_quantities.hpp"
#include "runs/stiffness.hpp"
#include "runs/traction_spread.hpp"
#include "runs/user_session.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_life.hpp"
#include "setup/race_motions.hpp"
#include "setup/scene_plan.hpp"
#include "setup/unused_values.hpp"
#include "statics/ball_friction.hpp"
#include "statics/deck_fault.hpp"
#include "statics/film_doubts.hpp"
#include "statics/start_radii.hpp"
#include "thermal/operating.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/fluid.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <set>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

/// Load-weighted mean contact angle of each race, at which a dynamic run freezes its Hertz
/// constants if requested (decision 001). The free angle when no contact is loaded.
std::array<double, 2> mean_contact_angles(const statics::StaticSolution& solution,
                                          double free_angle) {
  std::array<double, 2> out{free_angle, free_angle};
  for (std::size_t j = 0; j < 2; ++j) {
    double weight = 0.0, sum = 0.0;
    for (const statics::StaticBall& ball : solution.balls)
      if (ball.Q[j] > 0.0 && std::isfinite(ball.alpha[j])) {
        weight += ball.Q[j];
        sum += ball.Q[j] * std::abs(ball.alpha[j]);
      }
    if (weight > 0.0) out[j] = sum / weight;
  }
  return out;
}

/// Equilibria do not evaluate the routine that kTrac = -1 or kRFTrac = -1 selects. The
/// curves of record 10, which such a deck has as well, do not stand in for it: balls keep the spin
/// rule, also at the start of a motion, and mode -1 has no friction.
bool disable_user_traction(Prepared& out) {
  const deck::Deck& deck = out.input.deck;
  const auto has_routine = [&](const char* code) {
    return deck.has(code) && deck.integer(code) == -1;
  };
  const bool races = has_routine("kTrac");
  if (races) out.options.rollers.ball_balance = out.options.rollers.friction_balance = false;
  if (deck.integer("mode") >= 0 || (!races && !has_routine("kRFTrac"))) return false;
  const char* const code = races ? "kTrac" : "kRFTrac";
  if (out.as_built.thermal)
    throw InputError({deck.issue(
        Severity::Error, "kTherm",
        fmt::format("needs the heat of the contacts, but mode -1 does not call their traction "
                    "routine ADRX7 ({} = -1)",
                    code),
        fmt::format("set kTherm to 0, {} to another law, or mode to 0, 1 or 2", code))});
  if (races) out.as_built.race_traction = {};
  add_remark(out, make_finding("user.idle",
                               fmt::format("{} = -1: mode -1 does not call the traction routine "
                                           "ADRX7, so it computes no friction torque and no heat{}",
                                           code,
                                           races && !out.as_built.rollers()
                                               ? ", and kAngVel determines the ball speeds"
                                               : "")));
  return true;
}

/// Seconds that an action takes.
template <class Action>
double timed(Action&& action) {
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Messages about a deck whose variables were set: remarks of the reader that still apply,
/// messages about the sets, and results of the checks.
std::vector<Issue> remarks_after_sets(const deck::Deck& given, const deck::Deck& changed,
                                      const std::vector<Issue>& read) {
  std::set<std::string> by_checks;
  for (const Issue& issue : deck::check_deck(given)) by_checks.insert(issue.text());
  std::vector<Issue> out;
  for (const Issue& issue : read) {
    const bool record_added = !given.has_record(issue.record) && changed.has_record(issue.record);
    if (by_checks.count(issue.text()) == 0 && !record_added) out.push_back(issue);
  }
  for (Issue& issue : deck::added_defaults(given, changed)) out.push_back(std::move(issue));
  for (Issue& issue : deck::check_deck(changed)) out.push_back(std::move(issue));
  return out;
}

template <class Remarks>
void remarks_to_deck_units(Remarks& remarks, deck::UnitSystem units) {
  for (Issue& issue : remarks) {
    issue.message = deck::message_in_units(issue.message, units);
    issue.remedy = deck::message_in_units(issue.remedy, units);
  }
}

/// Remarks of the library on this deck are shown to the user as remarks on the deck.
void convert_remarks_to_deck_units(Prepared& out) {
  const deck::UnitSystem units = out.input.deck.units();
  remarks_to_deck_units(out.input.warnings, units);
  remarks_to_deck_units(out.statics.notes, units);
  remarks_to_deck_units(out.start.notes, units);
  if (out.rollers) remarks_to_deck_units(out.rollers->notes, units);
  if (out.bearing.operating) remarks_to_deck_units(out.bearing.operating->warnings, units);
  for (statics::StiffnessRow& row : out.stiffness)
    if (row.operating) remarks_to_deck_units(row.operating->warnings, units);
  remarks_to_deck_units(out.life.notes, units);
  for (scene::EffectEntry& effect : out.plan.effects)
    effect.because = deck::message_in_units(effect.because, units);
  if (out.life.iso) remarks_to_deck_units(out.life.iso->notes, units);
}

/// Nodes of balls in oil, unless the options ask for others: those made for films that follow the
/// pressure point by point, or for films of whole strips (kTrac 8, 12; decision 328). If one
/// number is given, the other is that of equal pieces: 15 x 4, because two across sample
/// one pressure of a row and heat is up to a tenth off (decision 414), or 20 strips (decision 326).
/// The laws of record 10.1 need 15 x 2.
void choose_ellipse_nodes(Prepared& prepared) {
  const auto& oil = prepared.as_built.lubrication;
  if (!oil || prepared.as_built.rollers()) return;
  const bool strips =
      tribology::lubricant_of(*oil).model == tribology::LubricantModel::ViscoElastic;
  const bool major = prepared.input.option_values.contains("ellipseMajor"),
             minor = prepared.input.option_values.contains("ellipseMinor");
  scene::SystemOptions& system = prepared.options.system;
  if (!major && !minor) {
    const tribology::EllipseNodeCounts own =
        strips ? tribology::kStripNodes : tribology::kFilmNodes;
    system.ellipse_major = own.major;
    system.ellipse_minor = own.minor;
  } else if (!major) {
    system.ellipse_major = strips ? 20 : 15;
  } else if (!minor) {
    system.ellipse_minor = strips ? 2 : 4;
  }
}

/// Run options of the films between elements and races.
void set_film_options(Prepared& out) {
  if (!out.as_built.lubrication) return;
  bearing::Lubrication& oil = *out.as_built.lubrication;
  oil.direct_strips = out.options.direct_strips;
  oil.stress_limit = out.options.stress_limit;
  oil.recommended = out.options.recommended_law;
  if (!oil.stress_limit)
    add_remark(out, make_finding(
                        "film.stress_limit_off",
                        "run option filmStressLimit = off: oil films have no limiting "
                        "shear stress. Above 1 GPa, friction coefficients can be far too large."));
  if (!oil.user) return;
  oil.user->limit_ratio = out.options.user_limit;
  oil.user->limit_softening = out.options.user_softening;
  if (oil.stress_limit && !out.options.user_limit)
    add_remark(
        out,
        make_finding(
            "film.stress_limit_assumed",
            fmt::format(
                "limiting shear stress of the user-defined lubricant: not given. At 40 °C, {:g} "
                "times the pressure is assumed (estimate). Set run option lubStressLimit.",
                tribology::kUserLimit)));
}

/// Reports where films, the oil at the cage and a churning medium are outside their known
/// range. @throws statics::DeckFault
void check_fluid_ranges(Prepared& out) {
  const bearing::Bearing& b = out.bearing;
  using statics::FilmUse;
  const FilmUse use = !out.control.dynamic ? FilmUse::Equilibrium
                      : b.thermal          ? FilmUse::ThermalSteps
                                           : FilmUse::Motion;
  if (const auto& films = out.race_result().films)
    for (Finding& one : statics::film_doubts(*films, use)) add_remark(out, std::move(one));
  const auto check_flow = [&](const char* flag, double kelvin, const char* place) {
    const tribology::Lubricant oil = tribology::lubricant_of(*b.lubrication);
    if (auto one =
            statics::oil_flow_warning(flag, oil.name, kelvin, oil.base_viscosity(kelvin), place))
      add_remark(out, std::move(*one));
  };
  if (out.control.dynamic && b.lubrication && b.cage && b.cage_films) {
    const bearing::CageFilms& cage = *b.cage_films;
    const bool pockets = cage.pockets && cage.pocket_viscosity == 0.0;
    if (pockets || (cage.lands && cage.land_viscosity == 0.0))
      check_flow(pockets ? "kPocHydro" : "kGsHydro", b.cage_temperature, "the oil at the cage");
  }
  if (!b.churning) return;
  const tribology::ChurningMedium medium = tribology::churning_medium(b);
  if (b.churning->code == 1)
    check_flow("kChrn", medium.temperature, "the churning medium");
  else if (medium.is_temperature_clamped())
    add_remark(out,
               make_finding(
                   "fluid.medium_range",
                   fmt::format("the properties of {}, the churning medium, are known from {:g} to "
                               "{:g} K. Its temperature is {:.4g} K, so the properties at the "
                               "nearer end of the range are used",
                               medium.name, medium.T_min, medium.T_max, medium.temperature))
                   .measure(medium.temperature, medium.T_max));
}

/// Value, bounds and body of ranges that more detailed remarks describe.
void fill_from_ranges(std::vector<Finding>& remarks, const std::vector<validity::Finding>& left) {
  for (Finding& remark : remarks) {
    const FindingKind* kind = find_finding_kind(remark.code);
    if (kind == nullptr || kind->range.empty() || remark.measured) continue;
    for (const validity::Finding& one : left) {
      if (one.range->id != kind->range) continue;
      const Finding data = finding_of_range(one);
      remark.quantity = data.quantity;
      remark.unit = data.unit;
      remark.measured = data.measured;
      remark.least = data.least;
      remark.limit = data.limit;
      remark.body = data.body;
      remark.time = data.time;
    }
  }
}

/// Rows of the stiffness table without a friction equilibrium: the first one's reason.
void report_stiffness_fallbacks(Prepared& out) {
  std::size_t without = 0;
  const statics::StiffnessRow* first = nullptr;
  for (const statics::StiffnessRow& row : out.stiffness) {
    if (row.result.notes.empty()) continue;
    if (first == nullptr) first = &row;
    ++without;
  }
  if (first == nullptr) return;
  constexpr double kRpm = 30.0 / std::numbers::pi;
  add_remark(
      out, make_finding("statics.friction_balance",
                        fmt::format("stiffness over speed: no friction equilibrium was found in {} "
                                    "of the table, first at rpm1 = {:g} and rpm2 = {:g}: {}",
                                    counted(without, "row"), kRpm * first->speed[0],
                                    kRpm * first->speed[1], first->result.notes.front().message)));
}

/// Laws that the quasi-static solution takes outside their range of validity. What other remarks
/// on the solution describe in more detail is kept for RUN.json alone.
void find_exceeded_ranges(Prepared& out) {
  LawValidityMonitor ranges(out.bearing);
  const statics::FrictionEstimate* const friction = out.friction ? &*out.friction : nullptr;
  if (out.rollers)
    ranges.check(*out.rollers, friction);
  else
    ranges.check(out.control.dynamic ? out.start : out.statics, friction);
  ranges.check(out.life);
  out.left_ranges = ranges.findings();
  if (out.control.dynamic && !out.plan.has(scene::Effect::RollingResistance))
    out.left_ranges = without(std::move(out.left_ranges), {"rolling.strips"});
  const auto new_ones =
      without(out.left_ranges,
              {"film.thickness", "film.viscosity", "hertz.ellipse", "hertz.shoulder", "hertz.yield",
               "drag.temperature", "materials.temperature", "rolling.strips"});
  for (const validity::Finding& left : new_ones) add_remark(out, finding_of_range(left));
  fill_from_ranges(out.input.warnings, out.left_ranges);
  if (auto one = ranges.friction_coefficient_finding()) add_remark(out, std::move(*one));
  if (const std::string text = traction_spread(out); !text.empty())
    add_remark(out, make_finding("friction.spread", text));
}

/// Reports where properties of the medium around the elements are recalled or estimated.
void report_fluid_uncertainty(Prepared& out) {
  const auto report = [&](const std::string& name, const std::string& provenance,
                          const char* what) {
    const char* const known = provenance == "estimated"  ? "are partly estimates"
                              : provenance == "recalled" ? "are partly not verified"
                                                         : nullptr;
    if (known != nullptr)
      add_remark(out, make_finding("fluid.certainty",
                                   fmt::format("the properties of {} ({}) {}. Results that depend "
                                               "on them have the same uncertainty",
                                               name, what, known)));
  };
  const bearing::Bearing& b = out.bearing;
  if (b.lubrication) {
    const tribology::Lubricant oil = tribology::lubricant_of(*b.lubrication);
    report(oil.name, oil.provenance, "the lubricant");
  }
  if (b.churning) {
    const tribology::ChurningMedium medium = tribology::churning_medium(b);
    if (b.churning->code > 2) report(medium.name, medium.provenance, "the churning medium");
  }
  if (b.thermal && b.thermal->coolant > 2 && b.thermal->flow > 0.0) {
    const tribology::FluidProperties coolant =
        tribology::fluid_properties(b.thermal->coolant, b.thermal->base_temperature);
    report(coolant.name, coolant.provenance, "the coolant");
  }
}

/// Effect of contact damping being off, if specified.
void report_contact_damping(Prepared& out) {
  const auto given = out.input.option_values.find("contactDamping");
  if (!out.plan.has(scene::Effect::ContactDamping))
    add_remark(out,
               make_finding(
                   "damping.off",
                   "contact damping is off: contact vibrations do not decay, so the largest loads, "
                   "the life and the spectra are not realistic. Set contactDamping = material"));
  else if (given != out.input.option_values.end() && out.plan.has(scene::Effect::ElementBalance))
    add_remark(out, make_finding(
                        "damping.idle",
                        fmt::format("contactDamping = {} has no effect at the races, because mode "
                                    "= {} keeps all elements in force balance with the races",
                                    given->second, out.input.deck.integer("mode"))));
}

/// The bearing for the statics of rollers: with the radii of rollers that are not round.
bearing::Bearing at_start(Prepared& out) {
  if (!out.user || !out.user->has_out_of_round_elements()) return out.bearing;
  if (auto changed = statics::with_start_radii(out.bearing, out.user->out_of_round()))
    return *changed;
  add_remark(out, make_finding(
                      "user.idle",
                      "ADRX5: the equilibrium uses the mean radius of each roller, because a race "
                      "has land offsets, or a surface that varies around and across the race"));
  return out.bearing;
}

/// @throws Interrupted when the preparation is to end.
void check_interrupt(const LoadedDeck& input) {
  if (input.stop.stop_requested())
    throw Interrupted("interrupted during the search for the equilibrium; no files were written");
}

Prepared prepare_model(LoadedDeck input) {
  Prepared out;
  out.input = std::move(input);
  const deck::Deck& deck = out.input.deck;
  out.options = setup::build_run_options(out.input.option_values);
  out.input.deck.reads = std::make_shared<deck::ReadLog>();
  out.options.rollers.first_azimuth = start_azimuth(deck);
  out.user = open_user_session(out.input, out.options);
  setup::UserHooks hooks = user_hooks(out.user, out.options);
  const setup::UserHooks* const user = out.user ? &hooks : nullptr;
  out.as_built = setup::build_bearing(deck, out.options.seed, user);
  out.as_built.user_version =
      program_version(out.user.get()).substr(std::string_view(kProgramVersion).size());
  const bool unknown_traction = disable_user_traction(out);
  out.options.rollers.frame = setup::frame_motion(deck);
  out.as_built.mounting.centrifugal_growth = out.options.centrifugal_growth;
  set_film_options(out);
  if (out.as_built.thermal) {
    out.as_built.thermal->model = out.options.thermal_model;
    out.as_built.thermal->surroundings = out.options.surroundings;
    if (!out.options.thermal_base) {
      if (out.options.thermal_model == bearing::ThermalModel::Ladder)
        throw InputError(
            "run option thermalBase = none: thermalModel=ladder needs a base temperature. Use "
            "thermalModel=network.");
      out.as_built.thermal->base = static_cast<int>(thermal::BaseNode::None);
    }
    if (out.options.thermal_transient && out.options.thermal_model == bearing::ThermalModel::Ladder)
      throw InputError(
          "run option thermalTransient = on: thermalModel=ladder has no heat capacities. Use "
          "thermalModel=network.");
  }
  choose_ellipse_nodes(out);
  for (Issue& issue : setup::check_buildable(deck, user))
    out.input.warnings.push_back(std::move(issue));
  if (out.as_built.thermal && deck.integer("mode") < 0) {
    const auto interrupt = [&] {
      if (out.input.stop.stop_requested())
        throw Interrupted("interrupted during the thermal analysis; no files were written");
    };
    if (out.options.thermal_transient) {
      out.time_line =
          thermal::solve_thermal_transient(out.as_built, out.options.rollers, interrupt);
      if (!out.time_line->settled) throw SolverError("thermal time line: " + out.time_line->end);
      if (!out.time_line->fallback.empty())
        add_remark(out, make_finding("statics.friction_balance",
                                     "thermal time line: " + out.time_line->fallback));
    }
    out.thermal = thermal::solve_steady_state(out.as_built, out.options.rollers, interrupt);
    out.as_built = out.thermal->as_built;
    out.bearing = out.thermal->operating;
    for (Finding note : out.thermal->heat.notes) {
      note.message = "thermal analysis: " + note.message;
      add_remark(out, std::move(note));
    }
  } else {
    out.bearing = thermal::operating_bearing(out.as_built);
  }
  for (Finding& one : operating_warnings(out.bearing, out.input.path.string()))
    out.input.warnings.push_back(std::move(one));
  out.control = setup::build_run_control(deck);
  if (out.control.dynamic)
    for (bearing::Bearing* one : {&out.as_built, &out.bearing})
      if (one->lubrication) one->lubrication->tolerance = out.control.tolerance;
  choose_film_precision(out);
  const bearing::LifeInputs life_inputs = setup::build_life_inputs(deck, out.options.life);
  out.no_part = setup::find_unused_values(deck);
  out.input.deck.reads.reset();  // the rest reads the deck for texts
  if (std::optional<Issue> note = setup::note_unused_values(
          out.no_part, deck, {out.input.warnings.begin(), out.input.warnings.end()}))
    out.input.warnings.push_back(std::move(*note));
  if (out.user && out.control.dynamic) {
    start_user_session(out, hooks);
    for (Issue& issue : loads_on_fixed_races(out)) out.input.warnings.push_back(std::move(issue));
  }
  if (out.user)
    for (const std::string& text : unused_routines(out))
      add_remark(out, make_finding("user.idle", text));
  out.plan = out.control.dynamic
                 ? setup::make_scene_plan(deck, out.bearing, out.control, out.options, user)
                 : static_plan(out);
  if (out.control.dynamic && out.plan.suppressed.of_elements())
    out.options.rollers.friction_balance = false;  // motions that are given, not balanced
  if (out.control.dynamic) report_contact_damping(out);
  out.stiffness_seconds = timed([&] { out.stiffness = stiffness_over_speed(out); });
  // The first speed at which the table's geometry gives way.
  for (const statics::StiffnessRow& row : out.stiffness) {
    if (!row.operating || row.operating->warnings.empty()) continue;
    constexpr double kRpm = 30.0 / std::numbers::pi;
    for (const Finding& one : row.operating->warnings)
      add_remark(
          out, make_finding(
                   "fit.stiffness_table",
                   fmt::format("stiffness over speed: from rpm1 = {:g} and rpm2 = {:g} upwards, {}",
                               kRpm * row.speed[0], kRpm * row.speed[1], one.message))
                   .of(one.body)
                   .measure("speed of the inner race", kRpm * row.speed[1], "rpm"));
    break;
  }
  report_stiffness_fallbacks(out);
  const auto judge = [&](const life::RaceStrength& strength) {
    for (Finding& one : life::strength_warnings("statics.yield", out.bearing, strength))
      add_remark(out, std::move(one));
  };
  check_interrupt(out.input);
  if (out.bearing.rollers()) {
    out.solve_seconds = timed(
        [&] { out.rollers = statics::solve_roller_statics(at_start(out), out.options.rollers); });
    for (Finding& one : out.rollers->friction.findings()) add_remark(out, std::move(one));
    if (out.bearing.lubrication)
      out.rollers->films = statics::contact_films(out.bearing, *out.rollers);
    check_fluid_ranges(out);
    report_fluid_uncertainty(out);
    if (!out.control.dynamic && !unknown_traction)
      out.friction = statics::friction_estimate(out.bearing, *out.rollers);
    judge(life::contact_strength(out.bearing, *out.rollers));
    out.life = life::roller_bearing_life(out.bearing, life_inputs, *out.rollers);
    if (out.control.dynamic) {
      auto scene = std::make_shared<dynamics::RollerStaticResult>();
      scene->options = out.options.rollers;
      scene->solution = *out.rollers;
      out.start = dynamics::static_start(*scene, out.bearing);
      out.roller_scene = std::move(scene);
      if (out.rollers->guide_force > 0.0)
        add_remark(
            out,
            make_finding(
                "statics.guide_force",
                fmt::format(
                    "the equilibrium holds each roller along its axis with a force of {:.4g} N, as "
                    "a guide ring does. In motion, only the groove and friction hold the roller",
                    out.rollers->guide_force))
                .measure(out.rollers->guide_force));
    }
    find_exceeded_ranges(out);
    return out;
  }
  const statics::Forms forms = out.user ? out.user->out_of_round() : statics::Forms();
  statics::FrictionBalance balance;
  out.solve_seconds = timed([&] {
    out.statics =
        statics::solve_balls_with_friction(out.bearing, ball_statics_options(out), forms, balance);
  });
  for (Finding& one : balance.findings()) add_remark(out, std::move(one));
  if (out.bearing.lubrication) out.statics.films = statics::contact_films(out.bearing, out.statics);
  check_fluid_ranges(out);
  report_fluid_uncertainty(out);
  if (!out.control.dynamic && !unknown_traction)
    out.friction = statics::friction_estimate(out.bearing, out.statics, balance);
  const bool rolls = !out.control.dynamic || out.plan.has(scene::Effect::RollingResistance);
  if (const double ratio =
          rolls ? statics::rolling_point_strip_ratio(out.bearing, out.statics) : 0.0;
      ratio > validity::range("rolling.strips").bounds.most)
    add_remark(
        out,
        make_finding(
            "rolling.thick_oil",
            fmt::format(
                "rolling resistance of the balls in oil: the law does not include the "
                "pressure-viscosity coefficient of the oil. Its result is {:.2g} times the result "
                "of the line-contact law, which includes this coefficient and is applied to strips "
                "of the contact. Solutions of Reynolds' equation for point contacts are between "
                "these two results (up to 2.5 times the result for strips). At this viscosity and "
                "speed, the resistance and its heat may be about {:.0f} % too large",
                ratio, 100.0 * (statics::rolling_resistance_excess(ratio) - 1.0)))
            .measure(ratio, validity::range("rolling.strips").bounds.most));
  judge(life::contact_strength(out.bearing, out.statics));
  for (Finding& one : listing::ball_warnings(out.bearing, out.statics,
                                             available_friction(deck, out.bearing), deck.units()))
    add_remark(out, std::move(one));
  if (out.control.dynamic) {
    out.fixed_angle = mean_contact_angles(out.statics, out.bearing.balls().contact_angle);
    statics::BallStaticsOptions as_in_motion = ball_statics_options(out);
    as_in_motion.curvature =
        out.options.system.moving_angle ? statics::Curvature::Potential : statics::Curvature::Fixed;
    as_in_motion.fixed_angle = out.fixed_angle;
    check_interrupt(out.input);
    statics::FrictionBalance of_motion;
    out.start = statics::solve_balls_with_friction(out.bearing, as_in_motion, forms, of_motion);
    if (balance.findings().empty())
      for (Finding& one : of_motion.findings()) {
        one.message = "start of the motion: " + one.message;
        add_remark(out, std::move(one));
      }
    if (out.bearing.lubrication) out.start.films = statics::contact_films(out.bearing, out.start);
  }
  out.life = life::ball_bearing_life(out.bearing, life_inputs,
                                     out.control.dynamic ? out.start : out.statics);
  find_exceeded_ranges(out);
  return out;
}

}  // namespace

double start_azimuth(const deck::Deck& deck) {
  return deck.has("startAngle") ? deck.si("startAngle") : 0.0;
}

statics::BallStaticsOptions ball_statics_options(const Prepared& prepared) {
  statics::BallStaticsOptions out;
  out.frame = prepared.options.rollers.frame;
  out.friction_balance = prepared.options.rollers.ball_balance;
  out.first_azimuth = start_azimuth(prepared.input.deck);
  return out;
}

void add_remark(Prepared& prepared, Finding finding) {
  finding.file = prepared.input.path.string();
  finding.message = deck::message_in_units(finding.message, prepared.input.deck.units());
  prepared.input.warnings.push_back(std::move(finding));
}

std::map<std::string, std::string> options_of_deck(const fs::path& deck_file) {
  return usable_options_of_deck(deck_file).values();
}

fs::path deck_path(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    if (fs::exists(path / "DATA.txt", error)) return path / "DATA.txt";
    throw InputError(
        fmt::format("there is no DATA.txt in the folder {}; give a deck, or create one with `adore "
                    "new ball --out {}`",
                    path.string(), (path / "DATA.txt").string()));
  }
  if (!fs::exists(path, error))
    throw InputError(
        fmt::format("there is no deck {}; `adore new ball --out {}` writes a complete deck",
                    path.string(), path.string()));
  return path;
}

fs::path deck_path(const DeckRequest& request) {
  if (!request.text) return deck_path(request.deck);
  return request.in_memory ? request.deck : fs::path(kStandardInput);
}

deck::ReadResult read_deck(const DeckRequest& request) {
  const fs::path path = deck_path(request);
  deck::ReadResult out =
      request.text ? deck::read_deck_text(*request.text, path.string()) : deck::read_deck(path);
  // User routines read all lines of record 12: they need no warning.
  if (request.routines || !request.user.empty())
    std::erase_if(out.issues, [](const Issue& issue) { return issue.record == "12"; });
  if (!request.in_memory && out.ok()) try {
      for (Issue& issue : set_extension(out.deck, usable_options_of_deck(path), path))
        out.issues.push_back(std::move(issue));
    } catch (const InputError& error) {
      out.issues.insert(out.issues.end(), error.issues().begin(), error.issues().end());
    }
  return out;
}

LoadedDeck load_deck(const DeckRequest& request) {
  LoadedDeck out;
  out.path = deck_path(request);
  deck::ReadResult read = read_deck(request);
  std::vector<Issue> issues = std::move(read.issues);
  out.deck = std::move(read.deck);
  if (!(request.sets.empty() && request.changes.empty()) && read.ok()) {
    const deck::Deck given = out.deck;
    std::vector<Issue> bodies;
    for (const auto* sets : {&request.sets, &request.changes})
      for (Issue& issue : deck::set_all_and_renumber(out.deck, *sets))
        bodies.push_back(std::move(issue));
    issues = remarks_after_sets(given, out.deck, issues);
    for (Issue& issue : bodies) {
      issue.file = out.path.string();
      issues.push_back(std::move(issue));
    }
  }
  bool wrong = false;
  for (const Issue& issue : issues) wrong = wrong || issue.severity == Severity::Error;
  if (wrong) throw InputError(std::move(issues));
  out.warnings = findings_of(std::move(issues));
  if (!request.in_memory) out.option_values = options_of_deck(out.path);
  for (const auto& [name, value] : request.options) out.option_values[name] = value;
  out.user = request.user;
  out.routines = request.routines;
  return out;
}

std::vector<Finding> operating_warnings(const bearing::Bearing& bearing, const std::string& file) {
  std::vector<Finding> out;
  if (bearing.operating) out = bearing.operating->warnings;
  for (Finding& one : out) one.file = file;
  return out;
}

std::vector<Finding> solution_notes(const Prepared& prepared) {
  std::vector<Finding> out = prepared.race_result().notes;
  const auto add = [&out](const std::vector<Finding>& notes) {
    out.insert(out.end(), notes.begin(), notes.end());
  };
  add(prepared.life.notes);
  if (prepared.life.iso) add(prepared.life.iso->notes);
  for (Finding& finding : out) finding.file = prepared.input.path.string();
  return out;
}

Prepared prepare(const DeckRequest& request, std::stop_token stop) {
  dynamics::check_instruction_set_request();
  LoadedDeck input = load_deck(request);
  input.stop = std::move(stop);
  return prepare(std::move(input));
}

Prepared prepare(LoadedDeck input) {
  const std::string file = input.path.string();
  const deck::Deck deck = input.deck;  // for its messages
  const deck::UnitSystem units = deck.units();
  (void)setup::build_run_options(input.option_values);  // their errors are not errors of the deck
  try {
    Prepared out = prepare_model(std::move(input));
    convert_remarks_to_deck_units(out);
    return out;
  } catch (const InputError& error) {
    std::vector<Issue> issues = error.issues();
    for (Issue& issue : issues)
      if (issue.file.empty()) issue.file = file;
    remarks_to_deck_units(issues, units);
    throw InputError(std::move(issues));
  } catch (const statics::DeckFault& error) {  // a fault of the deck, not of the numerics
    Issue issue =
        deck.issue(Severity::Error, error.variable(), deck::message_in_units(error.why(), units),
                   deck::message_in_units(error.remedy(), units));
    throw InputError(std::vector<Issue>{std::move(issue)});
  } catch (const SolverError& error) {
    throw SolverError(deck::message_in_units(error.what(), units));
  }
}

dynamics::System make_system(const Prepared& prepared) {
  return dynamics::System(prepared.bearing, prepared.plan, prepared.start, prepared.fixed_angle,
                          prepared.options.system, {}, prepared.roller_scene);
}

void add_approximation_note(scene::ScenePlan& plan, const dynamics::System& system) {
  const std::string note = system.approximation_note();
  if (note.empty()) return;
  for (scene::EffectEntry& effect : plan.effects)
    if (effect.effect == scene::Effect::RaceTraction) effect.because += "; " + note;
}

scene::ScenePlan plan_with_estimates(const Prepared& prepared) {
  scene::ScenePlan plan = prepared.plan;
  if (!prepared.control.dynamic) return plan;
  dynamics::System system = make_system(prepared);
  add_approximation_note(plan, system);
  dynamics::estimate(plan, prepared.bearing, prepared.start, system);
  const StepJudgment steps = judge_steps(prepared, system.scales().time);
  if (steps.limits.action == StepAction::Refused) return plan;
  constexpr double kBudget = 0.1;  // [s]
  const PilotResult pilot = run_pilot(prepared, system, steps.limits, steps.request.turn, kBudget);
  const double step =
      pilot.step > 0.0 ? pilot.step
                       : std::clamp(plan.expected_step, steps.limits.minimum, steps.limits.maximum);
  const double more = plan.expected_step / step;
  plan.expected_step = step;
  plan.steps_per_revolution *= more;
  plan.seconds_per_revolution = pilot.step > 0.0
                                    ? plan.steps_per_revolution * pilot.seconds_per_step
                                    : plan.seconds_per_revolution * more;
  return plan;
}

std::string step_stability_text(const Prepared& prepared) {
  if (!prepared.control.dynamic) return {};
  return judge_steps(prepared, make_system(prepared).scales().time).text;
}

/// End of a run of this deck, in revolutions: its time, or its steps before that.
std::string end_text(const Prepared& prepared, const scene::ScenePlan& plan) {
  const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  if (!(speed > 0.0) || !(plan.steps_per_revolution > 0.0) || speeds_vary(prepared))
    return "set by fTime or maxStps, whichever is reached first";
  const double by_time = prepared.control.end_time * make_system(prepared).scales().time * speed /
                         (2.0 * std::numbers::pi);
  const double by_steps = static_cast<double>(prepared.control.max_steps) *
                          prepared.control.substeps / plan.steps_per_revolution;
  if (by_steps < by_time)
    return fmt::format("about {}, limited by maxStps; fTime would allow {:.4g}",
                       counted(fmt::format("{:.3g}", by_steps), "revolution"), by_time);
  return counted(fmt::format("{:.4g}", by_time), "revolution") + ", limited by fTime";
}

std::string plan_text(const Prepared& prepared, const scene::ScenePlan& plan) {
  std::string out =
      fmt::format("{}\n{}\n\nbodies\n", prepared.input.path.string(), prepared.bearing.run_id);
  for (const scene::BodyEntry& body : plan.bodies)
    out += body.degrees.size() <= 52 ? fmt::format("  {:<24} {:<52} {:>5} unknowns\n", body.name,
                                                   body.degrees, body.unknowns)
                                     : fmt::format("  {:<24} {}\n  {:<24} {:<52} {:>5} unknowns\n",
                                                   body.name, body.degrees, "", "", body.unknowns);
  out += fmt::format("  {:<24} {:<52} {:>5}\n\neffects\n", "total", "", plan.unknowns);
  for (const scene::EffectEntry& effect : plan.effects)
    out +=
        fmt::format("  {:<3} {:<30} {}\n", effect.on ? "on" : "off", effect.name, effect.because);
  if (!prepared.control.dynamic) return out + static_cost_text(prepared);
  out += fmt::format(
      "\nestimates\n"
      "  fastest frequency        {:.4g} Hz, {}\n"
      "  expected step            {:.3g} s ({})\n"
      "  steps per revolution     {:.4g}\n"
      "  CPU time per revolution  {:.3g} s\n"
      "  end of the run           {}\n"
      "  stability                {}\n",
      plan.fastest_frequency, plan.fastest_contact, plan.expected_step, prepared.control.integrator,
      plan.steps_per_revolution, plan.seconds_per_revolution, end_text(prepared, plan),
      step_stability_text(prepared));
  return out;
}

}  // namespace adore::runs
