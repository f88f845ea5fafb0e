// Cost and accuracy of the ball/race contacts: 18 balls on both races, one call per race and
// iteration. Counters: the larger error of the two races against the converged integrals
// (measure_rule_error).
#include "../core/dynamics/thrust_scene.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace {

using namespace adore;
using dynamics::InstructionSet;

const char* const kCases[] = {"dyn3_40_10k_twoslope_curved", "dyn3_40_30k_twoslope_curved",
                              "dyn3_40_60k_twoslope_curved", "dyn3_40_30k_exp_curved"};

/// The larger error of the two races.
dynamics::QuadratureRuleError rule_error(const test::ThrustScene& scene) {
  dynamics::QuadratureRuleError both;
  for (std::size_t j = 0; j < 2; ++j) {
    const dynamics::QuadratureRuleError one =
        dynamics::measure_rule_error(scene.model[j], scene.arrays(), scene.race[j]);
    both.force = std::max(both.force, one.force);
    both.moment = std::max(both.moment, one.moment);
    both.heat = std::max(both.heat, std::abs(one.heat));
  }
  return both;
}

struct Rule {
  bool split;
  int major, minor;

  [[nodiscard]] tribology::EllipseRule make() const {
    return split ? tribology::make_split_ellipse_rule(major, minor)
                 : tribology::make_ellipse_rule(major, minor);
  }
  [[nodiscard]] std::string name() const {
    return std::string(split ? "split" : "product") + std::to_string(major) + "x" +
           std::to_string(minor);
  }
};

/// `traction` off shows what geometry, normal forces and summation cost alone.
void race_contacts(benchmark::State& state, const char* id, InstructionSet set, const Rule& rule,
                   bool traction) {
  if (!dynamics::is_instruction_set_available(set)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  test::ThrustScene scene = test::thrust_scene(id, 18, rule.make(), 1.0);
  for (auto& model : scene.model) model.traction = traction;
  test::Outputs out(scene.n);
  const dynamics::ElementForces forces = out.forces();
  const dynamics::ElementViews balls = scene.arrays();
  for (auto _ : state) {
    for (std::size_t j = 0; j < 2; ++j) {
      benchmark::DoNotOptimize(
          dynamics::evaluate_race_contacts(set, scene.model[j], balls, scene.race[j], forces));
    }
    benchmark::ClobberMemory();
  }
  if (!traction) return;
  static std::map<std::string, dynamics::QuadratureRuleError> known;
  const std::string key = id + rule.name();
  if (!known.contains(key)) known[key] = rule_error(scene);
  state.counters["force_error"] = known[key].force;
  state.counters["moment_error"] = known[key].moment;
  state.counters["heat_error"] = known[key].heat;
}

void add(const char* id, const Rule& rule, bool traction) {
  for (InstructionSet set :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    const std::string name = std::string(id) + "/" + dynamics::instruction_set_name(set) + "/" +
                             (traction ? rule.name() : "no_traction");
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      race_contacts(state, id, set, rule, traction);
    })->Unit(benchmark::kMicrosecond);
  }
}

const int registered = [] {
  for (const char* id : kCases) {
    add(id, {false, 1, 1}, false);
    for (const auto& [major, minor] :
         {std::pair{8, 4}, {12, 4}, {16, 4}, {20, 4}, {24, 6}, {32, 4}, {48, 8}}) {
      add(id, {false, major, minor}, true);
    }
    for (const auto& [major, minor] :
         {std::pair{10, 4}, {15, 4}, {20, 4}, {20, 6}, {30, 6}, {40, 8}}) {
      add(id, {true, major, minor}, true);
    }
  }
  return 0;
}();

}  // namespace
