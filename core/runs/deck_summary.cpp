#include "runs/deck_summary.hpp"

#include "base/counted.hpp"
#include "dynamics/race_contacts.hpp"
#include "listing/print_cage.hpp"
#include "listing/print_fits.hpp"
#include "listing/print_imperfections.hpp"
#include "listing/print_life.hpp"
#include "results/motion.hpp"
#include "runs/plan_json.hpp"
#include "runs/user_session.hpp"

#include <fmt/format.h>

namespace adore::runs {
namespace {

/// Meaning of the plot-file values of a motion, where the numbers do not show it.
nlohmann::ordered_json stored_json(const Prepared& prepared) {
  nlohmann::ordered_json out;
  out["steps between life predictions"] = prepared.control.life_every;  // 0: first and last only
  out["temperatures"] = prepared.bearing.thermal ? "computed" : "given";
  if (!prepared.bearing.cage) return out;
  const results::CageLengthScale scale = results::cage_length_scale(
      *prepared.bearing.cage,
      results::to_si(1.0, results::unit::kLength, prepared.input.deck.units()));
  out["cage orbit over"] = results::name_of(scale.of);
  out["cage orbit over [m]"] = scale.length;
  return out;
}

}  // namespace

results::RunSummary summary_of_deck(const Prepared& prepared, const scene::ScenePlan& plan,
                                    const std::string& request,
                                    const std::vector<Finding>& remarks) {
  results::RunSummary out;
  out.run_id = prepared.bearing.run_id;
  if (prepared.user) {
    std::string routines;
    for (const user::Use& use : prepared.user->uses())
      routines += fmt::format("{}{} ({})", routines.empty() ? "" : ", ", user::hook_name(use.hook),
                              counted(use.calls, "call"));
    out.options.emplace_back("--user", prepared.user->source());
    out.options.emplace_back("user version", program_version(prepared.user.get()));
    out.options.emplace_back("user routines", routines.empty() ? "none is active" : routines);
  }
  out.deck_file = prepared.input.path.filename().string();
  out.plan = plan_json(plan, prepared.stability);
  if (prepared.control.dynamic) out.stored = stored_json(prepared);
  out.stability = prepared.stability;
  out.request = request;
  for (const setup::OptionInfo& info : setup::run_option_list()) {
    const auto given = prepared.input.option_values.find(info.name);
    const bool set = given != prepared.input.option_values.end();
    // Default choices of the deck.
    std::string otherwise = info.default_value;
    if (info.name == "ellipseMajor")
      otherwise = fmt::format("{}", prepared.options.system.ellipse_major);
    if (info.name == "ellipseMinor")
      otherwise = fmt::format("{}", prepared.options.system.ellipse_minor);
    out.options.emplace_back(info.name, set ? given->second : otherwise);
  }
  out.defaults_used = deck::defaults_used(prepared.input.deck);
  out.no_part = prepared.no_part;
  out.findings = prepared.input.warnings;
  out.findings.insert(out.findings.end(), remarks.begin(), remarks.end());
  for (Finding& note : solution_notes(prepared)) out.findings.push_back(std::move(note));
  // Files of a run name no folder: a run gives the same bytes wherever it is.
  for (Finding& one : out.findings)
    if (one.file == prepared.input.path.string()) one.file = out.deck_file;
  out.instruction_set = dynamics::race_contact_instruction_set();
  const bearing::Imperfections& imperfections = prepared.bearing.imperfections;
  if (imperfections.elements == bearing::ElementErrorSource::Random)
    out.seeds.emplace_back("geometric imperfections", static_cast<long>(imperfections.seed));
  out.imperfections = listing::imperfections_json(prepared.bearing);
  if (prepared.bearing.operating) {
    out.operating = listing::fits_json(*prepared.bearing.operating);
    if (prepared.bearing.cage) out.operating["cage"] = listing::cage_json(prepared.bearing);
  }
  out.life["quasi-static"] = listing::life_json(prepared.life);
  return out;
}

}  // namespace adore::runs
