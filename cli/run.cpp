#include "facade/run.hpp"

#include "base/duration.hpp"
#include "build/run_control.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/option_ranges.hpp"
#include "facade/sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>
#include <unistd.h>

namespace adore::cli {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int) {
  interrupted = true;
  std::signal(SIGINT, SIG_DFL);  // a second Ctrl-C ends the program at once
}

/// Turns the signal's flag into a stop request while a run lasts.
class InterruptWatch {
 public:
  InterruptWatch() {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    watcher_ = std::jthread([this](std::stop_token done) {
      while (!done.stop_requested()) {
        if (interrupted) source_.request_stop();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    });
  }
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watcher_;
};

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
      fmt::print(stderr, "{}\n", line.dump());
    };
  if (style == "auto" && terminal)
    return [](const facade::Progress& p) {
      fmt::print(stderr, "\r\033[K{}{}", progress_line(p), p.fraction >= 1.0 ? "\n" : "");
      std::fflush(stderr);
    };
  // Plain lines, at most one every two seconds, and the last.
  return [last = -1e9](const facade::Progress& p) mutable {
    if (p.elapsed - last < 2.0 && p.fraction < 1.0) return;
    last = p.elapsed;
    fmt::print(stderr, "{}\n", progress_line(p));
  };
}

int report(const facade::RunOutcome& outcome, bool quiet) {
  if (outcome.status == facade::RunStatus::Failed)
    fmt::print(stderr, "adore: {}\n", outcome.message);
  if (outcome.status == facade::RunStatus::Interrupted)
    fmt::print(stderr, "\ninterrupted; the files are valid up to the last stored step\n");
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
  bool quiet = false, list_options = false;
};

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
  check_range("--threads", options.threads);
  const facade::ProgressSink sink = make_sink(options.quiet ? "none" : options.progress);
  InterruptWatch watch;
  if (facade::is_sweep(request)) {
    const facade::SweepOutcome sweep =
        facade::run_sweep(request, options.threads, sink, watch.token());
    print_warnings(sweep.warnings);
    if (!options.quiet) fmt::print("{}\n", sweep.table.string());
    return sweep.exit_code;
  }
  const facade::RunOutcome outcome = facade::run(request, sink, watch.token());
  print_warnings(outcome.warnings);
  return report(outcome, options.quiet);
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
  command->add_flag("--quiet", options->quiet, "no progress and no summary");
  command->add_flag("--list-options", options->list_options,
                    "list the run options of --opt and ADORE.json");
  command->callback([=, &exit_code] { exit_code = run(*options, tolerance->count() > 0); });
}

}  // namespace adore::cli
