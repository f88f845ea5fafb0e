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

/// Of a deck without a name: no folder, where no file is in the way.
constexpr const char* kNowhere = "/nonexistent";

void begin_run(LoadedDeck input) {
  RunRequest request;
  request.overwrite = true;  // whoever starts the run is asked
  const bool named = !input.path.empty();
  fs::path folder = named ? input.path.parent_path() : fs::path(kNowhere);
  if (folder.empty()) folder = ".";
  if (named) check_writable(folder);
  if (!named) input.path = "new deck";
  Prepared prepared = prepare(std::move(input));
  if (!prepared.control.dynamic) return;
  if (!named) prepared.control.start = setup::StartState::Statics;
  const ReadyRun ready(request, prepared, folder);
}

std::vector<Issue> sentence(const std::string& message) {
  Issue issue;
  issue.message = message;
  return {issue};
}

}  // namespace

std::vector<Issue> refusals_of_run(LoadedDeck input) {
  const std::string file = input.path.string();
  const deck::UnitSystem units = input.deck.units();
  std::vector<Issue> out;
  try {
    begin_run(std::move(input));
  } catch (const Interrupted&) {
    throw;
  } catch (const InputError& error) {
    out = error.issues().empty() ? sentence(error.what()) : error.issues();
  } catch (const std::exception& error) {
    out = sentence(error.what());
  }
  std::erase_if(out, [](const Issue& issue) { return issue.severity != Severity::Error; });
  for (Issue& issue : out) {
    if (issue.file.empty()) issue.file = file;
    issue.message = deck::message_in_units(issue.message, units);
    issue.remedy = deck::message_in_units(issue.remedy, units);
  }
  return out;
}

}  // namespace adore::facade
