// Cost of lubricant films compared with the hypothetical law, in one run: 16 balls (whole vectors)
// on both races with the nodes of a run for that lubricant (runs/prepare.cpp), and with equal
// nodes: 15 x 4, 20 x 2 of whole strips (`_equal`). Then the rolling resistance of the same
// contacts. Films are in single precision where runs use it (`ns_double`: double precision).
// Counters: ns per contact, `ratio` to the hypothetical law of the same instruction set, measured
// just before, and the heat of both races relative to 100 x 40 nodes, in percent.
#include "../core/dynamics/thrust_scene.hpp"
#include "tribology/film_law.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

namespace {

using namespace adore;
using dynamics::InstructionSet;

constexpr std::size_t kBalls = 16;

/// Nodes along and across the contact of a run.
using Nodes = tribology::EllipseNodeCounts;
bool strips(int code) {
  return tribology::lubricant(code).model == tribology::LubricantModel::ViscoElastic;
}
Nodes nodes_of(int code) {
  if (code == 0) return {15, 2};
  return strips(code) ? tribology::kStripNodes : tribology::kFilmNodes;
}
Nodes equal_nodes_of(int code) {
  if (code == 0) return {15, 2};
  return strips(code) ? Nodes{20, 2} : Nodes{15, 4};
}

bearing::Lubrication lubrication_of(int code) {
  bearing::Lubrication lubrication;
  lubrication.code = code;
  lubrication.critical_film = 1e-9;
  lubrication.meniscus = 10.0;
  return lubrication;
}

tribology::RaceFilmInputs contact_surface(bool single = true) {
  tribology::RaceFilmInputs surface;
  surface.radius = 0.005;
  surface.modulus = 2.26e11;
  surface.wall_temperature = 360.0;
  surface.race_speed = 60.0;
  surface.width_over_pressure = 1e-13;
  surface.single = single;
  return surface;
}

test::ThrustScene scene_of(int code, Nodes nodes, bool single = true) {
  test::ThrustScene scene =
      test::thrust_scene("dyn3_40_30k_exp_curved", kBalls, tribology::make_run_rule(nodes), 1.0);
  if (code == 0) return scene;
  for (auto& model : scene.model)
    model.law = tribology::film_law(bearing::TractionCurve{}, tribology::lubricant(code),
                                    lubrication_of(code), contact_surface(single));
  return scene;
}

/// @param rolling null: contacts and traction
void evaluate(test::ThrustScene& scene, InstructionSet set, test::Outputs& out,
              const tribology::RollingResistance* rolling = nullptr) {
  const dynamics::ElementForces forces = out.forces();
  const dynamics::ElementViews balls = scene.arrays();
  for (std::size_t j = 0; j < 2; ++j)
    benchmark::DoNotOptimize(
        rolling == nullptr
            ? dynamics::evaluate_race_contacts(set, scene.model[j], balls, scene.race[j], forces)
            : dynamics::evaluate_race_rolling(set, scene.model[j], *rolling, balls, scene.race[j],
                                              forces));
}

/// Seconds per evaluation of both races, the least of some runs.
double seconds(test::ThrustScene& scene, InstructionSet set,
               const tribology::RollingResistance* rolling = nullptr) {
  test::Outputs out(scene.n);
  double least = 1.0;
  for (int run = 0; run < 120; ++run) {
    constexpr int kRepeats = 50;  // short: some runs meet nobody else on the machine
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kRepeats; ++i) evaluate(scene, set, out, rolling);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count() / kRepeats);
  }
  return least;
}

double heat(test::ThrustScene& scene) {
  test::Outputs out(scene.n);
  double sum = 0.0;
  for (std::size_t j = 0; j < 2; ++j)
    sum += dynamics::evaluate_race_contacts(scene.model[j], scene.arrays(), scene.race[j],
                                            out.forces())
               .heat;
  return sum;
}

void films(benchmark::State& state, int code, InstructionSet set) {
  if (!dynamics::is_instruction_set_available(set)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  test::ThrustScene dry = scene_of(0, nodes_of(0)), scene = scene_of(code, nodes_of(code)),
                    numbers = scene_of(code, nodes_of(code), false),
                    equal = scene_of(code, equal_nodes_of(code)),
                    fine = scene_of(code, {100, 40}, false);
  const double hypothetical = seconds(dry, set), own = seconds(scene, set);
  test::Outputs out(scene.n);
  for (auto _ : state) {
    evaluate(scene, set, out);
    benchmark::ClobberMemory();
  }
  constexpr double kContacts = 2.0 * kBalls;
  state.counters["ns_per_contact"] = 1e9 * own / kContacts;
  state.counters["ns_double"] = 1e9 * seconds(numbers, set) / kContacts;
  state.counters["ns_equal"] = 1e9 * seconds(equal, set) / kContacts;
  state.counters["ratio"] = own / hypothetical;
  const double truth = heat(fine);
  state.counters["heat_off"] = 100.0 * (heat(scene) / truth - 1.0);
  state.counters["heat_off_equal"] = 100.0 * (heat(equal) / truth - 1.0);
}

void rolling(benchmark::State& state, InstructionSet set) {
  if (!dynamics::is_instruction_set_available(set)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  test::ThrustScene scene = scene_of(1, {15, 2});
  const tribology::RollingResistance law =
      tribology::rolling_resistance(tribology::lubricant(1), lubrication_of(1), contact_surface());
  test::Outputs out(scene.n);
  for (auto _ : state) {
    evaluate(scene, set, out, &law);
    benchmark::ClobberMemory();
  }
  state.counters["ns_per_contact"] = 1e9 * seconds(scene, set, &law) / (2.0 * kBalls);
}

const int registered = [] {
  for (const InstructionSet set : {InstructionSet::Avx512, InstructionSet::Avx2}) {
    benchmark::RegisterBenchmark(
        (std::string("rolling_resistance/") + dynamics::instruction_set_name(set)).c_str(),
        [=](benchmark::State& state) { rolling(state, set); })
        ->Unit(benchmark::kMicrosecond);
    for (const int code : {0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 8, 12}) {
      const std::string name =
          std::string("kTrac_") + std::to_string(code) + "/" + dynamics::instruction_set_name(set);
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        films(state, code, set);
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return 0;
}();

}  // namespace
