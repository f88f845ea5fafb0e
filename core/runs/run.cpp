#include "runs/run.hpp"

#include "base/checksum.hpp"
#include "base/input_file.hpp"
#include "base/write_error.hpp"
#include "dynamics/race_contacts.hpp"
#include "runs/film_precision.hpp"
#include "runs/law_ranges.hpp"
#include "runs/output_folder.hpp"
#include "runs/progress_meter.hpp"
#include "runs/results_folder.hpp"
#include "runs/run_outputs.hpp"
#include "runs/simulate.hpp"
#include "runs/solver_stamp.hpp"
#include "runs/unused_request.hpp"
#include "runs/user_session.hpp"
#include "scene/cost_ledger.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The request's overrides of the deck's run control.
void apply_overrides(const RunRequest& request, Prepared& prepared) {
  if (!request.integrator.empty()) {
    try {
      prepared.control.integrator = integrators::make_stepper(request.integrator)->name();
    } catch (const std::invalid_argument& error) {
      throw InputError(error.what());
    }
  }
  if (request.tolerance) {
    if (!(*request.tolerance > 0.0 && *request.tolerance < 1.0))
      throw InputError(fmt::format(
          "--tol {}: the tolerance (local error limit) must be between 0 and 1, e.g. 1e-6",
          *request.tolerance));
    prepared.control.tolerance = *request.tolerance;
    for (bearing::Bearing* one : {&prepared.as_built, &prepared.bearing})
      if (one->lubrication) one->lubrication->tolerance = *request.tolerance;
  }
  choose_film_precision(prepared);
}

RunOutcome run_quasi_static(const RunRequest& request, const Prepared& prepared,
                            const WriteFolder& folder) {
  if (request.go_on)
    throw InputError(
        fmt::format("--continue: the deck {} is quasi-static, so there is nothing to continue; "
                    "remove --continue",
                    prepared.input.path.string()));
  RunOutcome out;
  RunOutputs outputs(prepared, folder, request_digest(request, prepared.input), request.overwrite);
  out.results = outputs.write_quasi_static();
  if (std::string why = untrusted(prepared.left_ranges); !why.empty()) {
    out.status = RunStatus::Untrusted;
    out.message = std::move(why);
  }
  out.files = outputs.files();
  out.summary = outputs.summary();
  out.warnings = outputs.remarks();
  return out;
}

/// How to continue after a write error.
std::string continuation_hint(const fs::path& master) {
  std::error_code error;
  return fs::exists(master, error)
             ? "the files are valid up to their last complete step: continue the run with "
               "--continue"
             : "the run did not reach its first checkpoint: start the run again with --overwrite";
}

RunOutcome run_dynamic(const RunRequest& request, Prepared& prepared, const WriteFolder& folder,
                       const ProgressSink& progress, std::stop_token stop) {
  try {
    return simulate(request, prepared, folder, progress, stop);
  } catch (const WriteError& error) {
    throw InputError(fmt::format("{}; {}", error.what(),
                                 continuation_hint(folder.path() / prepared.control.master_file)));
  } catch (const SolverError& error) {  // before the first step
    throw_start_failure(prepared, error);
  }
}

}  // namespace

fs::path output_folder(const RunRequest& request, const fs::path& deck) {
  const fs::path folder = request.out ? *request.out : deck.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

std::string request_digest(const RunRequest& request, const LoadedDeck& deck) {
  std::string text = fmt::format("{}\n{}\n", solver_stamp(), deck::write_deck(deck.deck));
  for (const auto& [name, value] : deck.option_values) text += fmt::format("{}={}\n", name, value);
  if (!deck.user.empty())
    text += fmt::format("user={}\n{}\n", deck.user.string(), read_text_file(deck.user));
  text += fmt::format("{}\n{}\n", request.until, request.integrator);
  if (request.tolerance) text += fmt::format("{}\n", *request.tolerance);
  return fmt::format("{:016x}", checksum(text));
}

RunOutcome run(const RunRequest& request, const ProgressSink& progress, std::stop_token stop) {
  const auto begin = Clock::now();
  const double processor = scene::processor_seconds();
  dynamics::check_instruction_set_request();
  LoadedDeck input = load_deck(request);
  input.stop = stop;
  if (progress) input.table_progress = table_meter(progress);
  if (input.deck.integer("kStif") > 0 && !request.go_on && input.deck.integer("kIcOpt") != 1) {
    // The table may take minutes: an occupied folder is rejected before.
    check_room({output_folder(request, input.path) / request.below, {"PRINT.txt"}, {input.path}},
               request.overwrite);
  }
  Prepared prepared = prepare(std::move(input));
  apply_overrides(request, prepared);
  if (!request.settings_note.empty())
    add_remark(prepared, make_finding("run.settings", request.settings_note));
  for (Issue& note : unused_request(request, prepared)) add_remark(prepared, std::move(note));
  const ResultsFolder made(output_folder(request, prepared.input.path), request.below);
  const FolderLock lock(made.folder());
  RunOutcome out = prepared.control.dynamic
                       ? run_dynamic(request, prepared, made.folder(), progress, stop)
                       : run_quasi_static(request, prepared, made.folder());
  out.folder = made.path();
  std::vector<Finding> remarks = std::move(out.warnings);
  out.warnings = prepared.input.warnings;
  for (Finding& issue : solution_notes(prepared)) out.warnings.push_back(std::move(issue));
  for (Finding& issue : remarks) out.warnings.push_back(std::move(issue));
  if (out.status == RunStatus::Untrusted || out.status == RunStatus::Failed)
    out.warnings.insert(
        out.warnings.begin(),
        make_finding(out.status == RunStatus::Failed ? "end.failed" : "end.untrusted",
                     out.message));
  out.seconds = seconds_since(begin);
  out.processor_seconds = scene::processor_seconds() - processor;
  return out;
}

}  // namespace adore::runs
