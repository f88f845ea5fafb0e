#include "runs/restart_progress.hpp"

#include "base/errors.hpp"
#include "results/run_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace adore::runs {
namespace {

/// Names in MASTER.
constexpr std::string_view kStepper = "stepper ";
constexpr const char* kSubsteps = "substeps of the step under way";
constexpr const char* kSegment = "step from which maxStps counts";
constexpr const char* kPlotted = "last step in SOL1-SOL7";
constexpr const char* kAnimated = "last step in SOL8";
constexpr const char* kPrinted = "last step in PRINT";
constexpr const char* kLifeStep = "last step of the life models";
constexpr const char* kHeldChanges = "counter of changes of held elements";
constexpr std::pair<const char*, double Resume::*> kErrors[] = {
    {"error estimates of the steps, sum", &Resume::error_sum},
    {"error estimates of the steps, largest", &Resume::error_largest},
    {"tolerance for films", &Resume::tolerance},
    {"time under a tolerance for films", &Resume::tight_time},
    {"tightest tolerance for films", &Resume::tightest}};
constexpr std::pair<const char*, long integrators::Counters::*> kCounters[] = {
    {"counter of steps", &integrators::Counters::steps},
    {"counter of rejected", &integrators::Counters::rejected},
    {"counter of evaluations", &integrators::Counters::evaluations},
    {"counter of at_minimum", &integrators::Counters::at_minimum},
    {"counter of restarts", &integrators::Counters::restarts},
    {"counter of jacobians", &integrators::Counters::jacobians},
    {"counter of nonlinear_iterations", &integrators::Counters::nonlinear_iterations},
    {"counter of repeated_for_energy", &integrators::Counters::repeated_for_energy}};
constexpr const char* kStoredEnergy = "ledger stored at start";
constexpr const char* kEnergyResidual = "ledger residual";

/// The same ledger with another start.
template <class Value>
void set_start(scene::Ledger<Value>& ledger, const Value& start) {
  scene::Ledger<Value> out;
  for (const auto& item : ledger.items())
    out.add(*item.term, item.term->kind == scene::LedgerKind::Start ? start : item.value, item.race,
            item.rate);
  ledger = std::move(out);
}

std::string momentum_name(std::string_view kind, int axis) {
  return fmt::format("ledger {} momentum at start {}", kind, axis);
}

}  // namespace

void save_progress(std::map<std::string, double>& state, const scene::Snapshot& at,
                   const Resume& resume, const LastStoredSteps& steps, long segment,
                   const setup::RunControl& control) {
  state[kStoredEnergy] = at.energy.sum(scene::LedgerKind::Start);
  state[kEnergyResidual] = at.energy.residual();
  for (int k = 0; at.momentum && k < 3; ++k) {
    state[momentum_name("linear", k)] = at.momentum->linear.sum(scene::LedgerKind::Start)[k];
    state[momentum_name("angular", k)] = at.momentum->angular.sum(scene::LedgerKind::Start)[k];
  }
  const auto whole = [&](const char* name, long value) {
    state[name] = static_cast<double>(value);
  };
  whole(kSubsteps, resume.substeps);
  whole(kSegment, segment);
  whole(kPlotted, steps.plotted);
  whole(kAnimated, steps.animated);
  whole(kPrinted, steps.printed);
  whole(results::kLastSaved, steps.saved);
  whole(kLifeStep, steps.lived);
  for (const auto& [name, counter] : kCounters) whole(name, resume.counters.*counter);
  whole(kHeldChanges, resume.held_changes);
  for (const auto& [name, error] : kErrors) state[name] = resume.*error;
  if (resume.memory.empty()) return;
  const std::string stem(kStepper);
  state[stem + "is " + control.integrator] = 1.0;
  state[stem + "tolerance"] = control.tolerance;
  state[stem + "minimum"] = control.step_minimum;
  state[stem + "maximum"] = control.step_maximum;
  for (const auto& [name, value] : resume.memory) state[stem + "memory " + name] = value;
}

