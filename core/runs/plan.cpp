#include "runs/plan.hpp"

#include "base/counted.hpp"
#include "base/duration.hpp"
#include "runs/disk_use.hpp"
#include "runs/plan_json.hpp"
#include "runs/prepare.hpp"
#include "runs/rehearsal.hpp"
#include "runs/run_cost.hpp"
#include "runs/run_span.hpp"

#include <fmt/format.h>

#include <utility>

namespace adore::runs {
namespace {

std::string cost_text(const RunCost& cost) {
  if (!(cost.seconds > 0.0))
    return fmt::format("\nprocessor time of the whole run\n  not measured: {}\n", cost.failure);
  const std::string pilot =
      cost.whole ? "the pilot run simulated the whole run"
                 : fmt::format("estimated from a pilot run of {}",
                               cost.pilot_turns > 0.0
                                   ? counted(fmt::format("{:.3g}", cost.pilot_turns), "revolution")
                                   : fmt::format("{:.3g} s", cost.pilot_time));
  return fmt::format(
      "\nprocessor time of the whole run\n  about {} including set-up, output and files; {}\n",
      cost.seconds < 10.0 ? fmt::format("{:.2g} s", cost.seconds) : duration_text(cost.seconds),
      pilot);
}

}  // namespace

PlanReport plan_of_run(const RunRequest& request, double pilot, double start,
                       std::stop_token stop) {
  // First of all: a run meets tables that nobody has read before, too.
  RunCost cost;
  if (pilot > 0.0) cost = run_cost(request, pilot, stop);
  Prepared prepared = prepare(request, std::move(stop));
  if (!request.until.empty() && prepared.control.dynamic) {
    const double scale = make_system(prepared).scales().time;
    const RunSpan span = run_span(request, prepared, scale);
    prepared.control.end_time = span.end / scale;
    prepared.control.max_steps = span.max_steps;
  }
  const scene::ScenePlan scene = plan_with_estimates(prepared);
  const DiskUse disk = disk_use(prepared, scene);
  PlanReport out;
  out.text = plan_text(prepared, scene) + disk_use_text(disk);
  out.json = plan_json(scene, step_stability_text(prepared));
  out.json["disk"] = disk_use_json(disk);
  RunRequest beginning = request;
  beginning.go_on = false;
  beginning.overwrite = true;
  out.remarks = findings_before_first_step(beginning, prepared);
  out.json["findings"] = findings_json(out.remarks);
  if (!(pilot > 0.0)) return out;
  if (cost.seconds > 0.0) cost.seconds += start;
  out.text += cost_text(cost);
  out.json["run_cost"] = {{"pilot_revolutions", cost.pilot_turns}, {"whole", cost.whole}};
  if (cost.seconds > 0.0) out.json["run_cost"]["processor_s"] = cost.seconds;
  if (!cost.failure.empty()) out.json["run_cost"]["failure"] = cost.failure;
  return out;
}

PlanReport plan(const DeckRequest& request, std::stop_token stop) {
  RunRequest run;
  static_cast<DeckRequest&>(run) = request;
  return plan_of_run(run, 0.0, 0.0, std::move(stop));
}

}  // namespace adore::runs
