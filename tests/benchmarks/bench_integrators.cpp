#include "integrators/stepper.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Cost per accepted step of each method itself: 125 uncoupled, weakly nonlinear oscillators (250
// components), whose right-hand side is as good as free. "evaluations" is per step, so that the
// price of a model can be added.
namespace {

using namespace adore::integrators;

class Oscillators final : public OdeSystem {
 public:
  [[nodiscard]] int size() const noexcept override { return 2 * kCount; }
  [[nodiscard]] int controlled_size() const noexcept override { return 2 * kCount; }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  EvalStatus rhs(double, const double* y, double* f) noexcept override {
    for (int i = 0; i < kCount; ++i) {
      f[i] = y[kCount + i];
      f[kCount + i] = -y[i] * (1.0 + 0.1 * y[i] * y[i]);
    }
    return EvalStatus::Ok;
  }
  [[nodiscard]] bool has_stiff_part() const noexcept override { return true; }
  EvalStatus rhs_stiff(double, const double* y, double* f) noexcept override {
    for (int i = 0; i < kCount; ++i) {
      f[i] = 0.0;
      f[kCount + i] = -y[i];
    }
    return EvalStatus::Ok;
  }

 private:
  static constexpr int kCount = 125;
  std::vector<double> scales_ = std::vector<double>(2 * kCount, 1.0);
};

void step(benchmark::State& bench, const std::string& name) {
  Oscillators system;
  std::vector<double> y0(static_cast<std::size_t>(system.size()));
  for (std::size_t i = 0; i < y0.size(); ++i) y0[i] = std::sin(0.1 * static_cast<double>(i));
  const auto stepper = make_stepper(name);
  stepper->start(system, 0.0, y0, {.maximum = 1.0, .tolerance = 1e-6});
  for (int i = 0; i < 50; ++i) stepper->step(std::numeric_limits<double>::max());
  const Counters before = stepper->counters();
  for (auto _ : bench) benchmark::DoNotOptimize(stepper->step(std::numeric_limits<double>::max()));
  const Counters after = stepper->counters();
  bench.counters["evaluations"] = static_cast<double>(after.evaluations - before.evaluations) /
                                  static_cast<double>(after.steps - before.steps);
}

const bool registered = [] {
  for (const auto name : stepper_names()) {
    benchmark::RegisterBenchmark(std::string(name).c_str(), step, std::string(name));
  }
  return true;
}();

}  // namespace
