#include "../core/dynamics/system_fixture.hpp"

#include <benchmark/benchmark.h>

/// The right-hand side of an 18-ball bearing with cage, two guide lands and two-slope traction, and
/// its parts.
namespace {

using namespace adore;
using namespace adore::dynamics;
using enum Effect;

void run_rhs(benchmark::State& state, const ScenePlan& plan, bool in_contact) {
  const bearing::Bearing b = fixture::angular_contact();
  System system = fixture::make_system(b, plan);
  std::vector<double> y = system.initial_state();
  if (in_contact)  // every ball 4 µm in its pocket wall
    for (std::size_t i = 0; i < 18; ++i) y[36 + i] += 1.54e-4 / 0.0475;
  std::vector<double> dydt(y.size());
  for (auto _ : state) {
    system.rhs(0.0, y.data(), dydt.data());
    benchmark::DoNotOptimize(dydt.data());
    benchmark::ClobberMemory();
  }
  for (const CostLedger::Row& row : system.cost().rows())
    state.counters[row.name + " [us]"] = 1e6 * row.seconds / static_cast<double>(row.calls);
}

void full(benchmark::State& state) { run_rhs(state, fixture::full_plan(), false); }
void full_all_pockets_in_contact(benchmark::State& state) {
  run_rhs(state, fixture::full_plan(), true);
}
void races_with_traction(benchmark::State& state) {
  run_rhs(state, fixture::plan_with({RaceContact, RaceTraction}), false);
}
void races_without_traction(benchmark::State& state) {
  run_rhs(state, fixture::plan_with({RaceContact}), false);
}
void cage_only(benchmark::State& state) {
  run_rhs(
      state,
      fixture::plan_with({CageMotion, PocketContact, PocketTraction, LandContact, LandTraction}),
      false);
}

BENCHMARK(full)->Unit(benchmark::kMicrosecond);
BENCHMARK(full_all_pockets_in_contact)->Unit(benchmark::kMicrosecond);
BENCHMARK(races_with_traction)->Unit(benchmark::kMicrosecond);
BENCHMARK(races_without_traction)->Unit(benchmark::kMicrosecond);
BENCHMARK(cage_only)->Unit(benchmark::kMicrosecond);

}  // namespace
