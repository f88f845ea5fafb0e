#include "runs/pilot.hpp"

#include "base/errors.hpp"
#include "integrators/stepper.hpp"
#include "runs/key_results.hpp"
#include "runs/start_state.hpp"
#include "runs/system_ode.hpp"
#include "scene/cost_ledger.hpp"

#include <vector>

namespace adore::runs {

PilotResult run_pilot(const Prepared& prepared, dynamics::System& system, const StepLimits& limits,
                      double span, double budget) {
  constexpr std::size_t kMaxSteps = 20'000;
  constexpr std::size_t kStepsPerTimeCheck = 16;
  const double scale = system.scales().time;
  integrators::StepControl control;
  control.initial = prepared.control.step_initial * scale;
  control.minimum = limits.minimum;
  control.maximum = limits.maximum;
  control.highest_order = limits.highest_order;
  control.tolerance = prepared.control.tolerance;
  std::vector<double> y = start_state(prepared, system).y;
  std::vector<double> times{0.0};
  const double begin = scene::processor_seconds();
  double seconds = 0.0;
  try {
    SystemOde ode(system, static_elastic_energy(prepared));
    const auto stepper = integrators::make_stepper(prepared.control.integrator);
    system.set_start(0.0, y);
    (void)system.between_steps(0.0, y);
    stepper->start(ode, 0.0, y, control);
    while (stepper->time() < span && times.size() < kMaxSteps && seconds < budget) {
      stepper->step(span);
      times.push_back(stepper->time());
      if (times.size() % kStepsPerTimeCheck == 0) seconds = scene::processor_seconds() - begin;
    }
  } catch (const integrators::StepFailure&) {
  } catch (const SolverError&) {
  } catch (const InputError&) {
  } catch (const std::invalid_argument&) {
  }
  seconds = scene::processor_seconds() - begin;
  const std::size_t steps = times.size() - 1;
  if (steps < 2) return {};
  const std::size_t half = steps / 2;
  return {(times.back() - times[half]) / static_cast<double>(steps - half),
          seconds / static_cast<double>(steps)};
}

}  // namespace adore::runs
