#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "cli/commands.hpp"
#include "cli/option_ranges.hpp"
#include "cli/picture_program.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "studies/campaign.hpp"
#include "studies/report.hpp"
#include "studies/study_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <unistd.h>

namespace adore::cli {
namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string file, engine = "local", progress = "auto", out, kind;
  int workers = 0;
  bool retry_failed = false, over_budget = false, json = false, quiet = false;
};

studies::CampaignRequest request_of(const StudyOptions& options) {
  check_range("--workers", options.workers);
  studies::CampaignRequest request;
  request.study = studies::open_study(options.file);
  request.engine = options.engine;
  request.program = fs::read_symlink("/proc/self/exe");
  request.workers = options.workers;
  request.retry_failed = options.retry_failed;
  request.over_budget = options.over_budget;
  return request;
}

/// One line that is written over at a terminal, plain lines at every tenth elsewhere.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& style)
      : style_(style), terminal_(isatty(STDERR_FILENO) != 0 && style == "auto") {}
  ~ProgressLine() {
    if (terminal_ && shown_) tell("\n", false);
  }
  void operator()(const studies::StudyProgress& p) {
    if (style_ == "none") return;
    if (style_ == "json") {
      const nlohmann::ordered_json line{{"done", p.done},       {"total", p.total},
                                        {"failed", p.failed},   {"workers", p.workers},
                                        {"elapsed", p.elapsed}, {"remaining", p.remaining},
                                        {"note", p.note},       {"last_failure", p.last_failure}};
      tell(dump_json(line) + "\n", false);
      return;
    }
    const long tenth = p.total > 0 ? 10 * p.done / p.total : 0;
    if (!terminal_ && tenth == tenth_ && shown_) return;
    tenth_ = tenth;
    shown_ = true;
    const std::string text = studies::progress_text(p);
    tell(terminal_ ? fmt::format("\r\x1b[K{}", text.substr(0, 110)) : text + "\n", false);
  }

 private:
  std::string style_;
  bool terminal_ = false, shown_ = false;
  long tenth_ = -1;
};

int new_study(const StudyOptions& options) {
  std::string text = studies::example_study(options.kind);
  if (studies::is_toml(options.out))
    text = studies::write_study_text(studies::read_study_text(text, "example.json").json, true);
  const std::string name = write_text(options.out, options.kind + ".json", text);
  if (!name.empty()) print("wrote {}\n", name);
  return 0;
}

int plan(const StudyOptions& options) {
  const studies::CampaignRequest request = request_of(options);
  InterruptWatch watch;
  const studies::Plan plan = studies::make_plan(request, watch.token());
  if (options.json)
    write_text(
        "", "",
        dump_json(nlohmann::ordered_json{{"runs", plan.runs},
                                         {"known", plan.known},
                                         {"seconds_each", plan.pilot.wall},
                                         {"processor_seconds_each", plan.pilot.processor},
                                         {"memory_megabytes_each", plan.pilot.memory_megabytes},
                                         {"workers", plan.workers},
                                         {"hours", plan.hours},
                                         {"disk_megabytes", plan.disk_megabytes},
                                         {"free_disk_megabytes", plan.free_disk_megabytes},
                                         {"over_budget", plan.over_budget}},
                  2) +
            "\n");
  else
    write_text("", "", studies::plan_text(request, plan));
  return 0;
}

/// Tables, report and pictures of the finished runs. @returns true if all could be written
bool write_results(const studies::Study& study, bool quiet) {
  const studies::Report report = studies::write_report(study);
  const fs::path folder = study.folder();
  if (!quiet) write_text("", "", report.text);
  bool all = true;
  if (has_pictures()) {
    std::vector<std::string> words{"study-charts", (folder / "CHARTS.json").string(),
                                   folder.string()};
    if (quiet) words.emplace_back("--quiet");
    all = run_picture_program(words);
    if (!all)
      tell(
          fmt::format("adore: pictures are missing; draw them again with `adore study report {}`\n",
                      study.file.string()));
  }
  if (!quiet)
    for (const char* name : {"RUNS.csv", "STUDY.h5", "TIMES.csv", "REPORT.txt"})
      print("{}\n", (folder / name).string());
  return all;
}

std::string command_of(const char* word, const StudyOptions& options) {
  return fmt::format("adore study {} {}{}", word, options.file,
                     options.engine == "local" ? "" : " --engine " + options.engine);
}

int run(const StudyOptions& options, bool resume) {
  const studies::CampaignRequest request = request_of(options);
  if (resume) (void)studies::study_status(request.study);  // reports if it was never started
  InterruptWatch watch;
  studies::CampaignOutcome outcome;
  try {
    ProgressLine line(options.quiet ? "none" : options.progress);
    outcome = studies::run_campaign(
        request, [&](const studies::StudyProgress& p) { line(p); }, watch.token());
  } catch (const InputError& error) {
    if (const std::string text = error.what(); text.find("disk space") != std::string::npos)
      throw InputError(fmt::format(
          "{}\nFinished runs are recorded. Free some disk space, then continue with\n  {}", text,
          command_of("resume", options)));
    throw;
  }
  const bool written = write_results(request.study, options.quiet);
  if (!options.quiet) print("{}\n", studies::outcome_text(outcome));
  if (!outcome.complete) {
    tell(fmt::format("\ninterrupted; finished runs are recorded. Continue with\n  {}\n",
                     command_of("resume", options)));
    return 130;
  }
  return outcome.failed > 0 ? 3 : written ? 0 : 2;
}

