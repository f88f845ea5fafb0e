#include "runs/rehearsal.hpp"

#include "base/interrupted.hpp"
#include "deck/unit_text.hpp"
#include "runs/law_ranges.hpp"
#include "runs/output_folder.hpp"
#include "runs/ready_run.hpp"
#include "runs/unused_request.hpp"
#include "runs/user_session.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <utility>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

/// If no file is in the way.
constexpr const char* kNowhere = "/nonexistent";

bool has_code(const std::vector<Finding>& findings, const std::string& code) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Finding& one) { return one.code == code; });
}

/// Of a motion: of its start state, and laws that it takes outside their range of validity.
std::vector<Finding> findings_of_start(const RunRequest& request, Prepared& prepared,
                                       const fs::path& folder) {
  if (folder.empty()) prepared.control.start = setup::StartState::Statics;
  ReadyRun ready(request, prepared, RunPlace(folder.empty() ? fs::path(kNowhere) : folder));
  std::vector<Finding> out = ready.outputs->remarks();
  LawValidityMonitor ranges(prepared.bearing);
  ranges.check(ready.system->snapshot(ready.start.time, ready.start.y));
  for (const validity::Finding& one :
       without(ranges.findings(), {"hertz.shoulder", "hertz.yield", "cage.yield"}))
    out.push_back(finding_of_range(one));
  if (auto one = ranges.friction_coefficient_finding()) out.push_back(std::move(*one));
  return out;
}

std::vector<Issue> sentence(const std::string& message) {
  Issue issue;
  issue.message = message;
  return {issue};
}

DryRunResult rehearse_in(LoadedDeck input, const fs::path& folder) {
  const std::string file = input.path.string();
  const deck::UnitSystem units = input.deck.units();
  DryRunResult out;
  try {
    RunRequest request;
    request.overwrite = true;  // whoever starts the run is asked
    if (!folder.empty()) check_writable(folder);
    Prepared prepared = prepare(std::move(input));
    out.remarks = findings_before_first_step(request, prepared, folder);
  } catch (const Interrupted&) {
    throw;
  } catch (const InputError& error) {
    out.refusals = error.issues().empty() ? sentence(error.what()) : error.issues();
  } catch (const std::exception& error) {
    out.refusals = sentence(error.what());
  }
  std::erase_if(out.refusals, [](const Issue& issue) { return issue.severity != Severity::Error; });
  const auto complete = [&](Issue& issue) {
    if (issue.file.empty()) issue.file = file;
    issue.message = deck::message_in_units(issue.message, units);
    issue.remedy = deck::message_in_units(issue.remedy, units);
  };
  for (Issue& issue : out.refusals) complete(issue);
  for (Finding& finding : out.remarks) complete(finding);
  return out;
}

}  // namespace

std::vector<Finding> findings_before_first_step(const RunRequest& request, Prepared& prepared,
                                                const fs::path& folder) {
  for (Issue& note : unused_request(request, prepared)) add_remark(prepared, std::move(note));
  std::vector<Finding> of_start;
  try {
    if (prepared.control.dynamic) of_start = findings_of_start(request, prepared, folder);
  } catch (const SolverError& error) {
    throw_start_failure(prepared, error);
  }
  std::vector<Finding> out = prepared.input.warnings;
  for (Finding& note : solution_notes(prepared)) out.push_back(std::move(note));
  for (Finding& one : of_start)  // once where the statics have it, too
    if (one.code.starts_with("run.") || !has_code(out, one.code)) out.push_back(std::move(one));
  return out;
}

DryRunResult dry_run_without_files(LoadedDeck input) { return rehearse_in(std::move(input), {}); }

DryRunResult dry_run_with_files(LoadedDeck input) {
  fs::path folder;
  if (input.path.empty()) {
    input.path = "new deck";
  } else {
    folder = input.path.parent_path();
    if (folder.empty()) folder = ".";
  }
  return rehearse_in(std::move(input), folder);
}

std::vector<Issue> dry_run_errors(LoadedDeck input) {
  return dry_run_with_files(std::move(input)).refusals;
}

}  // namespace adore::runs
