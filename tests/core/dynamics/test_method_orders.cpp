#include "core/dynamics/system_fixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

/// Every method on a smooth scene of a bearing: balls that vibrate on loaded contacts.
using namespace adore;

namespace {

constexpr double kEnd = 1e-4;  // about three periods of the contact vibration [s]

/// Displaced radially by up to 1 µm on contacts under thrust: none opens, so all rates are smooth.
std::vector<double> displaced(const dynamics::System& system) {
  std::vector<double> y = system.initial_state();
  constexpr std::size_t kBalls = 18;
  for (std::size_t i = 0; i < kBalls; ++i)
    y[kBalls + i] += 1e-6 * std::sin(1.0 + static_cast<double>(i));
  return y;
}

/// State after equal steps.
std::vector<double> after(dynamics::System& system, std::string_view method, int steps) {
  fixture::Adapter adapter(system);
  const std::vector<double> y0 = displaced(system);
  system.set_start(0.0, y0);
  const auto stepper = integrators::make_stepper(method);
  const double h = kEnd / steps;
  stepper->start(adapter, 0.0, y0,
                 {.initial = h,
                  .minimum = h,
                  .maximum = h,
                  .tolerance = method.starts_with("arkode") ? 1e-11 : 1e-15});
  while (stepper->time() < kEnd) stepper->step(kEnd);
  return {stepper->state().begin(), stepper->state().end()};
}

double distance(const dynamics::System& system, const std::vector<double>& a,
                const std::vector<double>& b) {
  const auto scales = system.layout().scales();
  double worst = 0.0;
  for (int i = 0; i < system.layout().controlled_size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    worst = std::max(worst, std::abs(a[k] - b[k]) / std::abs(scales[k]));
  }
  return worst;
}

dynamics::System smooth_scene() {
  bearing::Bearing b = fixture::angular_contact();
  b.constraints.load = {1500.0, 0.0, 0.0, 0.0, 0.0};
  return fixture::make_system(b, fixture::plan_with({scene::Effect::RaceContact}));
}

}  // namespace

TEST_CASE("every method that holds a constant step: its order on a smooth bearing scene",
          "[physics][dynamics][integrators]") {
  dynamics::System system = smooth_scene();
  const std::vector<double> exact = after(system, "rkf7", 1000);
  // Steps in the asymptotic range and above rounding.
  const std::map<int, int> steps{{1, 4000}, {2, 1000}, {3, 400}, {4, 100},
                                 {5, 60},   {6, 40},   {7, 30},  {8, 80}};
  for (const std::string_view name : integrators::stepper_names()) {
    const auto stepper = integrators::make_stepper(name);
    if (!stepper->can_hold_constant_step()) continue;
    // The error of ARKODE's Newton iteration has a floor.
    const int n = name.starts_with("arkode") ? 40 : steps.at(stepper->order());
    const double coarse = distance(system, after(system, name, n), exact),
                 fine = distance(system, after(system, name, 2 * n), exact);
    const double order = std::log2(coarse / fine);
    INFO(name << ", " << n << " steps: errors " << coarse << " and " << fine << ", order "
              << order);
    CHECK(order > stepper->order() - 0.3);
    CHECK(fine > 1e-14);
  }
}

TEST_CASE("CVODE: error falls with the tolerance on a smooth bearing scene",
          "[physics][dynamics][integrators]") {
  dynamics::System system = smooth_scene();
  const std::vector<double> exact = after(system, "rkf7", 1000);
  for (const char* name : {"cvode-adams", "cvode-bdf"}) {
    const auto error = [&](double tolerance) {
      return distance(system, fixture::run(system, displaced(system), kEnd, tolerance, name).y,
                      exact);
    };
    const double loose = error(1e-7), tight = error(1e-9);
    CAPTURE(name, loose, tight);
    CHECK(tight < 0.1 * loose);
  }
}
