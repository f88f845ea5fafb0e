#include "../core/dynamics/system_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Cost of a general solver with default settings (CVODE's BDF, Newton with a dense Jacobian by
/// differences, no longest step) for the same error as the settings of the program: 18 balls with
/// cage, part of a revolution. Errors are those of the work and heat of races, pockets and lands
/// over the span, in percent of all heat, and of the travel of the balls. The Jacobian is dense for
/// a system without a known structure. The cheapest row of either side below each limit gives the
/// ratio. equal_error [TURNS]
namespace {

using namespace adore;
using namespace adore::integrators;

/// The same right-hand side, and nothing known of it.
class Plain final : public OdeSystem {
 public:
  explicit Plain(dynamics::System& system) : system_(system) {}
  [[nodiscard]] int size() const noexcept override { return system_.size(); }
  [[nodiscard]] int controlled_size() const noexcept override { return system_.controlled_size(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override {
    return system_.scales();
  }
  EvalStatus rhs(double t, const double* y, double* dydt) noexcept override {
    return system_.rhs(t, y, dydt);
  }
  bool project(double t, double* y) noexcept override { return system_.project(t, y); }

 private:
  fixture::Adapter system_;
};

struct Outcome {
  double seconds = 0.0;
  Counters counters;
  std::vector<double> y;
};

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Outcome run(dynamics::System& system, const char* method, double tolerance, double longest,
            bool dense, double end) {
  fixture::Adapter own(system);
  Plain plain(system);
  OdeSystem& ode = dense ? static_cast<OdeSystem&>(plain) : own;
  const std::vector<double> y0 = system.initial_state();
  system.set_start(0.0, y0);
  StepControl control;
  control.maximum = std::min(longest, end);
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  const auto stepper = make_stepper(method);
  const double before = processor_seconds();
  stepper->start(ode, 0.0, y0, control);
  while (stepper->time() < end) stepper->step(end);
  const auto state = stepper->state();
  return {processor_seconds() - before, stepper->counters(), {state.begin(), state.end()}};
}

/// In percent.
double error(const dynamics::System& system, const std::vector<double>& found,
             const std::vector<double>& right) {
  const auto controlled = static_cast<std::size_t>(system.layout().controlled_size());
  double moved = 0.0, off = 0.0;
  for (std::size_t i = controlled; i < right.size(); ++i) {
    moved = std::max(moved, std::abs(right[i]));
    off = std::max(off, std::abs(found[i] - right[i]));
  }
  double advance = 0.0, apart = 0.0;
  for (std::size_t i = 36; i < 54; ++i) {  // azimuths
    advance = std::max(advance, std::abs(right[i] - right[36]) + 1.0);
    apart = std::max(apart, std::abs(found[i] - right[i]));
  }
  return 100.0 * std::max(off / moved, apart / advance);
}

}  // namespace

int main(int count, char** words) {
  const double turns = count > 1 ? std::atof(words[1]) : 0.5;
  const bearing::Bearing b = fixture::angular_contact();
  dynamics::System system = fixture::make_system(b, fixture::full_plan());
  const double end = turns * 2.0 * std::numbers::pi / b.speed[1];
  const double none = std::numeric_limits<double>::infinity();
  const Outcome right = run(system, "rkf7", 1e-9, 1e-6, false, end);
  const Outcome other = run(system, "rkf6", 1e-9, 1e-6, false, end);
  std::printf("%g turns; two references differ by %.2g %%\n", turns,
              error(system, other.y, right.y));
  std::printf(
      "| method | tol | longest step [us] | s | evaluations | Jacobians | error %% |\n"
      "|---|---|---|---|---|---|---|\n");
  constexpr int kLimits = 4;
  const double limits[kLimits] = {1.0, 0.2, 0.1, 0.01};
  double own[kLimits], dense[kLimits];
  std::fill_n(own, kLimits, none);
  std::fill_n(dense, kLimits, none);
  const auto row = [&](const char* method, double tolerance, double longest, bool plain) {
    try {
      const Outcome found = run(system, method, tolerance, longest, plain, end);
      const double off = error(system, found.y, right.y);
      std::printf("| %s%s | %g | %.3g | %.4f | %ld | %ld | %.2g |\n", method,
                  plain ? ", dense" : "", tolerance, 1e6 * longest, found.seconds,
                  found.counters.evaluations, found.counters.jacobians, off);
      for (int k = 0; k < kLimits; ++k)
        if (off <= limits[k])
          (plain ? dense : own)[k] = std::min((plain ? dense : own)[k], found.seconds);
    } catch (const StepFailure& failure) {
      std::printf("| %s | %g | | | | | %s |\n", method, tolerance, failure.what());
    }
    std::fflush(stdout);
  };
  for (const double longest : {3.5e-6, 5e-6, 7e-6, 10e-6, 13e-6})
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7}) row("rk4", tolerance, longest, false);
  for (const char* method : {"rkf5", "rkf6", "rkf7", "pece6"})
    for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8}) row(method, tolerance, 13e-6, false);
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
    row("cvode-bdf", tolerance, none, true);
  for (int k = 0; k < kLimits; ++k)
    if (!std::isfinite(own[k]) || !std::isfinite(dense[k]))
      std::printf("error up to %g %%: not reached by both\n", limits[k]);
    else
      std::printf("error up to %g %%: %.4f s against %.4f s, 1/%.1f\n", limits[k], own[k], dense[k],
                  dense[k] / own[k]);
}
