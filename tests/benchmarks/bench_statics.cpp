#include "../core/statics/ball_bearings.hpp"
#include "contact/hertz.hpp"
#include "statics/ball_statics.hpp"
#include "statics/stiffness_table.hpp"

#include <benchmark/benchmark.h>

/// Cold start of the quasi-static solution: 16 balls, thrust and radial load, moment-free, at
/// speed. Aim: 1 ms with each rule for the spin axis.
static void ball(benchmark::State& state, adore::bearing::SpinRule rule) {
  auto bearing = ball_bearings::angular_contact_218(6000.0);
  ball_bearings::load(bearing, 17800, 0, 8900);
  bearing.spin_rule = rule;
  bearing.spin_angle = 0.6;
  for (auto _ : state) {
    benchmark::DoNotOptimize(adore::statics::solve_ball_statics(bearing));
  }
}
BENCHMARK_CAPTURE(ball, race_control_aim_1ms, adore::bearing::SpinRule::RaceControl)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ball, given_axis_aim_1ms, adore::bearing::SpinRule::Prescribed)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ball, least_heat_aim_1ms, adore::bearing::SpinRule::MinimumHeat)
    ->Unit(benchmark::kMicrosecond);

/// A table of 100 speeds with both kinds of stiffness, one warm start after the other. Aim: 0.2 s.
static void stiffness_table_100_aim_200ms(benchmark::State& state) {
  auto bearing = ball_bearings::angular_contact_218();
  ball_bearings::load(bearing, 17800, 0, 8900);
  const auto load_case = bearing.constraints;
  const double share = 0.01 * static_cast<double>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(adore::statics::stiffness_table(
        {100, share, {0.0, 0.0}, {0.0, 1000.0}},
        [&](const std::array<double, 2>& speed, const adore::statics::RaceResult* previous) {
          bearing.speed = speed;
          bearing.constraints = load_case;
          adore::statics::BallStaticsOptions options;
          options.difference_share = share;
          options.warm_start = previous != nullptr;
          if (previous != nullptr) bearing.constraints.displacement = previous->displacement;
          return static_cast<adore::statics::RaceResult>(
              adore::statics::solve_ball_statics(bearing, options));
        }));
  }
}
BENCHMARK(stiffness_table_100_aim_200ms)
    ->ArgName("pctDisp")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

static void hertz_constants(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(adore::contact::hertz_constants({4.0, 110.0}, 1.13e11));
  }
}
BENCHMARK(hertz_constants);
