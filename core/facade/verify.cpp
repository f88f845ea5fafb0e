#include "facade/verify.hpp"

#include "facade/prepare.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace adore::facade {

Verification verify(const RunRequest& request, const RunOutcome& outcome, std::stop_token stop) {
  const Prepared prepared = prepare(request);
  RunRequest tight = request;
  tight.go_on = false;
  // The end that was reached, whatever decided it.
  tight.until = fmt::format("{:.17g}s", outcome.time);
  const double tolerance = 0.1 * request.tolerance.value_or(prepared.control.tolerance);
  tight.tolerance = tolerance;
  const double scale = make_system(prepared).scales().time;
  const double longest = 0.5 * outcome.longest_step / scale;
  tight.set_again("stpMax", fmt::format("{:.6g}", longest));
  if (prepared.control.step_minimum > longest ||
      prepared.control.step_minimum == prepared.control.step_maximum)
    tight.set_again("stpMin", fmt::format("{:.6g}", longest));
  // Stored at the same times, as nearly as steps allow.
  const int every = std::max(1, prepared.control.substeps);
  tight.set_again("nStps", std::to_string(2 * every));
  if (prepared.control.start == setup::StartState::Continue) tight.set_again("kIcOpt", "0");
  Verification out;
  out.tighter = fmt::format("tol {:g}, steps at most {:.3g} s", tolerance, longest * scale);
  const MeasuredRun run =
      measured_run(tight, std::numeric_limits<double>::infinity(), std::move(stop));
  out.seconds = run.seconds;
  out.results = run.outcome.summary;
  if (run.outcome.status == RunStatus::Failed || run.outcome.status == RunStatus::Interrupted)
    out.failure = run.outcome.message;
  else
    out.errors = compare_results(outcome.summary, run.outcome.summary);
  return out;
}

std::string errors_text(const AccuracyErrors& errors) {
  std::string out;
  const auto add = [&](const char* name, double error) {
    if (error >= 0.0)
      out += fmt::format("{}{} {:.2g} %", out.empty() ? "" : ", ", name, 100.0 * error);
  };
  add("speeds", errors.speed);
  add("loads", errors.load);
  add("heat", errors.heat);
  add("life", errors.life);
  return out.empty() ? "nothing to compare" : out;
}

std::string verification_text(const Verification& verification, const RunOutcome& outcome) {
  if (!verification.failure.empty())
    return fmt::format("verified:  not at all; the run with {} gave up: {}\n", verification.tighter,
                       verification.failure);
  std::string text =
      fmt::format("verified:  against {} ({:.3g} s of processor time): {}\n", verification.tighter,
                  verification.seconds, errors_text(verification.errors));
  for (const results::KeyResult& here : outcome.summary) {
    const double there = value_of(verification.results, here.of.id);
    if (!std::isfinite(here.value) || !std::isfinite(there) || here.value == there) continue;
    const std::string name = here.of.part.empty()
                                 ? std::string(here.of.label)
                                 : fmt::format("{}, {}", here.of.label, here.of.part);
    text += fmt::format("  {:<36} {:>14.7g} {:>14.7g} {}\n", name, here.value, there,
                        here.of.unit == nullptr ? "" : here.of.unit->si);
  }
  return text;
}

}  // namespace adore::facade
