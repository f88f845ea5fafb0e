#include "cli/run_report.hpp"

#include "base/counted.hpp"
#include "base/duration.hpp"
#include "base/own_files.hpp"
#include "cli/picture_program.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

namespace adore::cli {
namespace {

/// The commands that draw the run's files, one a line.
std::string picture_lines(const runs::RunOutcome& outcome) {
  std::string plots, animation, motion, table;
  for (const std::filesystem::path& file : outcome.files) {
    const AdoreFileType sort = read_file_type(file);
    const std::string name = " " + quoted_path(file);
    if (sort == AdoreFileType::Plot) plots += name;
    if (sort == AdoreFileType::Animation) animation = name;
    if (sort == AdoreFileType::ResultsH5) motion = name;
    if (sort == AdoreFileType::RunJson) table = name;
  }
  if (!outcome.results.empty()) plots = table;  // the tables of a quasi-static run
  // Without SOL8 the same from there.
  if (animation.empty() && outcome.results.empty()) animation = motion;
  if (plots.empty() && animation.empty()) return {};
  const std::string out = quoted_path(outcome.folder / "pictures");
  if (!has_pictures())
    return fmt::format("numbers:   adore convert{} --to csv (this build cannot draw pictures)\n",
                       plots.empty() ? animation : plots.substr(0, plots.find(' ', 1)));
  std::string text;
  if (!plots.empty()) text += fmt::format("pictures:  adore plot{} --out {}\n", plots, out);
  if (!animation.empty())
    text += fmt::format("{}adore animate{} --out {}\n",
                        plots.empty() ? "pictures:  " : "           ", animation, out);
  return text;
}

std::string status_name(runs::RunStatus status) {
  return status == runs::RunStatus::Done          ? "done"
         : status == runs::RunStatus::Interrupted ? "interrupted"
         : status == runs::RunStatus::Untrusted   ? "untrusted"
                                                  : "failed";
}

double find_result(const runs::RunOutcome& outcome, std::string_view id) {
  for (const auto& [of, value] : outcome.summary)
    if (of.id == id) return value;
  return std::nan("");
}

/// Lives by the standards at the loads of the quasi-static solution, and passing frequencies of the
/// motion; a quasi-static run has them among its lines.
std::string standard_text(const runs::RunOutcome& outcome) {
  std::string text;
  const double iso = find_result(outcome, "life_iso281_hours"),
               contacts = find_result(outcome, "life_iso16281_hours");
  const auto hours = [](double value) {
    return std::isinf(value) ? std::string("infinite") : fmt::format("{:.4g} h", value);
  };
  if (!std::isnan(iso)) text += fmt::format("life L10h by ISO 281: {}", hours(iso));
  if (!std::isnan(contacts))
    text +=
        fmt::format("{}L10r by ISO/TS 16281: {}", text.empty() ? "life " : "; ", hours(contacts));
  if (!text.empty()) text += " (loads of the quasi-static solution)\n";
  for (const std::string kind : {"_nominal", ""}) {
    const auto f = [&](const char* name) { return find_result(outcome, name + kind + "_Hz"); };
    if (std::isnan(f("bpfo"))) continue;
    text += fmt::format("passing frequencies, {}: BPFO {:.5g}, BPFI {:.5g}, FTF {:.5g} Hz\n",
                        kind.empty() ? "computed" : "nominal", f("bpfo"), f("bpfi"),
                        std::abs(f("ftf")));
  }
  return text;
}

/// Life of a run with its samples and spread; empty without one.
std::string run_life_text(const runs::RunOutcome& outcome) {
  const auto find = [&](std::string_view id) { return find_result(outcome, id); };
  const double life = find("run_life_hours"), spread = find("run_life_spread");
  if (std::isnan(life)) return {};
  return fmt::format("fatigue life at the loads of the run: {} ({}{})\n",
                     std::isinf(life) ? "infinite" : fmt::format("{:.4g} h", life),
                     counted(static_cast<long>(find("run_life_samples")), "evaluated step"),
                     std::isnan(spread) ? "; standard error not computed: the run is too short"
                                        : fmt::format(", standard error {:.2g} %", 100.0 * spread));
}

}  // namespace

std::string quoted(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("+,-./:=@_%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string quoted_path(const std::filesystem::path& path) {
  const std::string word = path.string();
  return quoted(word.starts_with('-') ? "./" + word : word);
}

std::string doubled_length(const runs::RunOutcome& outcome) {
  const double turns = std::abs(outcome.revolutions);
  return turns > 0.0 && !outcome.speeds_vary ? fmt::format("{:.4g}rev", 2.0 * turns)
                                             : fmt::format("{:.4g}s", 2.0 * outcome.time);
}

std::string summary_text(const runs::RunOutcome& outcome, const std::string& continuation) {
  std::string text;
  for (const std::string& line : outcome.results) text += line + "\n";
  if (!outcome.results.empty())
    text += fmt::format("quasi-static solution computed in {}\n", duration_text(outcome.seconds));
  else
    text += fmt::format("{}, {}, t = {:.6g} s, computed in {}\n", counted(outcome.steps, "step"),
                        counted(fmt::format("{:.4g}", outcome.revolutions), "revolution"),
                        outcome.time, duration_text(outcome.seconds));
  if (outcome.missed_end > 0.0)
    text += fmt::format(
        "the run stopped after maxStps steps, before its end time t = {:.6g} s (fTime)\n",
        outcome.missed_end);
  if (outcome.energy_scale > 0.0)
    text +=
        fmt::format("energy residual: {:.3g} J, {:.2g} times the exchanged energy of {:.3g} J\n",
                    outcome.energy_residual, outcome.energy_residual / outcome.energy_scale,
                    outcome.energy_scale);
  text += run_life_text(outcome);
  if (outcome.results.empty()) text += standard_text(outcome);
  for (const std::filesystem::path& file : outcome.files) text += "  " + file.string() + "\n";
  text += picture_lines(outcome);
  if (outcome.results.empty() && !continuation.empty())
    text += fmt::format("continue:  {}\n", continuation);
  return text;
}

std::string sweep_text(const studies::SweepOutcome& outcome, const std::string& again) {
  const std::string table = quoted_path(outcome.table);
  std::string text = outcome.table.string() + "\n";
  if (has_pictures())
    text += fmt::format("pictures:  adore plot {} --out {}\n", table,
                        quoted_path(outcome.table.parent_path() / "pictures"));
  if (outcome.failed > 0 && !again.empty())
    text += fmt::format("repeat:    {} no result; run {} again with\n           {}\n",
                        counted(outcome.failed, "run has", "runs have"),
                        outcome.failed == 1 ? "it" : "them", again);
  return text;
}

nlohmann::ordered_json summary_json(const runs::RunOutcome& outcome) {
  nlohmann::ordered_json out{{"status", status_name(outcome.status)}};
  if (!outcome.message.empty()) out["message"] = outcome.message;
  out["folder"] = outcome.folder.string();
  out["files"] = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : outcome.files) out["files"].push_back(file.string());
  out["steps"] = outcome.steps;
  out["time_s"] = outcome.time;
  out["revolutions"] = outcome.revolutions;
  out["computing_s"] = outcome.seconds;
  if (outcome.energy_scale > 0.0)
    out["energy"] = {{"residual_J", outcome.energy_residual}, {"moved_J", outcome.energy_scale}};
  nlohmann::ordered_json results = nlohmann::ordered_json::object();
  for (const auto& [of, value] : outcome.summary)
    results[std::string(of.id)] =
        std::isfinite(value)
            ? nlohmann::ordered_json(value)
            : nlohmann::ordered_json(std::isinf(value) ? "infinite" : "not computed");
  out["results"] = results;
  out["remarks"] = nlohmann::ordered_json::array();
  for (const Finding& one : shown_findings(outcome.warnings)) out["remarks"].push_back(one.text());
  out["findings"] = findings_json(outcome.warnings);
  return out;
}

nlohmann::ordered_json summary_json(const studies::SweepOutcome& outcome) {
  nlohmann::ordered_json out{
      {"table", outcome.table.string()}, {"exit", outcome.exit_code}, {"failed", outcome.failed}};
  out["remarks"] = nlohmann::ordered_json::array();
  for (const Finding& one : shown_findings(outcome.warnings)) out["remarks"].push_back(one.text());
  out["findings"] = findings_json(outcome.warnings);
  return out;
}

int exit_code(const runs::RunOutcome& outcome) {
  return outcome.status == runs::RunStatus::Done          ? 0
         : outcome.status == runs::RunStatus::Interrupted ? 130
                                                          : 3;
}

}  // namespace adore::cli
