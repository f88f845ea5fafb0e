#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/measured_run.hpp"
#include "runs/missed_tolerance.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
/// Steps at stpMin above the tolerance: when they still make a result.
using namespace adore;
using runs::RunStatus;

namespace {

runs::MissedTolerance judged(double tolerance, double mean, long missed = 50) {
  setup::RunControl control;
  control.tolerance = tolerance;
  control.step_minimum = 0.1;
  control.step_maximum = 1.0;
  integrators::Counters counters;
  counters.steps = 100;
  counters.at_minimum = missed;
  return runs::judge_missed_tolerance(control, counters, 100.0 * mean);
}

runs::RunOutcome run_ball(const std::string& method, double tolerance,
                          std::vector<std::pair<std::string, std::string>> sets) {
  runs::RunRequest request;
  request.text = deck::write_deck(deck::new_deck("ball"));
  request.sets = std::move(sets);
  request.until = "0.3rev";
  request.integrator = method;
  request.tolerance = tolerance;
  return runs::measured_run(request, 120.0, {}).outcome;
}

bool warned(const runs::RunOutcome& outcome, const std::string& of) {
  return std::any_of(outcome.warnings.begin(), outcome.warnings.end(), [&](const Issue& issue) {
    return issue.severity == Severity::Warning && issue.message.find(of) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("missed tolerance: judged by the mean error of the steps", "[unit][runs]") {
  CHECK(judged(1e-6, 1e3, 0).text.empty());
  CHECK(judged(1e-6, 0.1).trusted);
  CHECK_THAT(judged(1e-6, 0.1).text, Catch::Contains("50 of 100 steps (50 %)"));
  CHECK_THAT(judged(1e-6, 0.1).text, !Catch::Contains("are about as accurate as"));
  // As a run at ten times the tolerance; at a hundred times; at more than 1e-4.
  CHECK(judged(1e-6, 10.0).trusted);
  CHECK_THAT(judged(1e-6, 10.0).text, Catch::Contains("are about as accurate as with tol = 1e-05"));
  CHECK(judged(1e-6, 99.0).trusted);
  CHECK_FALSE(judged(1e-6, 101.0).trusted);
  CHECK_THAT(judged(1e-6, 101.0).text, Catch::Contains("cannot be trusted. Decrease stpMin"));
  // A tolerance that asked for much more than it needs, and one that asked for little.
  CHECK(judged(1e-9, 9e4).trusted);
  CHECK_FALSE(judged(1e-9, 1.1e5).trusted);
  CHECK(judged(1e-4, 9.0).trusted);
  CHECK_FALSE(judged(1e-4, 11.0).trusted);
}

TEST_CASE("missed tolerance: far above → run not done, slightly above → done", "[physics][runs]") {
  // Steps of 5 time scales: cvode-bdf misses with all of them, and its energy closes to 1e-3.
  const runs::RunOutcome far = run_ball("cvode-bdf", 1e-6, {{"stpMin", "5"}, {"stpMax", "50"}});
  CHECK(far.status == RunStatus::Untrusted);
  CHECK_THAT(far.message, Catch::Contains("missed the tolerance of 1e-06"));
  // More accuracy than steps of 0.4 can give; they are right.
  const runs::RunOutcome near = run_ball("rkf5", 1e-9, {{"stpMin", "0.4"}, {"stpMax", "0.5"}});
  CHECK(near.status == RunStatus::Done);
  CHECK(warned(near, "missed the tolerance of 1e-09"));
}

TEST_CASE("loose tolerance → warning", "[unit][runs]") {
  CHECK(warned(run_ball("rkf5", 1e-3, {}), "is loose"));
  CHECK_FALSE(warned(run_ball("rkf5", 1e-4, {}), "is loose"));
}

TEST_CASE("variable-order method whose steps must be shorter than stpMin → room to vary them",
          "[physics][runs]") {
  for (const char* method : {"cvode-adams", "cvode-bdf"}) {
    const runs::RunOutcome out = run_ball(method, 1e-6, {{"stpMin", "0.9"}, {"stpMax", "50"}});
    CAPTURE(method, out.message);
    CHECK((out.status == RunStatus::Done || out.status == RunStatus::Untrusted));
  }
}
