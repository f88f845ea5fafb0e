#include "facade/rehearsal.hpp"

#include "base/interrupted.hpp"
#include "deck/unit_text.hpp"
#include "facade/output_folder.hpp"
#include "facade/ready_run.hpp"

#include <exception>
#include <filesystem>
#include <utility>

namespace adore::facade {
namespace fs = std::filesystem;
namespace {

/// If no file is in the way.
constexpr const char* kNowhere = "/nonexistent";

/// @param folder of the run's files; empty: none is looked at
std::vector<Finding> begin_run(LoadedDeck input, const fs::path& folder) {
  RunRequest request;
  request.overwrite = true;  // whoever starts the run is asked
  if (!folder.empty()) check_writable(folder);
  Prepared prepared = prepare(std::move(input));
  if (prepared.control.dynamic) {
    if (folder.empty()) prepared.control.start = setup::StartState::Statics;
    const ReadyRun ready(request, prepared, RunPlace(folder.empty() ? fs::path(kNowhere) : folder));
  }
  for (Finding& note : solution_notes(prepared)) prepared.input.warnings.push_back(std::move(note));
  return std::move(prepared.input.warnings);
}

std::vector<Issue> sentence(const std::string& message) {
  Issue issue;
  issue.message = message;
  return {issue};
}

Rehearsal rehearse_in(LoadedDeck input, const fs::path& folder) {
  const std::string file = input.path.string();
  const deck::UnitSystem units = input.deck.units();
  Rehearsal out;
  try {
    out.remarks = begin_run(std::move(input), folder);
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

Rehearsal rehearse(LoadedDeck input) { return rehearse_in(std::move(input), {}); }

Rehearsal rehearse_run(LoadedDeck input) {
  fs::path folder;
  if (input.path.empty()) {
    input.path = "new deck";
  } else {
    folder = input.path.parent_path();
    if (folder.empty()) folder = ".";
  }
  return rehearse_in(std::move(input), folder);
}

std::vector<Issue> refusals_of_run(LoadedDeck input) {
  return rehearse_run(std::move(input)).refusals;
}

}  // namespace adore::facade
