#pragma once

#include "base/finding.hpp"
#include "statics/slope_search.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Equilibrium of the inner race on its rolling elements, whatever these are.
///
/// An element set is a type `Set` with these functions in its own namespace:
///   RaceScales race_scales(const Set&);                        constant sizes
///   double reference_stiffness(const Set&, double load);       of one contact under that load
///   [N/m] bool is_conservative(const Set&);                          the race load has a potential
///   double initial_accuracy(const Set&);                         `accuracy` before the first step
///   bool update_race(const Set&, const Vec5& q, RaceState<Element>&, double accuracy = 0);
/// The last one brings every element into equilibrium for race displacement q, sums load and exact
/// stiffness, and returns false when some element has no equilibrium. `accuracy`: out-of-balance
/// force of an element over its loads from which its last Newton step may be taken without being
/// evaluated, in its place and in its share of the load alike; 0: none, down to rounding.
namespace adore::statics {

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

/// What is asked of the inner race.
struct RaceLoadCase {
  std::array<bool, 5> given{};  ///< displacement given (else the load is)
  Vec5 load = Vec5::Zero();     ///< where not given [N, N m]
};

/// The race at one displacement with every element in equilibrium.
template <class Element>
struct RaceState {
  Vec5 q = Vec5::Zero();          ///< displacement [m, rad]
  Vec5 load = Vec5::Zero();       ///< carried by the elements [N, N m]
  Mat5 stiffness = Mat5::Zero();  ///< d load / d q
  std::vector<Element> elements;
  double largest_contact = 0.0;  ///< [N]
};

struct RaceSolveResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;        ///< largest force residual over the force scale
  bool element_failed = false;  ///< some element had no equilibrium on the way
  bool ran_away = false;        ///< the race left the space in which elements could hold it
  std::vector<int> held;  ///< free directions without stiffness and load, left where they were
};

/// Sizes by which a race problem is judged.
struct RaceScales {
  double lever = 1.0;         ///< rotations count as this many metres per radian [m]
  double longest_step = 0.0;  ///< of one Newton step [m]
  double reach = 0.0;         ///< displacement beyond which no element can hold the race [m]
  double size = 0.0;          ///< of the bearing: rounding of positions [m]
  double idle_load = 0.0;     ///< contact load that exists without any load on the race [N]
};

/// The lever of direction k: 1 for the three translations.
[[nodiscard]] inline double lever_of(const RaceScales& scales, Eigen::Index k) {
  return k < 3 ? 1.0 : scales.lever;
}

/// Forces that are missing, moments as forces on the lever; zero where the displacement is given.
[[nodiscard]] Vec5 scaled_residual(const RaceScales& scales, const RaceLoadCase& task,
                                   const Vec5& load);

/// Given directions become decoupled springs of the reference stiffness, which their zero residual
/// never moves.
[[nodiscard]] Mat5 scaled_stiffness(const RaceScales& scales, const RaceLoadCase& task,
                                    const Mat5& stiffness, double k_ref);

struct RaceStep {
  Vec5 direction = Vec5::Zero();
  std::vector<int> held;  ///< directions that dominate unloaded modes without stiffness
};

/// Newton step, or its replacement where the stiffness is singular: unloaded modes stay, loaded
/// ones walk along the load by `longest`. `downhill`: by the modes of the symmetric part, each
/// along its load even where its stiffness is negative, so that the step leads away from an
/// unstable equilibrium.
[[nodiscard]] RaceStep newton_step(const Mat5& K, const Vec5& r, double k_ref, double force,
                                   double longest, bool downhill = false);

/// q + t direction, the direction being in scaled coordinates.
[[nodiscard]] Vec5 moved(const RaceScales& scales, const Vec5& q, const Vec5& direction, double t);

