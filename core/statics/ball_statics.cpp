#include "statics/ball_statics.hpp"

#include "base/errors.hpp"
#include "statics/ball_race.hpp"
#include "statics/ball_report.hpp"
#include "statics/ball_springs.hpp"
#include "statics/least_heat.hpp"
#include "statics/race_text.hpp"
#include "statics/stiffness_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::statics {
namespace {

std::array<double, 5> to_array(const Vec5& v) { return {v(0), v(1), v(2), v(3), v(4)}; }

double steepest_contact_angle(const BallModel& m, const BallRace& state) {
  const auto pose = inner_race_pose<double>(m, to_array(state.q));
  double steepest = 0.0;
  for (const BallState& ball : state.elements) {
    for (const auto& c : ball_forces<double>(m, ball.site, ball.x, ball.rho, pose).contact) {
      if (!ball.idle && c.load > 0.0) {
        steepest = std::max(steepest, std::abs(std::atan2(c.alpha.sin, c.alpha.cos)));
      }
    }
  }
  return steepest;
}

/// Why the last attempt failed, as precisely as can be told, and what would help.
[[noreturn]] void throw_no_equilibrium(const BallModel& m, const RaceLoadCase& task,
                                       const RaceSolveResult& solve, const BallRace& state,
                                       double share) {
  const std::string loads = load_text(task);
  const double steepest = steepest_contact_angle(m, state);
  std::string angles;
  if (steepest > 0.5 * std::numbers::pi) {
    angles = fmt::format(
        ". Contact angles reach {:.0f} degrees: these loads push the balls out of any groove",
        steepest * 180.0 / std::numbers::pi);
  }
  if (solve.ran_away) {
    throw SolverError(fmt::format(
        "bearing equilibrium: no ball supports the inner race under {}; the inner race moved to x "
        "= {:.4g} m, y = {:.4g} m, z = {:.4g} m, which is outside the grooves{}. Prescribe the "
        "displacement in the direction without support (kFS), or change load or geometry",
        loads, state.q(0), state.q(1), state.q(2), angles));
  }
  const double force = force_scale(race_scales(m), task, state.largest_contact);
  const double deflection =
      std::cbrt(force * force) * std::pow(m.hertz[1].reference().K, -2.0 / 3.0);
  if (deflection < 1e-11 * m.balls.pitch_diameter) {
    throw SolverError(
        fmt::format("bearing equilibrium: {} deflects a contact by only {:.2g} m, which is too "
                    "small to be computed at a pitch diameter of {:.4g} m. Set this load to zero",
                    loads, deflection, m.balls.pitch_diameter));
  }
  if (share >= 0.0) {
    throw SolverError(fmt::format(
        "bearing equilibrium: no equilibrium of the balls was found under {} at race speeds of "
        "{:.6g} and {:.6g} rad/s{}. The effects of speed (orbital speeds, gyroscopic moments, "
        "angle-dependent stiffness) were increased in steps; a solution was found up to {:.0f} % "
        "of "
        "them, but not at 100 % (force residual {:.2g} times the load). Increase the load, reduce "
        "the speed, or choose another spin rule (kAngVel)",
        loads, m.race_speed[0], m.race_speed[1], angles, 100.0 * share, solve.residual));
  }
  throw SolverError(
      fmt::format("bearing equilibrium: under {} Newton's iteration {}{}{}. Enter a first guess of "
                  "the displacement, or prescribe the displacement in one direction",
                  loads, solve_failure_text(solve),
                  solve.element_failed ? ", because a ball lost its equilibrium" : "", angles));
}

/// Result of solve_in_stages. `reached` is the fraction of the full problem for which an
/// equilibrium was found, negative when there was none for the conservative one.
struct Staged {
  RaceSolveResult solve;
  double reached = -1.0;
};

/// From the conservative problem, whose solution exists and is unique, to the full one: directly,
/// else in fractions of what differs (ω_m and M_g of each ball, K over the contact angle). `cold`:
/// the conservative problem comes first.
Staged solve_in_stages(BallModel& m, const RaceLoadCase& task, BallRace& state, bool cold) {
  constexpr double kMinStageStep = 1.0 / 32.0;
  const bool plain = !m.per_ball_speeds && !m.hertz[0].varying();
  Staged result;
  if (cold && !plain) {
    m.own_speed_share = 0.0;
    result.solve = solve_race_with_fallback(m, task, state, 0.03);
    if (!result.solve.converged) {
      return result;
    }
  }
  result.reached = plain ? -1.0 : 0.0;
  double step = 1.0;
  while (result.reached < 1.0) {
    m.own_speed_share = plain ? 1.0 : std::min(1.0, result.reached + step);
    BallRace trial = state;
    const int before = result.solve.iterations;
    // Between split races a ball that changes its halves makes a kink in the load.
    result.solve =
        plain || m.split ? solve_race_with_fallback(m, task, trial) : solve_race(m, task, trial);
    result.solve.iterations += before;
    if (result.solve.converged) {
      result.reached = m.own_speed_share;
      state = std::move(trial);
      step *= 2.0;
    } else {
      step *= step == 1.0 ? 0.25 : 0.5;
      if (plain || step < kMinStageStep) {
        m.own_speed_share = std::max(0.0, result.reached);
        break;
      }
    }
  }
  return result;
}

/// "ball 3", "balls 3, 4"
std::string ball_numbers(const std::vector<std::size_t>& indices) {
  std::string text;
  for (std::size_t k : indices) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", k + 1);
  }
  return (indices.size() == 1 ? "ball " : "balls ") + text;
}

