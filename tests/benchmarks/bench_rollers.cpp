#include "../core/dynamics/roller_scene.hpp"

#include <benchmark/benchmark.h>

/// The right-hand side of an 18-roller cylindrical bearing with 21 slices, cage and traction, and
/// that of a tapered one.
namespace {

using namespace adore;

void run_rhs(benchmark::State& state, roller_scene::Scene s) {
  std::vector<double> y = s.system.initial_state();
  std::vector<double> dydt(y.size());
  for (auto _ : state) {
    s.system.rhs(0.0, y.data(), dydt.data());
    benchmark::DoNotOptimize(dydt.data());
    benchmark::ClobberMemory();
  }
  for (const scene::CostLedger::Row& row : s.system.cost().rows())
    state.counters[row.name + " [us]"] = 1e6 * row.seconds / static_cast<double>(row.calls);
}

roller_scene::Scene cylindrical(double misalignment) {
  bearing::Bearing b = roller_bearings::cylindrical(6000.0);
  b.rollers()->count = 18;
  b.rollers()->pitch_diameter = 0.075;
  b.constraints.displacement[3] = misalignment;
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  return roller_scene::scene_of(b, roller_scene::with_friction(), 21);
}

void cylindrical_18_rollers_21_slices(benchmark::State& state) { run_rhs(state, cylindrical(0.0)); }
void the_same_misaligned(benchmark::State& state) { run_rhs(state, cylindrical(1e-3)); }
void tapered_17_rollers_21_slices(benchmark::State& state) {
  bearing::Bearing b = roller_bearings::tapered(6000.0);
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  run_rhs(state, roller_scene::scene_of(b, roller_scene::with_friction(), 21));
}

BENCHMARK(cylindrical_18_rollers_21_slices)->Unit(benchmark::kMicrosecond);
BENCHMARK(the_same_misaligned)->Unit(benchmark::kMicrosecond);
BENCHMARK(tapered_17_rollers_21_slices)->Unit(benchmark::kMicrosecond);

}  // namespace
