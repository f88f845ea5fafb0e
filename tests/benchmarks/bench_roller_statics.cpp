#include "../core/statics/roller_bearings.hpp"

#include <benchmark/benchmark.h>

using adore::statics::solve_roller_statics;

/// 31 slices, thrust and radial load at 3000 rpm. Aims: 5 ms cold; warm (1 % more load, from the
/// earlier solution) a fifth of that.
static adore::bearing::Bearing bearing_of(long type) {
  if (type == 2) return roller_bearings::cylindrical(3000.0);
  if (type == 3) return roller_bearings::spherical(3000.0);
  return roller_bearings::tapered(3000.0);
}

static void rollers_cold(benchmark::State& state) {
  const auto bearing = bearing_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(solve_roller_statics(bearing));
}
BENCHMARK(rollers_cold)->ArgName("kBrg")->Arg(2)->Arg(3)->Arg(4)->Unit(benchmark::kMicrosecond);

static void rollers_warm(benchmark::State& state) {
  auto bearing = bearing_of(state.range(0));
  const auto before = solve_roller_statics(bearing);
  for (double& load : bearing.constraints.load) load *= 1.01;
  adore::statics::RollerOptions options;
  options.start = &before;
  for (auto _ : state) benchmark::DoNotOptimize(solve_roller_statics(bearing, options));
}
BENCHMARK(rollers_warm)->ArgName("kBrg")->Arg(2)->Arg(3)->Arg(4)->Unit(benchmark::kMicrosecond);