/// Largest component of a displacement, tilts at their lever [m].
[[nodiscard]] double largest_displacement(const RaceScales& scales, const Vec5& q);
[[nodiscard]] bool is_out_of_reach(const RaceScales& scales, const Vec5& q);
/// The same of a first guess: what is given counts as within reach.
[[nodiscard]] bool starts_out_of_reach(const RaceScales& scales, const RaceLoadCase& task,
                                       const Vec5& q);

/// Largest force that the problem speaks of: applied loads (moments over the lever), else contact
/// loads.
[[nodiscard]] double force_scale(const RaceScales& scales, const RaceLoadCase& task,
                                 double largest_contact);

/// The displacement where it is given, 0 elsewhere: no guess.
[[nodiscard]] Vec5 given_displacements(const RaceLoadCase& task, const Vec5& displacement);

/// A mode of negative stiffness: a disturbance along it grows.
struct UnstableMode {
  double stiffness = 0.0;         ///< [N/m], < 0; 0: the free directions are stable
  Vec5 direction = Vec5::Zero();  ///< scaled
  double lever = 1.0;             ///< of its largest component (lever_of)
  [[nodiscard]] explicit operator bool() const { return stiffness < 0.0; }
};
/// The lowest eigenvalue of the symmetric part of the free directions' stiffness, if it lies below
/// -1e-6 of the reference.
[[nodiscard]] UnstableMode unstable_mode(const RaceScales& scales, const RaceLoadCase& task,
                                         const Mat5& stiffness, double k_ref);

/// Finding statics.unstable, with the stable equilibria nearby.
[[nodiscard]] Finding instability_note(const UnstableMode& mode,
                                       const std::vector<std::array<double, 5>>& stable_ones);

enum class RaceSearchOutcome : unsigned char { Accepted, NoProgress, ElementFailed, RanAway };

/// Line search for a convex potential.
template <class Set, class State>
RaceSearchOutcome line_search_convex(const Set& set, const RaceScales& scales,
                                     const RaceLoadCase& task, const State& state, const Vec5& r,
                                     const Vec5& direction, double accuracy, State& trial) {
  SlopeSearch search(direction.dot(r), 1e-15);
  RaceSearchOutcome outcome = RaceSearchOutcome::NoProgress;
  for (int attempt = 0; attempt < 60; ++attempt) {
    const Vec5 q = moved(scales, state.q, direction, search.length());
    if (is_out_of_reach(scales, q)) {
      return RaceSearchOutcome::RanAway;
    }
    trial = state;
    if (!update_race(set, q, trial, accuracy)) {
      outcome = RaceSearchOutcome::ElementFailed;
      search.backtrack();
      continue;
    }
    if (search.accepts(direction.dot(scaled_residual(scales, task, trial.load)))) {
      return RaceSearchOutcome::Accepted;
    }
  }
  return outcome;
}

/// Line search without a potential: halve the step until the residual is smaller.
template <class Set, class State>
RaceSearchOutcome reduce(const Set& set, const RaceScales& scales, const RaceLoadCase& task,
                         const State& state, const Vec5& r, const Vec5& direction, double accuracy,
                         State& trial) {
  RaceSearchOutcome outcome = RaceSearchOutcome::NoProgress;
  double t = 1.0;
  for (int attempt = 0; attempt < 14; ++attempt, t *= 0.5) {
    const Vec5 q = moved(scales, state.q, direction, t);
    if (is_out_of_reach(scales, q)) {
      outcome = RaceSearchOutcome::RanAway;
      continue;
    }
    trial = state;
    if (!update_race(set, q, trial, accuracy)) {
      outcome = RaceSearchOutcome::ElementFailed;
      continue;
    }
    if (scaled_residual(scales, task, trial.load).norm() <= (1.0 - 1e-4 * t) * r.norm()) {
      return RaceSearchOutcome::Accepted;
    }
    outcome = RaceSearchOutcome::NoProgress;
  }
  return outcome;
}

/// Elements need not be better balanced than the race: their accuracy shrinks with its residual.
/// Below this residual Newton's next step may be the last, and they are balanced down to rounding.
inline constexpr double kLastResidual = 1e-6;