/// Race control rule: every ball is controlled by the race with the larger Q a E, the outer one
/// reduced by cos(α_i - α_o). The choice changes the forces, so it is repeated until it stands. A
/// ball that wants to go back to the outer race stays there; where inner control has no
/// equilibrium, outer control is kept. Both are noted.
void solve_race_control(BallModel& m, const RaceLoadCase& task, BallRace& state,
                        RaceSolveResult& solve, std::vector<Finding>& notes) {
  std::vector<int> changes(state.elements.size(), 0);
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<std::size_t> changed;
    const BallRace before = state;
    const auto q = to_array(state.q);
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
      BallState& ball = state.elements[k];
      const double ratio = report_ball(m, q, ball).race_control_ratio;
      const auto wanted = ratio < 1.0 ? SpinLaw::Axis::InnerControl : SpinLaw::Axis::OuterControl;
      if (!std::isfinite(ratio) || wanted == ball.site.law.axis || changes[k] >= 2) {
        continue;
      }
      ball.site.law.axis = wanted;
      ball.site.law.share =
          wanted == SpinLaw::Axis::OuterControl ? SpinLaw::Share::Outer : SpinLaw::Share::Equal;
      ++changes[k];
      changed.push_back(k);
    }
    if (changed.empty()) {
      break;
    }
    const int iterations = solve.iterations;
    Staged staged = solve_in_stages(m, task, state, false);
    if (staged.reached < 1.0) {
      m.own_speed_share = 1.0;
      state = before;
      notes.push_back(
          make_finding("statics.race_control",
                       fmt::format("race control: the inner race would control the spin of {}, but "
                                   "the bearing has no equilibrium with inner race control; outer "
                                   "race control is used",
                                   ball_numbers(changed)))
              .of(ball_numbers(changed)));
      return;
    }
    solve = staged.solve;
    solve.iterations += iterations;
  }
  std::vector<std::size_t> undecided;
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (changes[k] == 2) {
      undecided.push_back(k);
    }
  }
  if (!undecided.empty()) {
    notes.push_back(
        make_finding("statics.race_control",
                     fmt::format("race control: either race may control the spin of {}; outer race "
                                 "control is used",
                                 ball_numbers(undecided)))
            .of(ball_numbers(undecided)));
  }
}

void check_rolling(const BallModel& m, const BallRace& state) {
  const auto q = to_array(state.q);
  for (std::size_t k = 0; k < state.elements.size(); ++k) {
    const BallState& ball = state.elements[k];
    if (!ball_forces<double>(m, ball.site, ball.x, ball.rho, inner_race_pose<double>(m, q)).rolls) {
      throw SolverError(
          fmt::format("bearing equilibrium: with the spin axis prescribed at {:.6g} degrees from "
                      "the bearing axis (angVelOrient minus multiples of 180 degrees), ball {} "
                      "cannot roll on both races. Prescribe an angle near the contact angle",
                      m.spin_angle * 180.0 / std::numbers::pi, k + 1));
    }
  }
}

