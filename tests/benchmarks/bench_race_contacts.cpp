// Cost and accuracy of the ball/race contacts: 18 balls on both races, one call per race and
// iteration. Counters: errors against the converged integrals over both races: traction force and
// moment (root mean square over the contacts, in units of the full-slip force and of that force
// times the major half axis) and the total heat (relative).
#include "../core/dynamics/thrust_scene.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace {

using namespace adore;
using dynamics::InstructionSet;

const char* const kCases[] = {"dyn3_40_10k_twoslope_curved", "dyn3_40_30k_twoslope_curved",
                              "dyn3_40_60k_twoslope_curved", "dyn3_40_30k_exp_curved"};

struct Errors {
  double force = 0.0, moment = 0.0, heat = 0.0;
};

Errors rule_errors(const test::ThrustScene& scene) {
  Errors errors;
  double heat = 0.0, exact_heat = 0.0;
  int count = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t i = 0; i < scene.n; ++i) {
      const auto state =
          dynamics::race_contact_state(scene.model[j], scene.arrays(), i, scene.race[j]);
      if (!(state.approach > 0.0)) continue;
      const auto& curve = scene.model[j].curve;
      const auto exact = tribology::ellipse_traction_converged(curve, state.ellipse, state.motion);
      const auto rule =
          tribology::ellipse_traction(curve, state.ellipse, state.motion, scene.model[j].rule);
      const double full = tribology::traction_coefficient(curve, 10.0) * state.ellipse.Q;
      errors.force += std::pow(std::hypot(rule.F_c - exact.F_c, rule.F_t - exact.F_t) / full, 2);
      errors.moment += std::pow((rule.M_n - exact.M_n) / (full * state.ellipse.a), 2);
      heat += rule.heat;
      exact_heat += exact.heat;
      ++count;
    }
  }
  return {std::sqrt(errors.force / count), std::sqrt(errors.moment / count),
          heat / exact_heat - 1.0};
}

void race_contacts(benchmark::State& state, const char* id, InstructionSet set, int major,
                   int minor) {
  if (!dynamics::instruction_set_available(set)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  const test::ThrustScene scene =
      test::thrust_scene(id, 18, tribology::make_ellipse_rule(major, minor), 1.0);
  test::Outputs out(scene.n);
  const dynamics::BallForces forces = out.forces();
  const dynamics::BallArrays balls = scene.arrays();
  for (auto _ : state) {
    for (std::size_t j = 0; j < 2; ++j) {
      benchmark::DoNotOptimize(
          dynamics::evaluate_race_contacts(set, scene.model[j], balls, scene.race[j], forces));
    }
    benchmark::ClobberMemory();
  }
  static std::map<std::pair<std::string, int>, Errors> known;
  const std::pair<std::string, int> key(id, 1000 * major + minor);
  if (!known.contains(key)) known[key] = rule_errors(scene);
  state.counters["force_error"] = known[key].force;
  state.counters["moment_error"] = known[key].moment;
  state.counters["heat_error"] = known[key].heat;
}

const int registered = [] {
  for (const char* id : kCases) {
    for (const auto& [major, minor] : {std::pair{8, 4},
                                       {12, 3},
                                       {12, 4},
                                       {16, 4},
                                       {20, 4},
                                       {24, 4},
                                       {24, 6},
                                       {32, 4},
                                       {48, 8}}) {
      for (InstructionSet set :
           {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
        const std::string name = std::string(id) + "/" + dynamics::instruction_set_name(set) + "/" +
                                 std::to_string(major) + "x" + std::to_string(minor);
        benchmark::RegisterBenchmark(name.c_str(), [id = id, set, major = major,
                                                    minor = minor](benchmark::State& s) {
          race_contacts(s, id, set, major, minor);
        })->Unit(benchmark::kMicrosecond);
      }
    }
  }
  return 0;
}();

}  // namespace
