#include "core/integrators/problems.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

/// Steps judged by what the exact solution keeps (OdeSystem::kept).
using namespace adore::integrators;
using namespace adore::test;

namespace {

/// A problem with a quantity that its exact solution keeps, or that a test says it keeps.
class Watched final : public OdeSystem {
 public:
  Watched(Problem& problem, double scale, std::function<double(double, const double*)> quantity)
      : problem_(problem), scale_(scale), quantity_(std::move(quantity)) {}
  [[nodiscard]] int size() const noexcept override { return problem_.size(); }
  [[nodiscard]] int controlled_size() const noexcept override { return problem_.controlled_size(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override {
    return problem_.scales();
  }
  EvalStatus rhs(double t, const double* y, double* f) noexcept override {
    last_ = quantity_(t, y);
    return problem_.rhs(t, y, f);
  }
  [[nodiscard]] Kept kept() noexcept override { return {last_, scale_, 1e-14}; }

 private:
  Problem& problem_;
  double scale_, last_ = 0.0;
  std::function<double(double, const double*)> quantity_;
};

/// Of a mass that falls on a Hertz spring (bouncing_mass), 1 J at the start.
double energy(double, const double* y) {
  const double d = std::max(0.0, -y[0]);
  return 0.5 * y[1] * y[1] + y[0] + 0.4 * 1e4 * d * d * std::sqrt(d);
}

struct Run {
  Counters counters;
  double lost = 0.0;  ///< [J]
};

constexpr StepControl kControl{.maximum = 0.1, .tolerance = 1e-5};
const std::vector<double> kStart{1.0, 0.0, 0.0};
constexpr double kEnd = 28.0;  // ten blows

Run fall(std::string_view method, double scale) {
  Problem problem = bouncing_mass();
  Watched watched(problem, scale, energy);
  const auto stepper = make_stepper(method);
  stepper->start(watched, 0.0, kStart, kControl);
  run_to(*stepper, kEnd);
  return {stepper->counters(), std::abs(energy(0.0, stepper->state().data()) - 1.0)};
}

}  // namespace

TEST_CASE("conserved quantities: loss per step at most that of the tolerance",
          "[physics][integrators]") {
  for (const auto name : stepper_names()) {
    if (!name.starts_with("rk") && !name.starts_with("pece")) continue;
    const Run without = fall(name, 0.0), with = fall(name, 0.05);
    INFO(name << ": " << without.lost << " J lost in " << without.counters.evaluations
              << " evaluations, watched " << with.lost << " in " << with.counters.evaluations);
    CHECK(with.lost <= static_cast<double>(with.counters.steps) * kControl.tolerance * 0.05);
    CHECK(with.counters.evaluations < 8 * without.counters.evaluations);
    CHECK(without.counters.repeated_for_energy == 0);
    CHECK(with.counters.repeated_for_energy > 0);
    CHECK(with.counters.repeated_for_energy <= with.counters.rejected);
  }
}

TEST_CASE("conserved quantities: loss independent of the step length → run continues",
          "[unit][integrators]") {
  Problem problem = kepler();
  for (const auto name : stepper_names()) {
    if (!name.starts_with("rk") && !name.starts_with("pece")) continue;
    long evaluations[2];
    for (const double scale : {0.0, 1e-3}) {
      Watched watched(problem, scale, [](double t, const double*) { return t; });
      const auto stepper = make_stepper(name);
      stepper->start(watched, 0.0, kepler_exact(0.0), {.maximum = 0.1, .tolerance = 1e-6});
      run_to(*stepper, 6.0);
      evaluations[scale > 0.0] = stepper->counters().evaluations;
    }
    INFO(name << ": " << evaluations[0] << " evaluations, " << evaluations[1]);
    CHECK(evaluations[1] < 2 * evaluations[0]);
  }
}

TEST_CASE("conserved quantities: steps at their limit with small loss → unchanged",
          "[unit][integrators]") {
  Problem problem = kepler();
  const auto binding = [](double, const double* y) {
    return 0.5 * (y[2] * y[2] + y[3] * y[3]) - 1.0 / std::hypot(y[0], y[1]);
  };
  for (const auto name : {"rkf5", "rkf7", "rk4", "pece6"}) {
    std::vector<double> ends[2];
    for (const double scale : {0.0, 1.0}) {
      Watched watched(problem, scale, binding);
      const auto stepper = make_stepper(name);
      stepper->start(watched, 0.0, kepler_exact(0.0), {.maximum = 0.01, .tolerance = 1e-6});
      run_to(*stepper, 6.0);
      ends[scale > 0.0].assign(stepper->state().begin(), stepper->state().end());
    }
    INFO(name);
    CHECK(ends[0] == ends[1]);
  }
}

TEST_CASE("conserved quantities: checked run → continues to the same bits", "[unit][integrators]") {
  for (const auto name : stepper_names()) {
    if (!name.starts_with("rk") && !name.starts_with("pece")) continue;
    Problem problem = bouncing_mass();
    Watched watched(problem, 0.05, energy), again(problem, 0.05, energy);
    const auto whole = make_stepper(name), part = make_stepper(name);
    whole->start(watched, 0.0, kStart, kControl);
    while (whole->time() < 1.42) whole->step(kEnd);  // inside the first blow
    const std::vector<double> y(whole->state().begin(), whole->state().end());
    part->resume(again, whole->time(), y, kControl, whole->memory());
    run_to(*whole, 6.0);
    run_to(*part, 6.0);
    INFO(name);
    CHECK(std::equal(whole->state().begin(), whole->state().end(), part->state().begin()));
    CHECK(whole->counters().rejected > 0);
  }
}

TEST_CASE("conserved quantities: run of an older version → account opened at the continuation",
          "[unit][integrators]") {
  Problem problem = bouncing_mass();
  Watched unwatched(problem, 0.0, energy), watched(problem, 0.05, energy);
  const auto before = make_stepper("rkf5"), after = make_stepper("rkf5");
  before->start(unwatched, 0.0, kStart, kControl);
  while (before->time() < 1.0) before->step(kEnd);  // falling still
  Memory memory = before->memory();
  CHECK(memory.erase("kept") == 1);
  CHECK(memory.erase("steps watched in vain") == 1);
  const std::vector<double> y(before->state().begin(), before->state().end());
  after->resume(watched, before->time(), y, kControl, memory);
  run_to(*after, kEnd);
  const double lost = std::abs(energy(0.0, after->state().data()) - 1.0);
  CHECK(lost < 0.1 * fall("rkf5", 0.0).lost);
}
