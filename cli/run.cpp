#include "facade/run.hpp"

#include "base/duration.hpp"
#include "build/run_control.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/option_ranges.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "facade/output_folder.hpp"
#include "facade/sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <unistd.h>

namespace adore::cli {
namespace {

std::string progress_line(const facade::Progress& p) {
  if (p.runs > 0)
    return fmt::format("{:3.0f}%  run {} of {}  ETA {}", 100.0 * p.fraction, p.step, p.runs,
                       duration_text(p.remaining));
  return fmt::format(
      "{:3.0f}%  {:.3f} rev  t = {:.4e} of {:.4e} s  step {}  {:.3g}x real time  ETA {}",
      100.0 * p.fraction, p.revolutions, p.time, p.end_time, p.step, p.speed_up,
      duration_text(p.remaining));
}

facade::ProgressSink make_sink(const std::string& style) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  if (style == "none") return {};
  if (style == "json")
    return [](const facade::Progress& p) {
      const nlohmann::ordered_json line{{"fraction", p.fraction},   {"revolutions", p.revolutions},
                                        {"time", p.time},           {"end_time", p.end_time},
                                        {"step", p.step},           {"elapsed", p.elapsed},
                                        {"remaining", p.remaining}, {"speed_up", p.speed_up}};
      tell(line.dump() + "\n", false);
    };
  if (style == "auto" && terminal)
    return [](const facade::Progress& p) {
      tell(fmt::format("\r\033[K{}{}", progress_line(p), p.fraction >= 1.0 ? "\n" : ""), false);
    };
  // Plain lines, at most one every two seconds, and the last.
  return [last = -1e9](const facade::Progress& p) mutable {
    if (p.elapsed - last < 2.0 && p.fraction < 1.0) return;
    last = p.elapsed;
    tell(progress_line(p) + "\n", false);
  };
}

/// A word of a command line as a shell reads it back.
std::string quoted(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("+,-./:=@_%[]").find(static_cast<char>(c)) !=
                                       std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// May the results of an earlier run be replaced? Only somebody at a terminal can say so.
bool may_replace(const facade::ResultsExist& found) {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDERR_FILENO) == 0) return false;
  tell(fmt::format("{}\nReplace them? [y/N] ", found.what()));
  const int answer = std::getchar();
  return answer == 'y' || answer == 'Y';
}

int report(const facade::RunOutcome& outcome, bool quiet, const std::string& how_to_go_on) {
  if (outcome.status == facade::RunStatus::Failed ||
      outcome.status == facade::RunStatus::Untrusted ||
      (outcome.status == facade::RunStatus::Interrupted && !outcome.message.empty()))
    tell(fmt::format("adore: {}\n", outcome.message));
  else if (!outcome.message.empty()) {
    tell(outcome.message + "\n");
    return 0;
  }
  if (outcome.status == facade::RunStatus::Interrupted)
    tell(
        fmt::format("\ninterrupted; the files are valid up to the last stored step. Go on with\n"
                    "  {}\n",
                    how_to_go_on));
  if (!quiet) {
    for (const std::string& line : outcome.results) fmt::print("{}\n", line);
    if (!outcome.results.empty())
      fmt::print("quasi-static solution computed in {}\n", duration_text(outcome.seconds));
    else
      fmt::print("{} steps, {:.4g} revolutions, t = {:.6g} s, computed in {}\n", outcome.steps,
                 outcome.revolutions, outcome.time, duration_text(outcome.seconds));
    if (outcome.energy_scale > 0.0)
      fmt::print("energy residual {:.3g} J ({:.2g} of {:.3g} J)\n", outcome.energy_residual,
                 outcome.energy_residual / outcome.energy_scale, outcome.energy_scale);
    for (const auto& file : outcome.files) fmt::print("  {}\n", file.string());
  }
  return outcome.status == facade::RunStatus::Done          ? 0
         : outcome.status == facade::RunStatus::Interrupted ? 130
                                                            : 3;
}

struct RunOptions : DeckOptions {
  std::string out, until, integrator, progress = "auto";
  double tolerance = 0.0;
  int threads = 0;
  bool quiet = false, list_options = false, go_on = false, overwrite = false;

