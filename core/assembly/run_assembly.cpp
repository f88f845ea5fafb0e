#include "assembly/run_assembly.hpp"

#include "assembly/assembly_file.hpp"
#include "assembly/assembly_report.hpp"
#include "base/checksum.hpp"
#include "base/errors.hpp"
#include "base/write_folder.hpp"
#include "results/run_json.hpp"
#include "runs/check.hpp"
#include "runs/output_folder.hpp"
#include "runs/results_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace adore::assembly {
namespace {

namespace fs = std::filesystem;

std::string row_folder(std::size_t k) { return fmt::format("row-{}", k + 1); }

runs::RunRequest run_of_row(const AssemblyRunRequest& request, const AssemblyResult& result,
                            std::size_t k, const fs::path& out) {
  runs::RunRequest row;
  static_cast<runs::DeckRequest&>(row) = row_request(request, result.assembly, k);
  row.changes = result.rows[k].changes;
  row.out = out;
  row.below = row_folder(k);
  row.overwrite = request.overwrite;
  return row;
}

runs::Outputs outputs_of(const fs::path& folder, std::vector<fs::path> inputs) {
  return {folder, {"PRINT.txt", "RUN.json"}, std::move(inputs)};
}

/// Digest of the request: the assembly and the decks of its rows.
std::string digest(const std::vector<runs::RunRequest>& rows, const Assembly& assembly) {
  std::string text = assembly_text(assembly);
  for (const runs::RunRequest& row : rows)
    text += runs::request_digest(row, runs::load_deck(row)) + "\n";
  return fmt::format("{:016x}", checksum(text));
}

results::RunSummary summary_of(const AssemblyResult& result, const std::string& request,
                               const std::string& untrusted) {
  results::RunSummary out;
  out.run_id = result.assembly.name;
  out.deck_file = kFileName;
  out.request = request;
  out.status = untrusted.empty() ? "done" : "untrusted";
  out.message = untrusted;
  out.plan = nlohmann::ordered_json::object();
  out.findings = result.findings;
  // Files of a run name no folder: a run gives the same bytes wherever it is.
  for (Finding& one : out.findings) one.file = fs::path(one.file).filename().string();
  out.summary = result.set;
  out.quasi_static = results::to_json(result_tables(result));
  out.life = nlohmann::ordered_json();
  return out;
}

bool has_error(const std::vector<Finding>& issues) {
  return std::any_of(issues.begin(), issues.end(),
                     [](const Finding& one) { return one.severity == Severity::Error; });
}

/// Findings of the equilibrium: the set has them.
bool is_of_equilibrium(const Finding& one) {
  const FindingKind* kind = find_finding_kind(one.code);
  return one.severity != Severity::Error && (kind == nullptr || kind->origin != "check");
}

/// @param solved false: the displacement of the row is not known, and only errors are added
void add_prefixed(AssemblyCheck& out, std::vector<Finding> findings, std::size_t k, bool solved) {
  for (Finding& one : findings) {
    if (is_of_equilibrium(one) || (!solved && one.severity != Severity::Error)) continue;
    one.message = fmt::format("row {}: {}", k + 1, one.message);
    out.issues.push_back(std::move(one));
  }
}

}  // namespace

AssemblyOutcome run_assembly(const AssemblyRunRequest& request, std::stop_token stop) {
  AssemblyOutcome out;
  out.result = solve_assembly(request, stop);
  const fs::path source = assembly_folder(request.folder);
  out.folder = request.out ? *request.out : source;
  std::vector<runs::RunRequest> rows;
  std::vector<fs::path> inputs{source / kFileName};
  for (std::size_t k = 0; k < out.result.rows.size(); ++k) {
    rows.push_back(run_of_row(request, out.result, k, out.folder));
    inputs.push_back(runs::deck_path(rows.back().deck));
  }
  runs::check_room(outputs_of(out.folder, inputs), request.overwrite);
  for (std::size_t k = 0; k < rows.size(); ++k)
    runs::check_room(outputs_of(out.folder / row_folder(k), inputs), request.overwrite);
  const runs::ResultsFolder made(out.folder);
  const runs::FolderLock lock(made.folder());
  const fs::path away = runs::make_room(outputs_of(out.folder, inputs), made.folder());
  if (!away.empty())
    out.result.findings.push_back(make_finding(
        "run.moved_results",
        fmt::format("older result files that this run does not replace were moved to {}",
                    away.string())));
  for (const runs::RunRequest& row : rows) {
    const runs::RunOutcome done = runs::run(row, {}, stop);
    out.files.insert(out.files.end(), done.files.begin(), done.files.end());
    if (done.status == runs::RunStatus::Untrusted && out.untrusted.empty())
      out.untrusted = fmt::format("{}: {}", row.below.string(), done.message);
  }
  results::RunSummary run =
      summary_of(out.result, digest(rows, out.result.assembly), out.untrusted);
  for (const char* name : {"PRINT.txt", "RUN.json"}) {
    run.files.emplace_back(name);
    out.files.push_back(out.folder / name);
  }
  write_file_atomically(WritePath(made.folder(), "PRINT.txt"), assembly_listing(out.result));
  run.sums.push_back(results::file_checksum(out.folder / "PRINT.txt"));
  results::write_run_json(run, WritePath(made.folder(), "RUN.json"));
  nlohmann::ordered_json members;
  members["assembly"] = result_json(out.result);
  results::amend_run(made.folder(), members, "");
  return out;
}

bool AssemblyCheck::ok() const { return !has_error(issues); }

AssemblyCheck check_assembly(const AssemblyRequest& request, std::stop_token stop) {
  AssemblyCheck out;
  out.file = (assembly_folder(request.folder) / kFileName).string();
  const auto add_errors = [&](const InputError& error) {
    for (Finding& one : findings_of(error.issues())) out.issues.push_back(std::move(one));
  };
  Assembly assembly;
  try {
    assembly = read_assembly_file(request.folder);
  } catch (const InputError& error) {
    add_errors(error);
    return out;
  }
  out.rows = assembly.rows.size();
  std::optional<AssemblyResult> solved;
  std::vector<Finding> failure;
  try {
    solved = solve_assembly(request, stop);
  } catch (const InputError& error) {
    failure = findings_of(error.issues());
  } catch (const SolverError& error) {
    failure.push_back(make_finding("deck.error", error.what()));
    failure.back().file = out.file;
  }
  for (std::size_t k = 0; k < assembly.rows.size(); ++k) try {
      runs::DeckRequest row = row_request(request, assembly, k);
      const deck::Deck deck = runs::load_deck(row).deck;
      check_row_deck(deck, k);
      const auto held = solved ? solved->rows[k].changes
                               : prescribed_displacement_sets(Vec5::Zero(), deck.units());
      row.sets.insert(row.sets.end(), held.begin(), held.end());
      add_prefixed(out, runs::check(row, stop).issues, k, solved.has_value());
    } catch (const InputError& error) {
      add_errors(error);
    }
  if (!out.ok()) return out;  // errors of a row explain the failure
  std::set<std::string> said;
  for (const Finding& one : out.issues) said.insert(one.text());
  for (Finding& one : solved ? solved->findings : failure)
    if (said.insert(one.text()).second) out.issues.push_back(std::move(one));
  return out;
}

}  // namespace adore::assembly
