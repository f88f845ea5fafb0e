#include "runs/run.hpp"

#include "base/counted.hpp"
#include "base/interrupted.hpp"
#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "cli/assembly.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/option_ranges.hpp"
#include "cli/percentage.hpp"
#include "cli/progress.hpp"
#include "cli/run_report.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "runs/output_folder.hpp"
#include "runs/reproducible.hpp"
#include "setup/run_control.hpp"
#include "studies/accuracy_statement.hpp"
#include "studies/chosen_settings.hpp"
#include "studies/sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace adore::cli {
namespace {

struct RunOptions : DeckOptions {
  std::string out, until, integrator, accuracy, progress = "auto";
  double tolerance = 0.0;
  int threads = 0;
  bool quiet = false, list_options = false, json = false, reproducible = false, go_on = false,
       overwrite = false, verify = false, extend = false;

  /// The command that continues this run to its end or to another end.
  [[nodiscard]] std::string continuation(bool tolerance_given, const std::string& to) const {
    std::string line = deck == "-" ? "cat DECK | adore run -" : "adore run " + quoted(deck);
    const auto add = [&](const char* name, const std::string& value) {
      if (!value.empty()) line += fmt::format(" {} {}", name, quoted(value));
    };
    if (!out.empty()) line += " --out " + quoted_path(out);
    for (const std::string& text : sets) add("--set", text);
    for (const std::string& text : this->options) add("--opt", text);
    if (!user.empty()) line += " --user " + quoted_path(user);
    add("--until", to);
    add("--integrator", integrator);
    if (tolerance_given) add("--tol", fmt::format("{}", tolerance));
    if (reproducible) line += " --reproducible";
    return line + " --continue";
  }
};

void list_options(bool json) {
  if (!json) {
    for (const setup::OptionInfo& info : setup::run_option_list())
      print("{:<20} {:<12} {}\n", info.name, info.default_value, info.meaning);
    return;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const setup::OptionInfo& info : setup::run_option_list())
    list.push_back(
        {{"name", info.name}, {"default", info.default_value}, {"meaning", info.meaning}});
  write_text("", "", dump_json(list, 2) + "\n");
}

/// Runs; runs again if the user allows existing results to be replaced.
template <class Run>
auto run_asking(runs::RunRequest& request, Run&& run_it) {
  try {
    return run_it();
  } catch (const runs::ResultsExist& found) {
    if (!ask(fmt::format("{}\nReplace these files?", found.what())).value_or(false)) throw;
  }
  request.overwrite = true;
  return run_it();
}

int report(const runs::RunOutcome& outcome, const RunOptions& options, bool tolerance_given) {
  if (outcome.status == runs::RunStatus::Failed || outcome.status == runs::RunStatus::Untrusted ||
      (outcome.status == runs::RunStatus::Interrupted && !outcome.message.empty()))
    tell(fmt::format("adore: {}\n", outcome.message));
  else if (!outcome.message.empty()) {
    tell(outcome.message + "\n");
    return 0;
  }
  if (outcome.status == runs::RunStatus::Interrupted)
    tell(fmt::format(
        "\ninterrupted; the files are valid up to the last stored step. Continue with\n  {}\n",
        options.continuation(tolerance_given, options.until)));
  if (options.json)
    write_text("", "", dump_json(summary_json(outcome), 2) + "\n");
  else if (!options.quiet)
    write_text(
        "", "",
        summary_text(outcome, outcome.status == runs::RunStatus::Done && outcome.steps > 0
                                  ? options.continuation(tolerance_given, doubled_length(outcome))
                                  : ""));
  return exit_code(outcome);
}

/// The options with the settings found by a short study.
RunOptions with(RunOptions options, const studies::ChosenSettings& chosen) {
  options.integrator = chosen.integrator;
  options.tolerance = chosen.tolerance;
  for (const auto& [name, value] : chosen.sets) {
    std::erase_if(options.sets,
                  [&](const std::string& set) { return set.starts_with(name + "="); });
    options.sets.push_back(fmt::format("{}={}", name, value));
  }
  for (const auto& [name, value] : chosen.options)
    options.options.push_back(fmt::format("{}={}", name, value));
  return options;
}

/// A completed run: measured, stored in its files and reported.
studies::AccuracyStatement state(const runs::RunRequest& request, const runs::RunOutcome& outcome,
                                 double target, InterruptWatch& watch) {
  studies::AccuracyStatement out =
      studies::make_accuracy_statement(request, outcome, target, watch.token());
  studies::store_statement(out, outcome);
  return out;
}

/// The statement covers the run itself. Settings with a too large numerical part are tightened;
/// with --extend a run with too much scatter in its means is continued.
int run_to_accuracy(const RunOptions& options, runs::RunRequest& request,
                    const runs::ProgressSink& sink, InterruptWatch& watch) {
  constexpr int kMaxTightenings = 2, kMaxExtensions = 2;
  const double target = parse_percentage("--accuracy", options.accuracy);
  studies::ChosenSettings chosen = studies::choose_settings(
      request, target, watch.token(), studies::requested_revolutions(request));
  RunOptions given = options;
  for (int tighter = 0, extended = 0;;) {
    const runs::RunOutcome outcome = run_asking(request, [&] {
      return studies::run_with_chosen_settings(request, chosen, sink, watch.token());
    });
    const bool done = exit_code(outcome) == 0 && outcome.steps > 0;
    std::optional<studies::AccuracyStatement> stated;
    if (done) {
      runs::RunRequest as_run = request;
      studies::apply_chosen_settings(as_run, chosen);
      stated = state(as_run, outcome, target, watch);
      if (stated->numerical() > target && tighter < kMaxTightenings && !request.go_on) {
        ++tighter;
        tell(fmt::format(
            "the numerical error is {:.2g} %; the run is repeated with tighter settings\n",
            100.0 * stated->numerical()));
        studies::tighten_settings(chosen, request, outcome);
        request.overwrite = true;
        continue;
      }
      if (const double turns = stated->required_revolutions(target);
          options.extend && turns > 0.0 && extended < kMaxExtensions) {
        ++extended;
        tell(fmt::format("accurate mean values need a run of about {}; the run continues\n",
                         counted(fmt::format("{:.3g}", turns), "revolution")));
        request.until = given.until = fmt::format("{:.6g}rev", turns);
        request.go_on = true;
        request.overwrite = false;
        continue;
      }
    }
    print_warnings(outcome.warnings);
    const int code = report(outcome, with(given, chosen), true);
    if (stated) tell(studies::statement_text(*stated));
    if (stated && options.verify) tell(studies::verification_text(stated->tighter, outcome));
    return code;
  }
}

/// An assembly is quasi-static and one run: options of motions and sweeps are errors.
int run_set(const RunOptions& options, bool tolerance_given) {
  const auto refuse = [](bool given, const char* option) {
    if (given)
      throw InputError(fmt::format(
          "{}: not available for an assembly, which is quasi-static; remove the option", option));
  };
  refuse(!options.until.empty(), "--until");
  refuse(!options.integrator.empty(), "--integrator");
  refuse(tolerance_given, "--tol");
  refuse(!options.accuracy.empty(), "--accuracy");
  refuse(options.verify, "--verify");
  refuse(options.extend, "--extend");
  refuse(options.go_on, "--continue");
  refuse(options.threads != 0, "--threads");
  runs::RunRequest request;
  options.fill(request);
  if (studies::is_sweep(request))
    throw InputError("--set: sweeps are not available for an assembly; give --set a single value");
  return run_assembly(options, {options.out, options.overwrite, options.json, options.quiet});
}

int run(const RunOptions& options, bool tolerance_given) {
  if (options.list_options) {
    list_options(options.json);
    return 0;
  }
  if (options.reproducible) runs::require_reproducible();
  if (is_assembly_deck(options)) return run_set(options, tolerance_given);
  runs::RunRequest request;
  options.fill(request);
  if (!options.out.empty()) request.out = options.out;
  request.until = options.until;
  request.integrator = options.integrator;
  if (tolerance_given) request.tolerance = options.tolerance;
  request.go_on = options.go_on;
  request.overwrite = options.overwrite;
  check_range("--threads", options.threads);
  if (options.extend && options.accuracy.empty())
    throw InputError("--extend needs a target error; add --accuracy");
  if (!options.accuracy.empty() && (options.go_on || !options.integrator.empty()))
    throw InputError(fmt::format("--accuracy selects the integrator of a new run; remove {}",
                                 options.go_on ? "--continue" : "--integrator"));
  const runs::ProgressSink sink = make_progress(options.quiet ? "none" : options.progress);
  InterruptWatch watch;
  if (studies::is_sweep(request)) {
    if (options.verify || !options.accuracy.empty())
      throw InputError(
          "--verify and --accuracy need a single run, but this is a sweep; remove these options, "
          "or give --set a single value");
    const studies::SweepOutcome sweep = run_asking(
        request, [&] { return studies::run_sweep(request, options.threads, sink, watch.token()); });
    print_warnings(sweep.warnings);
    if (watch.token().stop_requested())
      tell(fmt::format("\ninterrupted; run the missing values with\n  {}\n",
                       options.continuation(tolerance_given, options.until)));
    if (options.json)
      write_text("", "", dump_json(summary_json(sweep), 2) + "\n");
    else if (!options.quiet)
      write_text("", "",
                 sweep_text(sweep, watch.token().stop_requested()
                                       ? ""
                                       : options.continuation(tolerance_given, options.until)));
    return sweep.exit_code;
  }
  if (options.threads > 0)
    tell(
        "adore: note: --threads has no effect, because a single run uses one core. Only a sweep "
        "(--set variable=first:last:count) uses several cores\n");
  if (!options.accuracy.empty()) return run_to_accuracy(options, request, sink, watch);
  const runs::RunOutcome outcome =
      run_asking(request, [&] { return runs::run(request, sink, watch.token()); });
  print_warnings(outcome.warnings);
  const int code = report(outcome, options, tolerance_given);
  if (options.verify && code == 0 && outcome.steps > 0) {
    const studies::AccuracyStatement stated = state(request, outcome, 0.0, watch);
    tell(studies::verification_text(stated.tighter, outcome));
    tell(studies::statement_text(stated));
  }
  return code;
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "run", "simulate a deck: PRINT.txt, FINAL, MASTER, SOL1-SOL8, RUN.json, RESULTS.h5");
  auto options = std::make_shared<RunOptions>();
  options->add_to(*command);
  command->add_option("--out", options->out, "output folder (default: the folder of the deck)")
      ->type_name("DIR");
  command
      ->add_option("--until", options->until,
                   "simulated length: revolutions (5rev), time (0.02s) or dimensionless time "
                   "(1000); replaces fTime and maxStps")
      ->type_name("END");
  command_line::suggest_values(
      command
          ->add_option("--integrator", options->integrator,
                       "integrator: rkf1-7, rk4, pece1-8, cvode-adams, cvode-bdf, arkode-erk, "
                       "arkode-dirk or arkode-imex; replaces intMet")
          ->type_name("NAME"),
      {"rkf1",  "rkf2",        "rkf3",      "rkf4",       "rkf5",        "rkf6",        "rkf7",
       "pece1", "pece2",       "pece3",     "pece4",      "pece5",       "pece6",       "pece7",
       "pece8", "cvode-adams", "cvode-bdf", "arkode-erk", "arkode-dirk", "arkode-imex", "rk4"});
  CLI::Option* tolerance =
      command->add_option("--tol", options->tolerance, "local error tolerance; replaces tol");
  command
      ->add_option("--accuracy", options->accuracy,
                   "target error of speed, load, heat and life, e.g. 1%. A short study selects "
                   "integrator, tolerance, longest step and the nodes or slices of contacts. The "
                   "run reports confidence intervals")
      ->type_name("PERCENT")
      ->excludes(tolerance);
  command->add_flag("--verify", options->verify,
                    "repeat the run with tighter settings and with a relative load change of 1e-6; "
                    "write differences and confidence intervals to RUN.json and PRINT.txt");
  command->add_flag("--extend", options->extend,
                    "with --accuracy: continue the run beyond the end given by --until if its mean "
                    "values are not accurate enough");
  command->add_option("--threads", options->threads,
                      "number of parallel runs in a sweep (default: all cores)");
  command_line::one_of(
      command->add_option("--progress", options->progress, "progress display on stderr")
          ->capture_default_str()
          ->type_name("STYLE"),
      {"auto", "plain", "json", "none"});
  CLI::Option* overwrite =
      command->add_flag("--overwrite", options->overwrite,
                        "replace the results of an earlier run in the output folder");
  command
      ->add_flag("--continue", options->go_on,
                 "continue the run in the output folder (interrupted, killed or complete); in a "
                 "sweep: run the missing and failed values")
      ->excludes(overwrite);
  command->add_flag("--reproducible", options->reproducible,
                    "give bit-identical results on all x86-64 processors; AVX is not used, so the "
                    "run takes two to three times longer");
  command->add_flag("--json", options->json, "print the summary as JSON");
  command->add_flag("--quiet", options->quiet, "print neither progress nor summary");
  command->add_flag("--list-options", options->list_options,
                    "list the run options of --opt and ADORE.json");
  command->footer(
      "Examples\n"
      "  adore run                                 the DATA.txt of this folder\n"
      "  adore run DATA.txt --out results --until 5rev\n"
      "  adore run DATA.txt --set rpm2=12000 --set appLoadX=800\n"
      "  adore run DATA.txt --set rpm2=2000:20000:10 --out sweep\n"
      "  adore run DATA.txt --out results --until 9rev --continue\n"
      "  adore run SET --out results               the bearing set in SET/ASSEMBLY.json\n"
      "  adore new ball | adore run - --out example");
  command->callback([=, &exit_code] { exit_code = run(*options, tolerance->count() > 0); });
}

}  // namespace adore::cli