  /// The command that goes on with this run.
  [[nodiscard]] std::string continuation(bool tolerance_given) const {
    std::string line = "adore run " + quoted(deck);
    const auto add = [&](const char* name, const std::string& value) {
      if (!value.empty()) line += fmt::format(" {} {}", name, quoted(value));
    };
    add("--out", out);
    for (const std::string& text : sets) add("--set", text);
    for (const std::string& text : this->options) add("--opt", text);
    add("--until", until);
    add("--integrator", integrator);
    if (tolerance_given) add("--tol", fmt::format("{}", tolerance));
    return line + " --continue";
  }
};

/// Runs, and once more when what stands in the way may go.
template <class Run>
auto run_asking(facade::RunRequest& request, Run&& run_it) {
  try {
    return run_it();
  } catch (const facade::ResultsExist& found) {
    if (!may_replace(found)) throw;
  }
  request.overwrite = true;
  return run_it();
}

int run(const RunOptions& options, bool tolerance_given) {
  if (options.list_options) {
    for (const build::OptionInfo& info : build::run_option_list())
      fmt::print("{:<20} {:<12} {}\n", info.name, info.default_value, info.meaning);
    return 0;
  }
  facade::RunRequest request;
  options.fill(request);
  if (!options.out.empty()) request.out = options.out;
  request.until = options.until;
  request.integrator = options.integrator;
  if (tolerance_given) request.tolerance = options.tolerance;
  request.go_on = options.go_on;
  request.overwrite = options.overwrite;
  check_range("--threads", options.threads);
  const facade::ProgressSink sink = make_sink(options.quiet ? "none" : options.progress);
  InterruptWatch watch;
  if (facade::is_sweep(request)) {
    const facade::SweepOutcome sweep = run_asking(request, [&] {
      return facade::run_sweep(request, options.threads, sink, watch.token());
    });
    print_warnings(sweep.warnings);
    if (watch.token().stop_requested())
      tell(fmt::format("\ninterrupted; run what is missing with\n  {}\n",
                       options.continuation(tolerance_given)));
    if (!options.quiet) fmt::print("{}\n", sweep.table.string());
    return sweep.exit_code;
  }
  const facade::RunOutcome outcome =
      run_asking(request, [&] { return facade::run(request, sink, watch.token()); });
  print_warnings(outcome.warnings);
  return report(outcome, options.quiet, options.continuation(tolerance_given));
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "run", "simulate a deck: PRINT.txt, FINAL, MASTER, SOL1-SOL8, RUN.json, RESULTS.h5");
  auto options = std::make_shared<RunOptions>();
  options->add_to(*command);
  command->add_option("--out", options->out,
                      "folder of the output files (default: beside the deck)");
  command->add_option(
      "--until", options->until,
      "end of the run: 5rev, 0.02s or a dimensionless time; replaces fTime and maxStps");
  command->add_option("--integrator", options->integrator,
                      "rkf1-7, pece1-8, cvode-adams, cvode-bdf, arkode-erk, -dirk, -imex");
  CLI::Option* tolerance =
      command->add_option("--tol", options->tolerance, "local error limit, replaces tol");
  command->add_option("--threads", options->threads,
                      "independent runs of a sweep at a time (default: all cores)");
  command->add_option("--progress", options->progress, "auto, plain, json or none")
      ->check(CLI::IsMember({"auto", "plain", "json", "none"}))
      ->capture_default_str();
  CLI::Option* go_on = command->add_flag(
      "--continue", options->go_on,
      "complete an interrupted or killed run (or sweep) from its last checkpoint; with a later "
      "--until also a run that is complete");
  command
      ->add_flag("--overwrite", options->overwrite,
                 "replace the results of an earlier run in the folder")
      ->excludes(go_on);
  command->add_flag("--quiet", options->quiet, "no progress and no summary");
  command->add_flag("--list-options", options->list_options,
                    "list the run options of --opt and ADORE.json");
  command->callback([=, &exit_code] { exit_code = run(*options, tolerance->count() > 0); });
}

}  // namespace adore::cli
