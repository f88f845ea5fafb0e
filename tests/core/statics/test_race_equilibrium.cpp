#include "statics/race_equilibrium.hpp"
#include "statics/race_text.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore::statics;

namespace {

/// A race that wavy contacts hold off: within `play` along y their leaning gives it a small load of
/// negative stiffness, beyond it elements push back like line contacts. Beside that elements carry
/// loads of their own.
struct LeaningRace {
  double lean = 5.6e-4;       ///< load at y = 0 [N]
  double softening = -217.0;  ///< its stiffness [N/m]
  double play = 2.1e-6;       ///< [m]
  double own_load = 24.0;     ///< of elements [N]
};
struct NoElement {};
using State = RaceState<NoElement>;

RaceScales race_scales(const LeaningRace&) { return {0.03, 5e-6, 5e-3, 0.06, 24.0}; }
double reference_stiffness(const LeaningRace&, double) { return 1e8; }
bool is_conservative(const LeaningRace&) { return true; }
double initial_accuracy(const LeaningRace&) { return 0.0; }
bool update_race(const LeaningRace& race, const Vec5& q, State& state, double = 0.0) {
  const double over = std::abs(q(1)) - race.play, side = q(1) < 0.0 ? -1.0 : 1.0;
  state.q = q;
  state.load.setZero();
  state.stiffness.setZero();
  state.load(1) = race.lean + race.softening * q(1);
  state.stiffness(1, 1) = race.softening;
  if (over > 0.0) {
    const double push = 1e8 * std::pow(over, 10.0 / 9.0);
    state.load(1) += side * push;
    state.stiffness(1, 1) += 10.0 / 9.0 * push / over;
  }
  state.largest_contact = race.own_load;
  return true;
}

}  // namespace

TEST_CASE(
    "a race without load, held off by forces far below those of its elements, finds its "
    "stable place",
    "[unit][statics]") {
  RaceLoadCase task;
  task.given = {true, false, true, true, true};
  for (const double start : {0.0, 1e-6, -1e-6, 4e-6}) {
    const LeaningRace race;
    State state;
    state.q(1) = start;
    const RaceSolveResult solve = solve_race_with_fallback(race, task, state);
    INFO("from " << start << " after " << solve.iterations << " steps: " << state.q(1));
    REQUIRE(solve.converged);
    CHECK(std::abs(state.load(1)) < 1e-9 * race.own_load);
    CHECK(state.stiffness(1, 1) > 0.0);
    CHECK(state.q(1) == Approx(-race.play).epsilon(0.05));
  }
}

TEST_CASE("an iteration that could not begin tells no residual", "[unit][statics]") {
  RaceSolveResult solve;
  solve.residual = 0.0;  // of no step
  CHECK(solve_failure_text(solve) == "could not start");
  solve.iterations = 7;
  solve.residual = 0.123;
  CHECK(solve_failure_text(solve) ==
        "stopped with a force residual of 0.12 times the load after 7 steps");
}
