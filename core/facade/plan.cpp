#include "facade/plan.hpp"

#include "facade/disk_use.hpp"
#include "facade/plan_json.hpp"
#include "facade/prepare.hpp"

#include <utility>

namespace adore::facade {

PlanReport plan(const DeckRequest& request, std::stop_token stop) {
  const Prepared prepared = prepare(request, std::move(stop));
  const scene::ScenePlan scene = plan_with_estimates(prepared);
  const DiskUse disk = disk_use(prepared, scene);
  PlanReport out;
  out.text = plan_text(prepared, scene) + disk_use_text(disk);
  out.json = plan_json(scene, stability_text(prepared));
  out.json["disk"] = disk_use_json(disk);
  out.remarks = prepared.input.warnings;
  for (Finding& note : solution_notes(prepared)) out.remarks.push_back(std::move(note));
  out.json["findings"] = findings_json(out.remarks);
  return out;
}

}  // namespace adore::facade
