#include "ball_bearings.hpp"
#include "base/errors.hpp"
#include "statics/ball_statics.hpp"
#include "statics/stiffness_difference.hpp"
#include "statics/stiffness_table.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace adore;
using namespace ball_bearings;

namespace {

constexpr double kRpm = std::numbers::pi / 30.0;

bearing::Bearing loaded_218(double rpm) {
  bearing::Bearing b = angular_contact_218(rpm);
  load(b, 17800, 500, 8900);
  return b;
}

double disagreement(double share) {
  statics::BallStaticsOptions options;
  options.difference_share = share;
  const auto solution = statics::solve_ball_statics(loaded_218(6000.0), options);
  REQUIRE(solution.stiffness_by_difference);
  CHECK(solution.difference_step == Approx(share * solution.max_deflection).epsilon(1e-14));
  return statics::stiffness_disagreement(solution.stiffness, *solution.stiffness_by_difference);
}

}  // namespace

TEST_CASE("stiffness by differences tends to the linearisation with the square of the step",
          "[physics]") {
  const double coarse = disagreement(0.08), fine = disagreement(0.02);
  CHECK(coarse < 1e-2);
  // Second order: 16 for a quarter of the step, as long as rounding stays below.
  CHECK(coarse / fine == Approx(16.0).epsilon(0.2));
}

TEST_CASE("stiffness differences are left out where no contact is loaded", "[unit]") {
  statics::BallStaticsOptions options;
  options.difference_share = 0.01;
  const auto solution = statics::solve_ball_statics(deep_groove(20e-6), options);
  CHECK_FALSE(solution.stiffness_by_difference);
}

TEST_CASE("every row of a stiffness table is the solution at its own speeds", "[physics]") {
  statics::StiffnessRequest request{5, 0.01, {0.0, 0.0}, {-1000.0 * kRpm, 12000.0 * kRpm}};
  bearing::Bearing b = loaded_218(0.0);
  const auto rows = statics::stiffness_table(
      request, [&](const std::array<double, 2>& speed, const statics::RaceResult* previous) {
        b.speed = speed;
        statics::BallStaticsOptions options;
        options.difference_share = request.share;
        b.constraints.displacement = {};
        options.warm_start = previous != nullptr;
        if (previous != nullptr) b.constraints.displacement = previous->displacement;
        return static_cast<statics::RaceResult>(statics::solve_ball_statics(b, options));
      });
  REQUIRE(rows.size() == 5);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    INFO("row " << k);
    CHECK(rows[k].failure.empty());
    CHECK(rows[k].speed[1] == Approx(3000.0 * kRpm * static_cast<double>(k)));
    bearing::Bearing cold = loaded_218(0.0);
    cold.speed = rows[k].speed;
    const auto alone = statics::solve_ball_statics(cold);
    // Warm and cold starts stop at a residual of 1e-12 of the load each.
    const double scale = alone.stiffness.cwiseAbs().maxCoeff();
    CHECK((rows[k].result.stiffness - alone.stiffness).cwiseAbs().maxCoeff() < 1e-8 * scale);
    REQUIRE(rows[k].result.stiffness_by_difference);
    CHECK(statics::stiffness_disagreement(rows[k].result.stiffness,
                                          *rows[k].result.stiffness_by_difference) < 1e-3);
  }
  // Centrifugal force opens the inner contacts of a bearing whose loads are given: softer axially.
  CHECK(rows[4].result.stiffness(0, 0) < rows[0].result.stiffness(0, 0));
}

TEST_CASE("a speed without equilibrium keeps its reason and the others their rows", "[unit]") {
  int cold_tries = 0;
  const auto rows = statics::stiffness_table(
      {3, 0.0, {0.0, 0.0}, {0.0, 200.0}},
      [&](const std::array<double, 2>& speed, const statics::RaceResult* previous) {
        if (speed[1] == 100.0) {
          if (previous == nullptr) ++cold_tries;
          throw SolverError("no equilibrium here");
        }
        if (speed[1] == 200.0) CHECK(previous == nullptr);
        return statics::RaceResult{};
      });
  REQUIRE(rows.size() == 3);
  CHECK(cold_tries == 1);
  CHECK(rows[0].failure.empty());
  CHECK(rows[1].failure == "no equilibrium here");
  CHECK(rows[2].failure.empty());
}
