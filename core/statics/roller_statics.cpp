#include "statics/roller_statics.hpp"

#include "base/errors.hpp"
#include "statics/missing_thrust.hpp"
#include "statics/race_text.hpp"
#include "statics/roller_friction.hpp"
#include "statics/roller_report.hpp"
#include "statics/stiffness_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::statics {
namespace {

/// Radial closure of a race on its rollers under a load of one of them, in the direction of the
/// contact.
double closure(const RollerModel& m, double load) { return 2.0 * line_approach(m, load); }

/// Cold start: play closed, and about the deflection of the heaviest roller (Q = 4.6 F/(Z cos α),
/// the radial bearing with play: 5 for points, 4.6 for lines).
Vec5 first_guess(const RollerModel& m, const RaceLoadCase& task, const Vec5& given) {
  Vec5 q = given;
  const auto& g = m.rollers;
  const double count = g.count;
  const auto is_free = [&](int k) {
    return !task.given[static_cast<std::size_t>(k)] && given(k) == 0.0;
  };
  const double cosine = std::cos(g.race_angle[1]);
  const double sine = std::sin(g.race_angle[1]);
  const double radial =
      std::hypot(is_free(1) ? task.load(1) : 0.0, is_free(2) ? task.load(2) : 0.0);
  if (radial > 0.0) {
    const double shift =
        0.5 * g.clearance * cosine * cosine + closure(m, 4.6 * radial / (count * cosine)) / cosine;
    for (int k = 1; k < 3; ++k) {
      if (is_free(k)) {
        q(k) = shift * task.load(k) / radial;
      }
    }
  }
  const double thrust = is_free(0) ? task.load(0) : 0.0;
  if (thrust != 0.0) {
    if (sine > 0.0) {
      q(0) = std::copysign(closure(m, std::abs(thrust) / (count * sine)) / sine, thrust);
      if (g.bench && g.shape != bearing::RollerShape::Arc) {
        q(0) += 0.5 * g.clearance / std::tan(g.race_angle[0]);  // cones that grew into each other
      }
    } else {
      q(0) = std::copysign(0.5 * (g.flange_play[0] + g.flange_play[1]), thrust);
    }
  }
  return q;
}

Vec5 displacement_of(const RollerSolution& solution) {
  return Eigen::Map<const Vec5>(solution.displacement.data());
}

/// Where the earlier solution ended, but what is given now; moved on by its stiffness towards the
/// load of now if that is a small step.
Vec5 start_displacement(const RollerModel& m, const RollerSolution& start, const RaceLoadCase& task,
                        const Vec5& given) {
  const Vec5 before = displacement_of(start);
  Vec5 q = given;
  for (Eigen::Index k = 0; k < 5; ++k) {
    if (!task.given[static_cast<std::size_t>(k)]) {
      q(k) = before(k);
    }
  }
  const RaceScales scales = race_scales(m);
  const Vec5 load = Eigen::Map<const Vec5>(start.load.data()) + start.stiffness * (q - before);
  const double force = std::max(force_scale(scales, task, start.max_load), 1e-300);
  const double k_ref = reference_stiffness(m, force);
  const Vec5 step =
      newton_step(scaled_stiffness(scales, task, start.stiffness, k_ref),
                  scaled_residual(scales, task, load), k_ref, force, scales.longest_step)
          .direction;
  const bool small = step.cwiseAbs().maxCoeff() < 0.1 * scales.longest_step;
  return small ? moved(scales, q, step, 1.0) : q;
}

/// All rollers with the race at q; where they were in an earlier solution, if there is one.
RollerRace rollers_at(const RollerModel& model, const RollerSolution* start, const Vec5& q) {
  RollerRace state;
  state.q = q;
  for (std::size_t k = 0; k < model.azimuth.size(); ++k) {
    RollerState roller;
    roller.number = k;
    roller.sin = std::sin(model.azimuth[k]);
    roller.cos = std::cos(model.azimuth[k]);
    if (start && k < start->rollers.size() && !start->rollers[k].idle) {
      const StaticRoller& before = start->rollers[k];
      roller.e = {before.x, before.r - 0.5 * model.rollers.pitch_diameter,
                  before.tilt + model.rollers.axis_angle};
      roller.follow = before.follow;
      roller.known = true;
      follow_race(model, q - displacement_of(*start), roller);
    }
    state.elements.push_back(roller);
  }
  return state;
}

/// Contact angle of the row where the race is at q: barrels turn with the line between the groove
/// centres, cones keep that of the outer race.
double row_angle(const RollerModel& m, const Vec5& q) {
  if (m.rollers.shape != bearing::RollerShape::Arc) {
    return m.rollers.race_angle[0];
  }
  return std::atan2(m.race[1].groove_x + q(0) - m.race[0].groove_x,
                    m.race[1].groove_centre_radius - m.race[0].groove_centre_radius);
}

/// Each roller hands on what it gets along the outer normal, so that F_x >= F_r tan α, F_r the
/// radial load; cones add the centrifugal force of all Z rollers, which the rib of the inner race
/// takes along x (that of barrels their guide ring holds): F_x >= (F_r + Z F_c) tan α. Why a row
/// whose x is free has no equilibrium; empty when that is not the reason.
std::string missing_thrust(const RollerModel& m, const RaceLoadCase& task, const Vec5& q) {
  const auto& flange = m.rollers.flange;
  if (task.given[0] || !(m.rollers.race_angle[0] > 0.0) || (flange[0][0] && flange[1][1])) {
    return "";
  }
  const double radial =
      std::hypot(task.given[1] ? 0.0 : task.load(1), task.given[2] ? 0.0 : task.load(2));
  const double angle = row_angle(m, Vec5::Zero());
  const bool cones = m.rollers.shape != bearing::RollerShape::Arc || m.guide[0] == 0.0;
  const double thrown = m.moving && cones ? m.rollers.count * m.centrifugal : 0.0;
  const double needed = (radial + thrown) * std::tan(angle);
  const double still = (radial + thrown) * std::tan(row_angle(m, q));
  if (!(task.load(0) < needed && task.load(0) < still)) {
    return "";
  }
  constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
  std::string text = fmt::format(
      ". A row with a contact angle of {:.4g} degrees supports thrust towards +x only, and each "
      "roller converts its radial load{} into thrust. Under a radial load of {:.6g} N the row "
      "needs an axial load of at least {} tan α = {:.4g} N along x, but the axial load is {:.6g} N",
      angle * kDegreesPerRadian,
      thrown > 0.0 ? fmt::format(" and its centrifugal force of {:.4g} N", m.centrifugal) : "",
      radial, thrown > 0.0 ? "(F_r + Z F_c)" : "F_r", needed, task.load(0));
  if (m.rollers.shape == bearing::RollerShape::Arc) {
    text += fmt::format(
        " (at the last race position, x = {:.4g} m, the contact angle is {:.4g} degrees)", q(0),
        row_angle(m, q) * kDegreesPerRadian);
  }
  return text;
}

/// Newton ended with the race well out of the row for want of thrust: no other search finds more.
bool slides_out(const RollerModel& m, const RaceLoadCase& task, const Vec5& q) {
  return q(0) < -0.25 * m.rollers.length && !missing_thrust(m, task, q).empty();
}

/// Cylinders that friction holds stand where the rule puts them, not where the search left them:
/// moves those that no flange loads back and says whether there were any.
bool centre_gripped(const RollerModel& m, RollerRace& state) {
  bool any = false;
  for (RollerState& roller : state.elements) {
    if (roller.e(0) == 0.0) {
      continue;
    }
    const StaticRoller now = report_roller(m, state.q, roller);
    const double nothing = 1e-6 * state.largest_contact;
    const bool pushed =
        std::any_of(now.flange.begin(), now.flange.end(), [nothing](const auto& of_race) {
          return of_race[0].load > nothing || of_race[1].load > nothing;
        });
    if (!pushed) {
      roller.e(0) = 0.0;
      any = true;
    }
  }
  return any;
}

UnstableMode unstable_at(const RollerModel& m, const RaceLoadCase& task, const RollerRace& state) {
  const double k_ref = reference_stiffness(m, std::max(state.largest_contact, 1e-300));
  return unstable_mode(race_scales(m), task, state.stiffness, k_ref);
}

[[noreturn]] void throw_no_equilibrium(const RollerModel& m, const RaceLoadCase& task,
                                       const RaceSolveResult& solve, const RollerRace& state) {
  const std::string loads = load_text(task);
  const double tilt = std::hypot(state.q(3), state.q(4));
  if (const std::string why = missing_thrust(m, task, state.q); !why.empty()) {
    throw MissingThrust(
        fmt::format("bearing equilibrium: no roller or flange supports the inner race under {}; "
                    "the inner race moved to x = {:.4g} m, y = {:.4g} m, z = {:.4g} m{}",
                    loads, state.q(0), state.q(1), state.q(2), why),
        std::string(m.moving ? "reduce the speed, apply" : "apply") +
            " the required axial load, or prescribe x (kFS1 = 1) if a second row or the shaft "
            "supports the thrust");
  }
  const bool barrels = m.rollers.shape == bearing::RollerShape::Arc;
  const bool may_tilt = !task.given[3] || !task.given[4];
  const double far = 0.5 * race_scales(m).reach;
  if ((solve.ran_away && tilt * race_scales(m).lever > far) ||
      (barrels && may_tilt && tilt * race_scales(m).lever > 0.1 * far)) {
    throw SolverError(
        fmt::format("bearing equilibrium: nothing prevents the inner race from tilting under {}. "
                    "At a tilt of {:.3g} rad (about y {:.3g}, about z {:.3g}) the rollers lost "
                    "their equilibrium{}. Prescribe the tilts about y and z (kFS4 = kFS5 = 1), or "
                    "apply the load through the swivel center of the bearing",
                    loads, tilt, state.q(3), state.q(4),
                    barrels ? ", because barrel-shaped rollers in a nearly spherical groove allow "
                              "the race to swivel about its center"
                            : ""));
  }
  if (solve.ran_away) {
    throw SolverError(fmt::format(
        "bearing equilibrium: no roller or flange supports the inner race under {}; the inner race "
        "moved to x = {:.4g} m, y = {:.4g} m, z = {:.4g} m. Prescribe the displacement in the "
        "direction without support (kFS), add flanges, or change the load",
        loads, state.q(0), state.q(1), state.q(2)));
  }
  throw SolverError(
      fmt::format("bearing equilibrium: under {} Newton's iteration {}{}. Enter a first guess of "
                  "the displacement, or prescribe the displacement in one direction",
                  loads, solve_failure_text(solve),
                  solve.element_failed ? ", because a roller lost its equilibrium (no support "
                                         "along the roller axis, or the race moved too far)"
                                       : ""));
}

}  // namespace

