#include "runs/plan_json.hpp"

#include <nlohmann/json.hpp>

namespace adore::runs {

nlohmann::ordered_json plan_json(const scene::ScenePlan& plan, const std::string& stability) {
  nlohmann::ordered_json out;
  out["bodies"] = nlohmann::ordered_json::array();
  for (const scene::BodyEntry& body : plan.bodies)
    out["bodies"].push_back(
        {{"name", body.name}, {"degrees", body.degrees}, {"unknowns", body.unknowns}});
  out["effects"] = nlohmann::ordered_json::array();
  for (const scene::EffectEntry& effect : plan.effects)
    out["effects"].push_back(
        {{"name", effect.name}, {"on", effect.on}, {"because", effect.because}});
  out["unknowns"] = plan.unknowns;
  out["quadratures"] = plan.quadratures;
  if (plan.fastest_frequency > 0.0) {
    out["estimates"] = {{"fastest_frequency_Hz", plan.fastest_frequency},
                        {"fastest_contact", plan.fastest_contact}};
    if (plan.expected_step > 0.0) {  // `adore plan`; a run has taken its steps
      out["estimates"]["expected_step_s"] = plan.expected_step;
      out["estimates"]["steps_per_revolution"] = plan.steps_per_revolution;
      out["estimates"]["computing_s_per_revolution"] = plan.seconds_per_revolution;
    }
  }
  if (!stability.empty()) out["stability"] = stability;
  return out;
}

}  // namespace adore::runs
