#include "runs/effect_costs.hpp"

#include "dynamics/system.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::runs {
namespace {

struct Measured {
  std::vector<EffectCost> shares;
  double per_call = 0.0;  ///< [s]
};

Measured measure(const Prepared& prepared) {
  Measured out;
  if (!prepared.control.dynamic) return out;
  dynamics::System system = make_system(prepared);
  const std::vector<double> y = system.initial_state();
  std::vector<double> rates(y.size());
  using Clock = scene::CostLedger::Clock;
  constexpr auto kMeasuringTime = std::chrono::milliseconds(100);
  constexpr long kMaxCalls = 20000;
  const auto begin = Clock::now();
  long calls = 0;
  while (calls < kMaxCalls &&
         (calls < 4 * scene::CostLedger::kSampleEvery || Clock::now() - begin < kMeasuringTime)) {
    if (system.rhs(0.0, y.data(), rates.data()) != dynamics::RhsStatus::Ok) return out;
    ++calls;
  }
  double sum = 0.0;
  for (const auto& row : system.cost().rows()) sum += row.seconds;
  if (!(sum > 0.0)) return out;
  out.per_call = sum / static_cast<double>(calls);
  for (const auto& row : system.cost().rows()) out.shares.push_back({row.name, row.seconds / sum});
  std::stable_sort(out.shares.begin(), out.shares.end(),
                   [](const EffectCost& a, const EffectCost& b) { return a.share > b.share; });
  return out;
}

}  // namespace

std::vector<EffectCost> effect_costs(const Prepared& prepared) { return measure(prepared).shares; }

std::string effect_costs_text(const Prepared& prepared) {
  const Measured found = measure(prepared);
  if (found.shares.empty()) return {};
  std::string text =
      fmt::format("CPU time of the effects at the start state: {:.3g} us per evaluation in total\n",
                  1e6 * found.per_call);
  for (const EffectCost& cost : found.shares)
    if (cost.share >= 5e-4)
      text += fmt::format("  {:<34} {:5.1f} %\n", cost.name, 100.0 * cost.share);
  return text;
}

}  // namespace adore::runs