/// All balls unsolved, the race at q.
BallRace balls_at(const BallModel& model, const SpinLaw& law, const Vec5& q) {
  BallRace state;
  state.q = q;
  for (std::size_t k = 0; k < model.azimuth.size(); ++k) {
    BallState ball;
    ball.site.sin = std::sin(model.azimuth[k]);
    ball.site.cos = std::cos(model.azimuth[k]);
    ball.site.own = model.own_number.empty() ? 0 : model.own_number[k];
    ball.site.law = law;
    state.elements.push_back(ball);
  }
  return state;
}

/// Where the race is before its balls are asked.
enum class ColdStart : unsigned char { Springs, PlainGuess };

Vec5 cold_start(const BallModel& model, const RaceLoadCase& task, const Vec5& given,
                ColdStart start) {
  const Vec5 plain = first_guess(model, task, given);
  return start == ColdStart::Springs ? guess_by_springs(model, task, plain) : plain;
}

StaticSolution solve_from(ColdStart start, const bearing::Bearing& bearing,
                          const BallStaticsOptions& options) {
  BallModel model = make_ball_model(bearing, options);
  const RaceLoadCase task = race_load_case(bearing.constraints);
  Vec5 given;
  for (Eigen::Index k = 0; k < 5; ++k) {
    given(k) = bearing.constraints.displacement[static_cast<std::size_t>(k)];
  }
  const SpinLaw law = first_spin_law(bearing, options);
  BallRace state =
      balls_at(model, law, options.warm_start ? given : cold_start(model, task, given, start));

  StaticSolution solution;
  Staged staged = solve_in_stages(model, task, state, true);
  const Vec5 has_no_guess = given_displacements(task, given);
  if (staged.reached < 1.0 && (options.warm_start || has_no_guess != given)) {
    state = balls_at(model, law, cold_start(model, task, has_no_guess, start));
    staged = solve_in_stages(model, task, state, true);
    solution.notes.push_back(
        make_finding("statics.first_guess",
                     "no equilibrium was found from the first guess of the displacement. The "
                     "result is an equilibrium that was found without this guess"));
  }
  if (staged.reached < 1.0) {
    throw_no_equilibrium(model, task, staged.solve, state, staged.reached);
  }
  RaceSolveResult& solve = staged.solve;
  const bool race_control = options.control == Control::FromBearing &&
                            bearing.spin_rule == bearing::SpinRule::RaceControl;
  if (race_control && model.per_ball_speeds) {
    solve_race_control(model, task, state, solve, solution.notes);
  }
  if (law.axis == SpinLaw::Axis::LeastHeat) {
    solve_least_heat(bearing, model, task, state, solve, solution.notes);
  }
  check_rolling(model, state);
  solution.displacement = to_array(state.q);
  solution.load = to_array(state.load);
  solution.stiffness = state.stiffness;
  solution.iterations = solve.iterations;
  solution.residual = solve.residual;
  for (std::size_t k = 0; k < state.elements.size(); ++k) {
    solution.balls.push_back(report_ball(model, solution.displacement, state.elements[k]));
    solution.balls.back().azimuth = model.azimuth[k];
  }
  for (Finding& note : unsupported_direction_notes(solve.held, solution.displacement)) {
    solution.notes.push_back(std::move(note));
  }
  const double k_ref = reference_stiffness(model, std::max(state.largest_contact, 1e-300));
  if (const UnstableMode mode = unstable_mode(race_scales(model), task, state.stiffness, k_ref)) {
    solution.other_equilibria = adjacent_stable_equilibria(model, task, state, mode);
    solution.notes.push_back(instability_note(mode, solution.other_equilibria));
  }
  for (Finding& note : ball_notes(model, solution.balls)) {
    solution.notes.push_back(std::move(note));
  }
  fill_summary(model, solution);
  if (options.difference_share > 0.0) {
    add_difference_stiffness(model, state, options.difference_share, solution);
  }
  return solution;
}

}  // namespace

StaticSolution solve_ball_statics(const bearing::Bearing& bearing,
                                  const BallStaticsOptions& options) {
  try {
    return solve_from(ColdStart::Springs, bearing, options);
  } catch (const SolverError&) {
    if (options.warm_start) throw;
  }
  // Springs hold the race where balls at speed may have left it: from the plain guess, then.
  return solve_from(ColdStart::PlainGuess, bearing, options);
}

}  // namespace adore::statics