/// Newton on the free directions from state.q. Where the race load has a potential (convex for
/// contacts that only push), a line search on the directional derivative converges from anywhere;
/// otherwise steps must reduce the residual. Directions without stiffness are left alone when
/// unloaded and walked along the load, a longest step at a time, until elements touch. `downhill`:
/// steps follow the load along every mode, to a stable equilibrium. `uphill_limit`: steps against
/// the load before it gives up.
template <class Set, class State>
RaceSolveResult solve_race(const Set& set, const RaceLoadCase& task, State& state,
                           double target = 1e-12, bool downhill = false, int uphill_limit = 1000) {
  RaceSolveResult result;
  const bool all_given =
      std::all_of(task.given.begin(), task.given.end(), [](bool given) { return given; });
  double accuracy = all_given ? 0.0 : initial_accuracy(set);
  if (!update_race(set, Vec5(state.q), state, accuracy)) {
    result.element_failed = true;
    return result;
  }
  if (all_given) {
    result.converged = true;
    return result;
  }
  const RaceScales scales = race_scales(set);
  if (starts_out_of_reach(scales, task, state.q)) {
    result.ran_away = true;
    return result;
  }
  const bool conservative = is_conservative(set);
  constexpr int kIterations = 200;  // a race that nothing holds walks out of reach in fewer
  double previous_size = -1.0;
  int uphill = 0;
  // A search that in so many steps neither nears the load nor moves the race by one longest step
  // has come to its end.
  constexpr int kPatience = 20;
  double mark_size = 0.0;
  Vec5 mark_q = Vec5(state.q);
  for (int n = 0; n <= kIterations; ++n) {
    const Vec5 r = scaled_residual(scales, task, state.load);
    const double force = std::max(force_scale(scales, task, state.largest_contact), 1e-300);
    const double floor = std::max(force, state.largest_contact);
    result.iterations = n;
    result.residual = r.cwiseAbs().maxCoeff() / floor;
    const double k_ref = reference_stiffness(set, floor);
    const Mat5 K = scaled_stiffness(scales, task, state.stiffness, k_ref);
    RaceStep step = newton_step(K, r, k_ref, force, scales.longest_step, downhill);
    // What the rounding of positions of the size of the bearing does to the forces.
    const double noise = 2e-16 * scales.size * K.diagonal().cwiseAbs().maxCoeff() / floor;
    const bool small = result.residual <= std::max(target, noise);
    const bool stalled =
        result.residual <= 1e-10 && previous_size >= 0.0 && r.norm() >= 0.25 * previous_size;
    if ((small || stalled) && accuracy > 0.0 && !(target > kLastResidual)) {
      accuracy = 0.0;
      if (!update_race(set, Vec5(state.q), state)) {
        result.element_failed = true;
        return result;
      }
      continue;
    }
    if (small || stalled) {
      result.converged = true;
      result.held = step.held;
      return result;
    }
    if (step.direction.dot(r) < 0.0) {
      ++uphill;
    }
    if (n == kIterations || uphill > uphill_limit || !step.direction.allFinite()) {
      return result;
    }
    if (n % kPatience == 0) {
      const Vec5 way = Vec5(state.q) - mark_q;
      if (n > 0 && r.norm() > 0.99 * mark_size &&
          !(largest_displacement(scales, way) > scales.longest_step)) {
        return result;
      }
      mark_size = r.norm();
      mark_q = state.q;
    }
    previous_size = r.norm();
    const double size = step.direction.cwiseAbs().maxCoeff();
    if (size > scales.longest_step) {
      step.direction *= scales.longest_step / size;
    }

    accuracy = result.residual > kLastResidual
                   ? initial_accuracy(set) * std::min(result.residual, 1.0)
                   : 0.0;
    State trial;
    const RaceSearchOutcome search =
        conservative || downhill
            ? line_search_convex(set, scales, task, state, r, step.direction, accuracy, trial)
            : reduce(set, scales, task, state, r, step.direction, accuracy, trial);
    if (search != RaceSearchOutcome::Accepted) {
      result.ran_away = search == RaceSearchOutcome::RanAway;
      result.element_failed = search == RaceSearchOutcome::ElementFailed;
      if (result.residual <= 1e-9 && update_race(set, Vec5(state.q), state)) {
        result.residual = scaled_residual(scales, task, state.load).cwiseAbs().maxCoeff() / floor;
        result.converged = result.residual <= 1e-9;
      }
      return result;
    }
    state = std::move(trial);
  }
  return result;
}

