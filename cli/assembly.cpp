#include "cli/assembly.hpp"

#include "assembly/assembly_file.hpp"
#include "assembly/assembly_report.hpp"
#include "assembly/run_assembly.hpp"
#include "base/counted.hpp"
#include "base/duration.hpp"
#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "cli/run_report.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "runs/output_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace adore::cli {
namespace {

void fill(const DeckOptions& options, assembly::AssemblyRequest& request) {
  runs::DeckRequest deck;
  options.fill(deck);
  if (!options.user.empty())
    throw InputError("--user: user routines are not available for assemblies; remove the option");
  request.folder = options.deck;
  request.sets = deck.sets;
  request.options = deck.options;
}

nlohmann::ordered_json summary_json(const assembly::AssemblyOutcome& outcome) {
  nlohmann::ordered_json out{{"status", outcome.untrusted.empty() ? "done" : "untrusted"},
                             {"folder", outcome.folder.string()}};
  if (!outcome.untrusted.empty()) out["message"] = outcome.untrusted;
  out["files"] = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : outcome.files) out["files"].push_back(file.string());
  out["computing_s"] = outcome.result.seconds;
  out["results"] = nlohmann::ordered_json::object();
  for (const auto& [of, value] : outcome.result.set)
    out["results"][std::string(of.id)] =
        std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json("infinite");
  out["assembly"] = assembly::result_json(outcome.result);
  out["findings"] = findings_json(outcome.result.findings);
  return out;
}

std::string text_of(const assembly::AssemblyOutcome& outcome) {
  std::string out;
  for (const std::string& line : assembly::result_lines(outcome.result)) out += line + "\n";
  out += fmt::format("quasi-static solution of the bearing set computed in {}\n",
                     duration_text(outcome.result.seconds));
  for (const std::filesystem::path& file : outcome.files) out += "  " + file.string() + "\n";
  return out;
}

}  // namespace

bool is_assembly_deck(const DeckOptions& options) {
  return options.deck != kStream && assembly::is_assembly(options.deck);
}

int run_assembly(const DeckOptions& options, const AssemblyRunOptions& run) {
  assembly::AssemblyRunRequest request;
  fill(options, request);
  if (!run.out.empty()) request.out = run.out;
  request.overwrite = run.overwrite;
  const InterruptWatch watch;
  const auto solve = [&]() -> assembly::AssemblyOutcome {
    try {
      return assembly::run_assembly(request, watch.token());
    } catch (const runs::ResultsExist& found) {
      if (!ask(fmt::format("{}\nReplace these files?", found.what())).value_or(false)) throw;
    }
    request.overwrite = true;
    return assembly::run_assembly(request, watch.token());
  };
  const assembly::AssemblyOutcome outcome = solve();
  print_warnings(outcome.result.findings);
  if (!outcome.untrusted.empty()) tell(fmt::format("adore: {}\n", outcome.untrusted));
  if (run.json)
    write_text("", "", dump_json(summary_json(outcome), 2) + "\n");
  else if (!run.quiet)
    write_text("", "", text_of(outcome));
  return outcome.untrusted.empty() ? 0 : 3;
}

int check_assembly(const DeckOptions& options, bool json) {
  assembly::AssemblyRequest request;
  fill(options, request);
  const InterruptWatch watch;
  const assembly::AssemblyCheck report = assembly::check_assembly(request, watch.token());
  if (json) {
    nlohmann::ordered_json out{{"file", report.file}, {"ok", report.ok()}};
    out["findings"] = findings_json(report.issues);
    print("{}\n", dump_json(out, 2));
    return report.ok() ? 0 : 2;
  }
  std::size_t errors = 0, others = 0;
  for (const Finding& issue : report.issues)
    if (issue.severity == Severity::Error) {
      print("{}\n", issue.text());
      ++errors;
    }
  for (const Finding& issue : shown_findings(report.issues)) {
    print("{}\n", issue.text());
    ++others;
  }
  print("{}: {}, {}, {}\n", report.file, counted(report.rows, "row"), counted(errors, "error"),
        counted(others, "warning or note", "warnings or notes"));
  return report.ok() ? 0 : 2;
}

void write_assembly(const NewAssemblyOptions& options, std::vector<assembly::RowDeckText> rows) {
  assembly::Assembly set = assembly::assembly_from_arrangement(options.arrangement);
  if (options.out.empty() || options.out == kStream)
    throw InputError("--assembly writes a folder; name it with --out FOLDER");
  if (rows.size() == 1) rows.resize(set.rows.size(), rows.front());
  if (rows.size() != set.rows.size())
    throw InputError(fmt::format("--assembly {}: {} for {}; give one deck, or one for each row",
                                 options.arrangement, counted(rows.size(), "deck"),
                                 counted(set.rows.size(), "row")));
  if (options.preload && options.offset)
    throw InputError("--preload and --offset exclude each other; give only one of them");
  if (options.preload) {
    set.preload.kind = assembly::PreloadKind::Force;
    set.preload.force = *options.preload;
  } else if (options.offset) {
    set.preload.kind = assembly::PreloadKind::Offset;
    set.preload.offset = 1e-6 * *options.offset;
  }
  set.load[0] = options.axial.value_or(0.0);
  set.load[2] = options.radial.value_or(0.0);
  // The reader's checks: what it refuses is not written.
  set = assembly::read_assembly(assembly::assembly_text(set), "--assembly");
  for (const std::filesystem::path& file : assembly::write_assembly(options.out, set, rows))
    tell(fmt::format("wrote {}\n", file.string()));
}

}  // namespace adore::cli