RollerSolution solve_roller_statics(const bearing::Bearing& bearing, const RollerOptions& options) {
  RollerModel model = make_roller_model(bearing, options);
  const RaceLoadCase task = race_load_case(bearing.constraints);
  Vec5 given;
  for (std::size_t k = 0; k < 5; ++k) {
    given(static_cast<Eigen::Index>(k)) = bearing.constraints.displacement[k];
  }
  const RaceScales scales = race_scales(model);
  set_load_floors(model, force_scale(scales, task, 0.0));

  const Vec5 start = options.start        ? start_displacement(model, *options.start, task, given)
                     : options.warm_start ? given
                                          : first_guess(model, task, given);
  RollerRace state = rollers_at(model, options.start, start);
  const auto hopeless = [&](const RollerRace& at) { return slides_out(model, task, at.q); };
  RaceSolveResult solve = solve_race_with_fallback(model, task, state, 1e-12, hopeless);
  const Vec5 cold = first_guess(model, task, given_displacements(task, given));
  RollerSolution out;
  const bool guessed = cold != start || options.start;
  if (guessed && (!solve.converged || unstable_at(model, task, state))) {
    RollerRace from_cold = rollers_at(model, nullptr, cold);
    const RaceSolveResult second =
        solve_race_with_fallback(model, task, from_cold, 1e-12, hopeless);
    if (!solve.converged || (second.converged && !unstable_at(model, task, from_cold))) {
      out.notes.push_back(make_finding(
          "statics.first_guess",
          solve.converged ? "the equilibrium found from the first guess of the displacement is not "
                            "stable. The result is an equilibrium that was found without this guess"
                          : "no equilibrium was found from the first guess of the displacement. "
                            "The result is an equilibrium that was found without this guess"));
      state = std::move(from_cold);
      solve = second;
    }
  }
  if (!solve.converged) {
    throw_no_equilibrium(model, task, solve, state);
  }
  if (model.grips) {
    RollerRace centred = state;
    if (centre_gripped(model, centred)) {
      const RaceSolveResult again = solve_race(model, task, centred);
      if (again.converged) {
        const int before = solve.iterations;
        solve = again;
        solve.iterations += before;
        state = std::move(centred);
      } else {
        out.notes.push_back(make_finding(
            "statics.roller_place",
            "rollers without flange load: no equilibrium was found with these rollers in the "
            "middle of the race. Their axial positions are those at the end of the search"));
      }
    }
  }

  for (std::size_t k = 0; k < 5; ++k) {
    out.displacement[k] = state.q(static_cast<Eigen::Index>(k));
    out.load[k] = state.load(static_cast<Eigen::Index>(k));
  }
  out.stiffness = state.stiffness;
  out.iterations = solve.iterations;
  out.residual = solve.residual;
  for (const RollerState& roller : state.elements) {
    out.rollers.push_back(report_roller(model, state.q, roller));
  }
  for (int k = 0; k < model.slicing.count; ++k) {
    out.slice_position.push_back(model.slicing.centre(k));
  }
  out.slice_width = model.slicing.width;
  for (std::size_t j = 0; j < 2; ++j) {
    out.line_constant[j] = options.contact == RollerContact::Point ? model.bodies[0].point[j].K
                                                                   : model.line_constant[j];
  }
  out.orbital_speed = model.speeds.orbital;
  out.spin_speed = model.speeds.spin;
  out.centrifugal_force = model.centrifugal;
  out.guide_force = std::hypot(model.guide[0], model.guide[1]);
  out.unloaded_position_rule = unloaded_position_rule(model);
  out.gyroscopic_moment = model.gyroscopic;
  out.roller_mass = model.mass;
  out.mass_offset = model.mass_offset;
  fill_summary(out);
  bool with_friction = false;
  if (has_friction_balance(bearing, options)) {
    with_friction = solve_roller_friction_balance(bearing, options, model, task, state, out);
  }
  if (options.difference_share > 0.0 && !with_friction) {
    add_difference_stiffness(model, state, options.difference_share, out);
  }
  for (Finding& note : unsupported_direction_notes(solve.held, out.displacement)) {
    out.notes.push_back(std::move(note));
  }
  if (const UnstableMode mode = unstable_at(model, task, state)) {
    out.other_equilibria = adjacent_stable_equilibria(model, task, state, mode);
    out.notes.push_back(instability_note(mode, out.other_equilibria));
  }
  for (Finding& note : roller_notes(model, out.rollers)) {
    out.notes.push_back(std::move(note));
  }
  return out;
}

}  // namespace adore::statics