int status(const StudyOptions& options) {
  const studies::Study study = studies::open_study(options.file);
  const studies::Status status = studies::study_status(study);
  if (options.json) {
    write_text("", "",
               dump_json(nlohmann::ordered_json{{"runs", status.runs},
                                                {"done", status.done},
                                                {"failed", status.failed},
                                                {"at_work", status.at_work},
                                                {"diagnoses", status.diagnoses}},
                         2) +
                   "\n");
    return 0;
  }
  print("{} of {} runs done, {} of them failed; {}\n", status.done, status.runs, status.failed,
        status.at_work               ? "running"
        : status.done == status.runs ? "complete"
                                     : "stopped: continue with " + command_of("resume", options));
  for (const std::string& text : status.diagnoses) print("  {}\n", text);
  return 0;
}

void add_file(CLI::App& command, StudyOptions& options) {
  command.add_option("file", options.file, "study file")->required()->type_name("FILE");
}

void add_engine(CLI::App& command, StudyOptions& options) {
  command_line::one_of(command
                           .add_option("--engine", options.engine,
                                       "compute with local processes or on a Slurm cluster")
                           ->capture_default_str()
                           ->type_name("ENGINE"),
                       {"local", "slurm"});
  command.add_option("--workers", options.workers,
                     "number of parallel runs (default: as many as cores and memory allow)");
}

void add_run_like(CLI::App& study, const char* name, const char* text, bool resume,
                  const std::shared_ptr<StudyOptions>& options, int& exit_code) {
  CLI::App* command = study.add_subcommand(name, text);
  add_file(*command, *options);
  add_engine(*command, *options);
  command->add_flag("--retry-failed", options->retry_failed, "repeat failed runs");
  command->add_flag("--over-budget", options->over_budget,
                    "run even if the plan exceeds the budget of the study");
  command_line::one_of(
      command->add_option("--progress", options->progress, "progress display on stderr")
          ->capture_default_str()
          ->type_name("STYLE"),
      {"auto", "plain", "json", "none"});
  command->add_flag("--quiet", options->quiet, "print neither progress nor report");
  command->callback([=, &exit_code] { exit_code = run(*options, resume); });
}

/// Started by engines, not typed by users.
void add_work(CLI::App& study, int& exit_code) {
  CLI::App* command = study.add_subcommand(
      "work", "compute runs of a study (started by the local or Slurm engine)");
  command->group("");
  auto folder = std::make_shared<std::string>(), tasks = std::make_shared<std::string>();
  auto first = std::make_shared<long>(0), count = std::make_shared<long>(0);
  command->add_option("folder", *folder, "folder of the study")->required();
  command->add_option("--tasks", *tasks, "file of tasks");
  command->add_option("--first", *first, "first line, from 0");
  command->add_option("--count", *count, "lines");
  command->callback([=, &exit_code] {
    InterruptWatch watch;
    exit_code = tasks->empty()
                    ? studies::run_tasks_from_stdin(*folder, watch.token())
                    : studies::run_tasks_from_file(*folder, *tasks, *first, *count, watch.token());
  });
}

}  // namespace

void add_study_command(CLI::App& app, int& exit_code) {
  CLI::App* study = app.add_subcommand("study",
                                       "run studies with many cases: sweeps, tolerances, cage "
                                       "maps, sensitivities, worst cases, what-if");
  study->require_subcommand(1);
  study->footer(
      "A study file contains JSON, or TOML if its name ends in .toml. The results are\n"
      "in the folder NAME.study next to the study file: RUNS.csv, STUDY.h5, REPORT.txt\n"
      "and pictures.\n\n"
      "Examples\n"
      "  adore new ball --out DATA.txt\n"
      "  adore study new sweep --out sweep.json\n"
      "  adore study plan sweep.json\n"
      "  adore study run sweep.json\n"
      "  adore study resume sweep.json --engine slurm");
  auto options = std::make_shared<StudyOptions>();

  CLI::App* make = study->add_subcommand("new", "write a complete, explained study file");
  command_line::one_of(make->add_option("kind", options->kind, "study type")->required(),
                       {"sweep", "tolerance", "cage-map", "sensitivity", "worst-case", "what-if"});
  make->add_option("--out", options->out,
                   "file to write, NAME.json or NAME.toml; - for standard output")
      ->type_name("FILE");
  make->callback([=, &exit_code] { exit_code = new_study(*options); });

  CLI::App* look = study->add_subcommand("plan",
                                         "estimate number of runs, computing time and disk space "
                                         "from a few pilot runs, whose results are kept");
  add_file(*look, *options);
  add_engine(*look, *options);
  look->add_flag("--json", options->json, "print as JSON");
  look->callback([=, &exit_code] { exit_code = plan(*options); });

  add_run_like(*study, "run", "run all cases that have no result yet, then write tables and report",
               false, options, exit_code);
  add_run_like(*study, "resume", "resume an interrupted study", true, options, exit_code);

  CLI::App* state = study->add_subcommand("status", "show progress and failed runs");
  add_file(*state, *options);
  state->add_flag("--json", options->json, "print as JSON");
  state->callback([=, &exit_code] { exit_code = status(*options); });

  CLI::App* report =
      study->add_subcommand("report", "write tables, report and pictures of the finished runs");
  add_file(*report, *options);
  report->callback([=, &exit_code] {
    exit_code = write_results(studies::open_study(options->file), false) ? 0 : 2;
  });
  add_work(*study, exit_code);
}

}  // namespace adore::cli