std::optional<LedgerStart> LedgerStart::of(const results::MasterState& master) {
  const std::map<std::string, double>& state = master.averages;
  if (state.count(kStoredEnergy) == 0 || state.count(kEnergyResidual) == 0) return {};
  const auto number = [&](const std::string& name) {
    const auto found = state.find(name);
    return found == state.end() ? 0.0 : found->second;
  };
  LedgerStart start;
  start.stored = number(kStoredEnergy);
  start.residual = number(kEnergyResidual);
  for (int k = 0; k < 3; ++k) {
    start.linear[k] = number(momentum_name("linear", k));
    start.angular[k] = number(momentum_name("angular", k));
  }
  return start;
}

bool LedgerStart::is_continued_by(const scene::EnergyLedger& now) const {
  double largest = 0.0;
  for (const auto& item : now.items())
    if (item.term->kind != scene::LedgerKind::Note)
      largest = std::max(largest, std::abs(item.value));
  const double rounding = 1e-12 * largest;
  return std::abs(now.residual() - residual) <= rounding + 1e-9 * results::energy_scale(now);
}

void LedgerStart::apply(scene::Snapshot& to) const {
  set_start(to.energy, stored);
  if (!to.momentum) return;
  set_start<Eigen::Vector3d>(to.momentum->linear, linear);
  set_start<Eigen::Vector3d>(to.momentum->angular, angular);
}

LastStoredSteps restore_progress(const results::MasterState& master,
                                 const setup::RunControl& control,
                                 const std::filesystem::path& file, StartPoint& out) {
  const std::map<std::string, double>& state = master.averages;
  const auto number = [&](const std::string& name, double otherwise) {
    const auto found = state.find(name);
    return found == state.end() ? otherwise : found->second;
  };
  const auto whole = [&](const char* name, long otherwise, long least, long most) {
    const auto found = state.find(name);
    if (found == state.end()) return otherwise;  // of an older release
    const double value = found->second;
    if (value != std::round(value) || value < static_cast<double>(least) ||
        value > static_cast<double>(most))
      throw InputError(
          fmt::format("{}: \"{}\" is {}, which is not a whole number from {} to {}; the file is "
                      "damaged. Restore it, or start again with --overwrite",
                      file.string(), name, value, least, most));
    return static_cast<long>(value);
  };
  constexpr long kMaxWhole = 9'000'000'000'000'000;  // beyond, whole numbers run together
  // The deck may count fewer substeps as one step than it did.
  out.resume.substeps = std::min(whole(kSubsteps, 0, 0, kMaxWhole), control.substeps - 1L);
  out.segment = whole(kSegment, 0, 0, out.step);
  LastStoredSteps steps;
  // Older files hold the state of the last stored step.
  steps.plotted = whole(kPlotted, out.step, -1, out.step);
  steps.animated = whole(kAnimated, out.step, -1, out.step);
  steps.printed = whole(kPrinted, out.step, -1, out.step);
  steps.saved = whole(results::kLastSaved, out.step, -1, out.step);
  steps.lived = whole(kLifeStep, out.step, -1, out.step);
  for (const auto& [name, counter] : kCounters)
    out.resume.counters.*counter = whole(name, 0, 0, kMaxWhole);
  out.resume.held_changes = whole(kHeldChanges, 0, 0, kMaxWhole);
  for (const auto& [name, error] : kErrors) {
    const double value = number(name, 0.0);
    if (!(value >= 0.0) || !std::isfinite(value))
      throw InputError(
          fmt::format("{}: \"{}\" is {}, which is not a number of 0 or more; the file is damaged. "
                      "Restore it, or start again with --overwrite",
                      file.string(), name, value));
    out.resume.*error = value;
  }
  const std::string stem(kStepper), memory = stem + "memory ";
  if (number(stem + "is " + control.integrator, 0.0) != 1.0 ||
      number(stem + "tolerance", 0.0) != control.tolerance ||
      number(stem + "minimum", -1.0) != control.step_minimum ||
      number(stem + "maximum", -1.0) != control.step_maximum)
    return steps;
  for (auto at = state.lower_bound(memory); at != state.end() && at->first.starts_with(memory);
       ++at) {
    if (!std::isfinite(at->second))
      throw InputError(
          fmt::format("{}: \"{}\" is not finite; the file is damaged. Restore it, or start again "
                      "with --overwrite",
                      file.string(), at->first));
    out.resume.memory[at->first.substr(memory.size())] = at->second;
  }
  return steps;
}

}  // namespace adore::runs
