#include "studies/verify.hpp"

#include "runs/prepare.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::studies {

Verification verify(const runs::RunRequest& request, const runs::RunOutcome& outcome,
                    std::stop_token stop) {
  const runs::Prepared prepared = runs::prepare(request);
  runs::RunRequest tight = repeated(request, prepared, outcome);
  const double tolerance = 0.1 * request.tolerance.value_or(prepared.control.tolerance);
  tight.tolerance = tolerance;
  const double scale = runs::make_system(prepared).scales().time;
  const double longest = 0.5 * outcome.longest_step / scale;
  tight.changes.emplace_back("stpMax", fmt::format("{:.6g}", longest));
  if (prepared.control.step_minimum > longest ||
      prepared.control.step_minimum == prepared.control.step_maximum)
    tight.changes.emplace_back("stpMin", fmt::format("{:.6g}", longest));
  // Stored at the same times, as nearly as steps allow.
  const int every = std::max(1, prepared.control.substeps);
  tight.changes.emplace_back("nStps", std::to_string(2 * every));
  Verification out;
  out.tighter = fmt::format("tol {:g}, steps at most {:.3g} s", tolerance, longest * scale);
  for (auto& [name, value] : doubled_resolution(prepared)) {
    out.tighter += fmt::format(", {} {}", name, value);
    tight.options.emplace_back(std::move(name), std::move(value));
  }
  const runs::MeasuredRun run =
      runs::measured_run(tight, std::numeric_limits<double>::infinity(), std::move(stop));
  out.seconds = run.seconds;
  out.results = run.outcome.summary;
  out.means = run.outcome.means;
  if (run.outcome.status == runs::RunStatus::Failed ||
      run.outcome.status == runs::RunStatus::Interrupted)
    out.failure = run.outcome.message;
  else
    out.errors = results::compare_results(outcome.summary, run.outcome.summary);
  return out;
}

runs::RunRequest repeated(const runs::RunRequest& request, const runs::Prepared& prepared,
                          const runs::RunOutcome& outcome) {
  runs::RunRequest out = request;
  out.go_on = false;
  // The end that was reached, for any reason.
  out.until = fmt::format("{:.17g}s", outcome.time);
  if (prepared.control.start == setup::StartState::Continue)
    out.changes.emplace_back("kIcOpt", "0");
  return out;
}

std::vector<std::pair<std::string, std::string>> doubled_resolution(
    const runs::Prepared& prepared) {
  constexpr int kMaxMajor = 100, kMaxMinor = 64, kMaxSlices = 999;  // of the run options
  if (prepared.rollers) {
    if (prepared.options.rollers.contact == statics::RollerContact::Point) return {};
    return {{"rollerSlices",
             std::to_string(std::min(2 * prepared.options.rollers.slices, kMaxSlices))}};
  }
  const scene::SystemOptions& system = prepared.options.system;
  return {{"ellipseMajor", std::to_string(std::min(2 * system.ellipse_major, kMaxMajor))},
          {"ellipseMinor", std::to_string(std::min(2 * system.ellipse_minor, kMaxMinor))}};
}

std::string errors_text(const results::AccuracyErrors& errors) {
  std::string out;
  const auto add = [&](const char* name, double error) {
    if (error >= 0.0)
      out += fmt::format("{}{} {:.2g} %", out.empty() ? "" : ", ", name, 100.0 * error);
  };
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    add(q.name, errors.*q.member);
  return out.empty() ? "nothing to compare" : out;
}

nlohmann::ordered_json verification_json(const Verification& verification,
                                         const runs::RunOutcome& outcome) {
  nlohmann::ordered_json out{{"against", verification.tighter},
                             {"processor_s", verification.seconds}};
  if (!verification.failure.empty()) {
    out["failure"] = verification.failure;
    return out;
  }
  out["errors"] = nlohmann::ordered_json::object();
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    if (verification.errors.*q.member >= 0.0) out["errors"][q.key] = verification.errors.*q.member;
  out["results"] = nlohmann::ordered_json::object();
  for (const results::KeyResult& here : outcome.summary) {
    const double there = results::value_of(verification.results, here.of.id);
    if (std::isfinite(here.value) && std::isfinite(there))
      out["results"][std::string(here.of.id)] = {{"run", here.value}, {"tighter", there}};
  }
  return out;
}

std::string verification_text(const Verification& verification, const runs::RunOutcome& outcome) {
  if (!verification.failure.empty())
    return fmt::format("verified:  no, because the run with {} failed: {}\n", verification.tighter,
                       verification.failure);
  std::string text =
      fmt::format("verified:  compared with {} ({:.3g} s of processor time): {}\n",
                  verification.tighter, verification.seconds, errors_text(verification.errors));
  for (const results::KeyResult& here : outcome.summary) {
    const double there = results::value_of(verification.results, here.of.id);
    if (!std::isfinite(here.value) || !std::isfinite(there) || here.value == there) continue;
    const std::string name = here.of.part.empty()
                                 ? std::string(here.of.label)
                                 : fmt::format("{}, {}", here.of.label, here.of.part);
    text += fmt::format("  {:<36} {:>14.7g} {:>14.7g} {}\n", name, here.value, there,
                        here.of.unit == nullptr ? "" : here.of.unit->si);
  }
  return text;
}

}  // namespace adore::studies
