#include "../core/statics/roller_bearings.hpp"

#include <benchmark/benchmark.h>

/// 31 slices, thrust and radial load at 3000 rpm. Aims of the project: cold 5 ms; warm (1 % more
/// load, from the earlier solution of the same bearing) a fifth of these 5 ms, 1 ms.
namespace {

using adore::bearing::Bearing;
using adore::statics::solve_roller_statics;

void cold(benchmark::State& state, const Bearing& bearing) {
  for (auto _ : state) benchmark::DoNotOptimize(solve_roller_statics(bearing));
}

void warm(benchmark::State& state, Bearing bearing) {
  const auto before = solve_roller_statics(bearing);
  for (double& load : bearing.constraints.load) load *= 1.01;
  adore::statics::RollerOptions options;
  options.start = &before;
  for (auto _ : state) benchmark::DoNotOptimize(solve_roller_statics(bearing, options));
}

BENCHMARK_CAPTURE(cold, cylindrical_aim_5ms, roller_bearings::cylindrical(3000.0))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(cold, barrel_aim_5ms, roller_bearings::spherical(3000.0))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(cold, tapered_aim_5ms, roller_bearings::tapered(3000.0))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(warm, cylindrical_aim_1ms, roller_bearings::cylindrical(3000.0))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(warm, barrel_aim_1ms, roller_bearings::spherical(3000.0))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(warm, tapered_aim_1ms, roller_bearings::tapered(3000.0))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