/// Newton; where it fails (it wanders between unstable equilibria and open contacts), downhill from
/// the same start to a stable equilibrium, and Newton again. A race without load that only idle
/// elements hold off has forces far below their loads: there downhill all the way.
/// @param hopeless of the state at which Newton gave up: there is no equilibrium to look for
template <class Set, class State, class Hopeless>
RaceSolveResult solve_race_with_fallback(const Set& set, const RaceLoadCase& task, State& state,
                                         double target, const Hopeless& hopeless) {
  const State start = state;
  constexpr int kUphill = 12;  // enough for an unstable equilibrium that is near
  RaceSolveResult result = solve_race(set, task, state, target, false, kUphill);
  if (result.converged || result.ran_away || hopeless(state)) {
    return result;
  }
  State down = start;
  const RaceSolveResult descent = solve_race(set, task, down, std::max(target, 1e-4), true);
  if (descent.converged) {
    RaceSolveResult again = solve_race(set, task, down, target);
    if (again.converged) {
      state = std::move(down);
      again.iterations += result.iterations + descent.iterations;
      return again;
    }
  } else if (descent.ran_away) {  // downhill for ever: nothing holds the race
    state = std::move(down);
    return descent;
  }
  if (descent.converged) {
    State all_the_way = start;
    const RaceSolveResult last = solve_race(set, task, all_the_way, target, true);
    if (last.converged) {
      state = std::move(all_the_way);
      return last;
    }
  }
  state = start;
  return solve_race(set, task, state, target);
}

template <class Set, class State>
RaceSolveResult solve_race_with_fallback(const Set& set, const RaceLoadCase& task, State& state,
                                         double target = 1e-12) {
  return solve_race_with_fallback(set, task, state, target, [](const State&) { return false; });
}

/// Looks for stable equilibria on both sides of an unstable one: a step along the mode, downhill
/// from there, then Newton. Both sides are often mirror images.
template <class Set, class State>
std::vector<std::array<double, 5>> adjacent_stable_equilibria(const Set& set,
                                                              const RaceLoadCase& task,
                                                              const State& state,
                                                              const UnstableMode& mode) {
  std::vector<std::array<double, 5>> found;
  const RaceScales scales = race_scales(set);
  const auto far = [&](const Vec5& a, const Vec5& b) {
    const Vec5 d = a - b;
    return d.head<3>().norm() + scales.lever * d.tail<2>().norm() > 1e-4 * scales.longest_step;
  };
  for (const double side : {1.0, -1.0}) {
    State trial = state;
    const Vec5 start = moved(scales, state.q, mode.direction, 0.25 * side * scales.longest_step);
    if (!update_race(set, start, trial)) {
      continue;
    }
    if (!solve_race(set, task, trial, 1e-4, true).converged ||
        !solve_race(set, task, trial).converged || !far(trial.q, state.q)) {
      continue;
    }
    const double k_ref = reference_stiffness(set, std::max(trial.largest_contact, 1e-300));
    if (!unstable_mode(scales, task, trial.stiffness, k_ref)) {
      found.push_back({trial.q(0), trial.q(1), trial.q(2), trial.q(3), trial.q(4)});
    }
  }
  return found;
}

}  // namespace adore::statics
