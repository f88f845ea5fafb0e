// Cost of the films of lubricants in the contacts of rollers: the right-hand side of 14 cylindrical
// rollers with 31 slices on both races, all of them loaded, without cage or pockets. Counters: us
// per contact dry (the hypothetical law), in oil without and with the rolling resistance, by
// doubles and by floats, and the ratios to dry, each the least of many short runs that take turns.
#include "../core/dynamics/roller_scene.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <vector>

namespace {

using namespace adore;

struct Timed {
  dynamics::System system;
  std::vector<double> y, dydt;
  double least = 1.0;  ///< seconds of one right-hand side

  explicit Timed(dynamics::System of)
      : system(std::move(of)), y(system.initial_state()), dydt(y.size()) {}
  void run() {
    constexpr int kRepeats = 20;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kRepeats; ++i) {
      system.rhs(0.0, y.data(), dydt.data());
      benchmark::DoNotOptimize(dydt.data());
      benchmark::ClobberMemory();
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count() / kRepeats);
  }
};

dynamics::System system_of(int code, bool rolls, bool single = false) {
  using enum scene::Effect;
  constexpr int kSlices = 31;
  dynamics::SystemOptions options;
  options.single_films = single;
  bearing::Bearing b = roller_bearings::cylindrical(6000.0, -2e-5);
  b.rollers()->flange = {};
  roller_scene::add_friction(b);
  if (code != 0) {
    b.lubrication.emplace();
    b.lubrication->code = code;
    b.lubrication->critical_film = 1e-9;
    b.lubrication->meniscus = 10.0;
  }
  return roller_scene::scene_of(
             b,
             rolls ? roller_scene::plan_of({RaceContact, RaceTraction, RollingResistance})
                   : roller_scene::plan_of({RaceContact, RaceTraction}),
             kSlices, 0.0, options)
      .system;
}

void rollers_in_oil(benchmark::State& state, int code) {
  Timed dry(system_of(0, false)), oil(system_of(code, false)), rolling(system_of(code, true)),
      oil_by_floats(system_of(code, false, true)), by_floats(system_of(code, true, true));
  for (auto _ : state) by_floats.run();
  constexpr int kRuns = 150;
  for (int i = 0; i < kRuns; ++i)
    for (Timed* one : {&dry, &oil, &rolling, &oil_by_floats, &by_floats}) one->run();
  constexpr double kContacts = 28.0;
  state.counters["us_dry"] = 1e6 * dry.least / kContacts;
  state.counters["us_oil"] = 1e6 * oil.least / kContacts;
  state.counters["us_rolling"] = 1e6 * rolling.least / kContacts;
  state.counters["us_oil_floats"] = 1e6 * oil_by_floats.least / kContacts;
  state.counters["us_rolling_floats"] = 1e6 * by_floats.least / kContacts;
  state.counters["ratio_oil"] = oil.least / dry.least;
  state.counters["ratio_rolling"] = rolling.least / dry.least;
  state.counters["ratio_oil_floats"] = oil_by_floats.least / dry.least;
  state.counters["ratio_rolling_floats"] = by_floats.least / dry.least;
}

const int registered = [] {
  for (const int code : {1, 3, 6, 10, 11, 19, 8, 12})
    benchmark::RegisterBenchmark(("kTrac_" + std::to_string(code)).c_str(),
                                 [=](benchmark::State& state) { rollers_in_oil(state, code); })
        ->Unit(benchmark::kMicrosecond);
  return 0;
}();

}  // namespace
