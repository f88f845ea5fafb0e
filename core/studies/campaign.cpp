#include "studies/campaign.hpp"

#include "base/counted.hpp"
#include "base/duration.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/interrupted.hpp"
#include "runs/output_folder.hpp"
#include "runs/prepare.hpp"
#include "studies/slurm.hpp"
#include "studies/study_check.hpp"
#include "studies/study_folder.hpp"
#include "studies/worst_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace adore::studies {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kOtherNameRemedy =
    "copy the study file to a file with another name; the results of the copy are written next to "
    "the copy";
constexpr double kRecordMegabytes = 0.0041;  ///< a block of the disk
constexpr double kMaxPilotSeconds = 20.0;    ///< [s]; after that no further pilot run

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// One of each key, of those without a record.
std::vector<Task> missing(const std::vector<Task>& tasks, const fs::path& folder) {
  std::set<std::string> seen;
  std::vector<Task> out;
  for (const Task& task : tasks)
    if (seen.insert(task.key).second && !read_record(folder, task.key)) out.push_back(task);
  return out;
}

/// First, middle and last of the table: what varies may change what a run costs.
std::vector<Task> pilots_of(const std::vector<Task>& tasks) {
  std::vector<Task> out{tasks[tasks.size() / 2]};
  for (const Task& task : {tasks.front(), tasks.back()})
    if (std::none_of(out.begin(), out.end(),
                     [&](const Task& other) { return other.key == task.key; }))
      out.push_back(task);
  return out;
}

/// Records of these runs; as many at a time as the study will have, so that none waits for another
/// and each costs what the runs of the study cost.
std::vector<Record> run_pilots(const CampaignRequest& request, const fs::path& folder,
                               const std::vector<Task>& tasks, int workers,
                               const std::stop_token& stop) {
  EngineRequest work;
  work.folder = fs::absolute(folder);
  work.program = request.program;
  work.workers = workers;
  work.tasks = missing(tasks, folder);
  if (!work.tasks.empty())
    run_local(
        work, [](const Record&) {}, [](int, const std::string&) {}, stop);
  if (stop.stop_requested()) throw Interrupted("interrupted in the pilot run");
  std::vector<Record> out;
  for (const Task& task : tasks)
    if (std::optional<Record> record = read_record(folder, task.key))
      out.push_back(std::move(*record));
  return out;
}

/// Runs the pilots, each in a separate process. @throws InputError when none of them gives a
/// result.
Pilot measure(const CampaignRequest& request, const fs::path& folder,
              const std::vector<Task>& tasks, bool keep_files, const std::stop_token& stop) {
  Pilot out;
  std::vector<Record> records;
  std::string refused;
  const std::vector<Task> pilots = pilots_of(tasks);
  // A cluster's own cores are not here.
  const int cores = request.engine == "slurm" ? 1
                    : request.workers > 0     ? request.workers
                                              : usable_cores();
  const auto at_a_time = static_cast<std::size_t>(std::max(1, cores));
  for (std::size_t from = 0; from < pilots.size() && out.wall <= kMaxPilotSeconds;
       from += at_a_time) {
    const auto end = pilots.begin() + static_cast<long>(std::min(from + at_a_time, pilots.size()));
    const std::vector<Task> some(pilots.begin() + static_cast<long>(from), end);
    for (const Record& record : run_pilots(request, folder, some, cores, stop)) {
      if (record.exit_code == 2) {
        const auto task = std::find_if(some.begin(), some.end(),
                                       [&](const Task& one) { return one.key == record.key; });
        refused = fmt::format("run {}: {}", task->number, record.message);
        continue;
      }
      if (!record.message.empty() && record.exit_code == 0)
        throw InputError(fmt::format(
            "quantities not available in the runs: {}; remove these quantities, or change the deck",
            record.message));
      records.push_back(record);
      out.wall += record.wall;
    }
  }
  if (records.empty())
    throw InputError(
        fmt::format("{}: nothing was started: {}", request.study.file.string(), refused));
  const auto n = static_cast<double>(records.size());
  out.wall /= n;
  for (const Record& record : records) {
    out.processor += record.processor / n;
    out.memory_megabytes = std::max(out.memory_megabytes, record.memory_megabytes);
    out.passing_megabytes = std::max(out.passing_megabytes, record.disk_megabytes);
    if (record.exit_code != 0) out.trouble = record.message;
  }
  out.disk_megabytes = kRecordMegabytes + (keep_files ? out.passing_megabytes : 0.0);
  return out;
}

int planned_workers(const CampaignRequest& request, const Pilot& pilot) {
  if (request.engine == "slurm") return slurm_cores();
  if (request.workers > 0) return request.workers;
  constexpr double kUsableMemoryShare = 0.8;
  const double fit =
      available_memory_megabytes() * kUsableMemoryShare / std::max(64.0, pilot.memory_megabytes);
  return std::max(1, std::min(usable_cores(), static_cast<int>(std::min(fit, 1e6))));
}

Plan plan_of(const CampaignRequest& request, const Study& study, const fs::path& folder, long runs,
             long known, const Pilot& pilot) {
  Plan out;
  out.runs = runs;
  out.known = known;
  out.pilot = pilot;
  out.workers = planned_workers(request, pilot);
  const auto left = static_cast<double>(runs - known);
  out.hours = std::ceil(left / out.workers) * pilot.wall / 3600.0;
  out.disk_megabytes = left * pilot.disk_megabytes;
  std::error_code error;
  out.free_disk_megabytes = static_cast<double>(fs::space(folder, error).available) / 1e6;
  const auto exceeds = [&](const std::string& text) {
    out.over_budget += (out.over_budget.empty() ? "" : "; ") + text;
  };
  if (study.budget.runs && static_cast<double>(runs) > *study.budget.runs)
    exceeds(fmt::format("{}, but the budget is {:g}", counted(runs, "run"), *study.budget.runs));
  if (study.budget.hours && out.hours > *study.budget.hours)
    exceeds(fmt::format("{}, but the budget is {:g}",
                        counted(fmt::format("{:.3g}", out.hours), "hour"), *study.budget.hours));
  if (study.budget.disk_megabytes && out.disk_megabytes > *study.budget.disk_megabytes)
    exceeds(fmt::format("{:.3g} MB on disk, but the budget is {:g} MB", out.disk_megabytes,
                        *study.budget.disk_megabytes));
  if (!error && out.disk_megabytes > out.free_disk_megabytes)
    exceeds(fmt::format("{:.3g} MB on disk, but {:.3g} MB are free in {}", out.disk_megabytes,
                        out.free_disk_megabytes, folder.string()));
  return out;
}

long count_known(const std::vector<Task>& tasks, const fs::path& folder) {
  return std::count_if(tasks.begin(), tasks.end(),
                       [&](const Task& task) { return read_record(folder, task.key).has_value(); });
}

std::size_t objective_place(const Study& study) {
  for (std::size_t k = 0; k < study.quantities.size(); ++k)
    if (study.quantities[k].name == study.objective) return k;
  return 0;
}

/// Counts for the display, for every engine.
class Meter {
 public:
  Meter(const StudySink& sink, const Plan& plan, long total, long done, long failed)
      : sink_(sink), plan_(plan) {
    state_.total = total;
    state_.done = done;
    state_.failed = failed;
  }
  /// A round more: the total of an adaptive study is known as it goes.
  void expect(long total, long done, long failed) {
    state_.total = std::max(state_.total, total);
    state_.done = done;
    state_.failed = failed;
  }
  void count(const Record& record, long rows) {
    state_.done += rows;
    computed_ += rows;
    if (record.exit_code != 0) {
      state_.failed += rows;
      state_.last_failure = record.message;
    }
    send(true);
  }
  void news(int workers, const std::string& note) {
    state_.workers = workers;
    state_.note = note;
    send(false);
  }

 private:
  void send(bool counted) {
    constexpr double kInterval = 0.2;  // [s]
    const double now = seconds_since(begin_);
    if (!sink_ || (now - sent_ < kInterval && !(counted && state_.done == state_.total))) return;
    sent_ = now;
    state_.elapsed = now;
    const auto left = static_cast<double>(state_.total - state_.done);
    state_.remaining = computed_ > 0 ? now / static_cast<double>(computed_) * left
                                     : left * plan_.pilot.wall / std::max(1, plan_.workers);
    sink_(state_);
  }
  const StudySink& sink_;
  const Plan& plan_;
  StudyProgress state_;
  long computed_ = 0;
  Clock::time_point begin_ = Clock::now();
  double sent_ = -1.0;
};

class Campaign {
 public:
  Campaign(const CampaignRequest& request, const StudySink& progress, std::stop_token stop)
      : request_(request),
        progress_(progress),
        stop_(std::move(stop)),
        study_(request.study),
        folder_(study_.folder()) {}

  CampaignOutcome run() {
    const auto begin = Clock::now();
    // Mistakes of the study file are reported before anything is run.
    std::vector<Point> points = initial_points(study_);
    check_decks(study_, points);
    place_.emplace(open_study_folder(folder_));
    const runs::FolderLock lock(*place_, kOtherNameRemedy);
    job_ = prepare_job(study_, *place_);
    add(points);
    if (request_.retry_failed) forget_failures();
    const Pilot pilot = measure(request_, folder_, tasks_, job_.keep_files, stop_);
    plan_ = plan_of(request_, study_, folder_, count_points(study_), count_known(tasks_, folder_),
                    pilot);
    if (!plan_.over_budget.empty() && !request_.over_budget)
      throw OverBudget(
          fmt::format("the study exceeds its budget: {}; make it smaller, raise the budget, or "
                      "give --over-budget",
                      plan_.over_budget));
    out_.known = count_known(tasks_, folder_);
    meter_.emplace(progress_, plan_, static_cast<long>(tasks_.size()), 0, 0);
    if (study_.kind == Kind::WorstCase) {
      search(std::move(points));
    } else {
      compute();
    }
    finish();
    out_.seconds = seconds_since(begin);
    return out_;
  }

 private:
  void add(const std::vector<Point>& points) {
    const std::vector<Task> more = make_tasks(job_, points, static_cast<long>(tasks_.size()) + 1);
    tasks_.insert(tasks_.end(), more.begin(), more.end());
    write_tasks(*place_, kTasks, tasks_);
  }

  void forget_failures() {
    for (const Task& task : tasks_)
      if (const auto record = read_record(folder_, task.key); record && record->exit_code != 0) {
        const fs::path file = run_record_path(folder_, task.key).lexically_relative(folder_);
        place_->folder(file.parent_path()).remove(file.filename().string());
      }
  }

  /// All tasks so far.
  void compute() {
    std::map<std::string, long> rows;
    long done = 0, failed = 0;
    for (const Task& task : tasks_) {
      ++rows[task.key];
      if (const auto record = read_record(folder_, task.key)) {
        ++done;
        if (record->exit_code != 0) ++failed;
      }
    }
    meter_->expect(static_cast<long>(tasks_.size()), done, failed);
    EngineRequest work;
    work.folder = fs::absolute(folder_);
    work.program = request_.program;
    work.workers = request_.workers;
    work.seconds_each = plan_.pilot.wall;
    work.megabytes_each = plan_.pilot.memory_megabytes;
    work.tasks = missing(tasks_, folder_);
    if (work.tasks.empty()) return;
    const Engine engine = request_.engine == "slurm" ? run_slurm : run_local;
    engine(
        work,
        [&](const Record& record) {
          ++out_.computed;
          meter_->count(record, rows[record.key]);
        },
        [&](int workers, const std::string& note) { meter_->news(workers, note); }, stop_);
  }

  void search(std::vector<Point> points) {
    WorstCaseSearch search(study_);
    const std::size_t objective = objective_place(study_);
    std::size_t from = 0;
    while (true) {
      compute();
      if (stop_.stop_requested()) return;
      std::vector<double> values;
      for (std::size_t i = from; i < tasks_.size(); ++i) {
        const auto record = read_record(folder_, tasks_[i].key);
        values.push_back(record && record->exit_code == 0 && objective < record->values.size()
                             ? record->values[objective]
                             : std::numeric_limits<double>::quiet_NaN());
      }
      from = tasks_.size();
      points = search.next(points, values);
      if (points.empty()) break;
      add(points);
    }
    out_.note =
        search.best().empty()
            ? "no run has a value for the objective of the study"
            : fmt::format(
                  "{}; final step size of the search: {:.3g} % of the range of each variable",
                  counted(search.rounds(), "round"), 100.0 * search.step());
  }

  void finish() {
    out_.runs = static_cast<long>(tasks_.size());
    for (const Task& task : tasks_)
      if (const auto record = read_record(folder_, task.key)) {
        ++out_.done;
        if (record->exit_code != 0) ++out_.failed;
      }
    out_.complete = out_.done == out_.runs && !stop_.stop_requested();
  }

  const CampaignRequest& request_;
  const StudySink& progress_;
  std::stop_token stop_;
  const Study& study_;
  fs::path folder_;
  std::optional<WriteFolder> place_;
  Job job_;
  std::vector<Task> tasks_;
  Plan plan_;
  std::optional<Meter> meter_;
  CampaignOutcome out_;
};

void require_started(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / kTasks, error))
    throw InputError(fmt::format(
        "{}: this study was never started; start it with `adore study run`", folder.string()));
}

}  // namespace

Study open_study(const fs::path& file) {
  return open_study_text(read_text_file(file, kMaxHandwrittenBytes), file);
}

Study open_study_text(const std::string& text, const fs::path& file) {
  Study study = parse_study(text, file);
  if (std::any_of(study.variables.begin(), study.variables.end(),
                  [](const Variable& v) { return v.is_group(); })) {
    runs::DeckRequest request;
    request.deck = study.decks.front();
    const deck::ReadResult read = runs::read_deck(request);
    expand_lots(study, static_cast<int>(std::max(1LL, read.deck.integer("nRe"))));
  }
  return study;
}

Plan make_plan(const CampaignRequest& request, const std::stop_token& stop) {
  const Study& study = request.study;
  const fs::path folder = study.folder();
  const std::vector<Point> points = initial_points(study);
  check_decks(study, points);
  const WriteFolder place = open_study_folder(folder);
  const runs::FolderLock lock(place, kOtherNameRemedy);
  const Job job = prepare_job(study, place);
  const std::vector<Task> tasks = make_tasks(job, points, 1);
  const Pilot pilot = measure(request, folder, tasks, job.keep_files, stop);
  return plan_of(request, study, folder, count_points(study), count_known(tasks, folder), pilot);
}

std::string plan_text(const CampaignRequest& request, const Plan& plan) {
  const Study& study = request.study;
  std::string out = fmt::format(
      "study:     {}, kind {}\nruns:      {}{}, {} of them already done\none run:   {:.3g} s "
      "({:.3g} s processor time), {:.3g} MB of memory, {:.3g} MB on disk during the run\nengine: "
      "   {}, parallel runs: {}\ntime:      {}\ndisk:      {:.3g} MB of results in {}, {:.3g} MB "
      "free\n",
      study.file.string(), kind_name(study.kind), study.kind == Kind::WorstCase ? "at most " : "",
      plan.runs, plan.known, plan.pilot.wall, plan.pilot.processor, plan.pilot.memory_megabytes,
      plan.pilot.passing_megabytes, request.engine, plan.workers,
      duration_text(plan.hours * 3600.0), plan.disk_megabytes, study.folder().string(),
      plan.free_disk_megabytes);
  if (!plan.pilot.trouble.empty())
    out += fmt::format("note:      a pilot run failed: {}\n", plan.pilot.trouble);
  out += plan.over_budget.empty() ? "budget:    not exceeded\n"
                                  : fmt::format("budget:    exceeded: {}\n", plan.over_budget);
  return out;
}

std::string progress_text(const StudyProgress& p) {
  return fmt::format("{} of {} runs done, {} failed, {} active; time left: {}{}{}", p.done, p.total,
                     p.failed, p.workers,
                     p.remaining >= 0.0 ? duration_text(p.remaining) : "unknown",
                     p.note.empty() ? "" : "; ", p.note);
}

std::string outcome_text(const CampaignOutcome& outcome) {
  return fmt::format(
      "{}: {} done, {} of them failed; {} computed now in {}, {} computed earlier{}{}",
      counted(outcome.runs, "run"), outcome.done, outcome.failed, outcome.computed,
      duration_text(outcome.seconds), outcome.known, outcome.note.empty() ? "" : "; ",
      outcome.note);
}

CampaignOutcome run_campaign(const CampaignRequest& request, const StudySink& progress,
                             const std::stop_token& stop) {
  return Campaign(request, progress, stop).run();
}

Results read_results(const Study& study) {
  const fs::path folder = study.folder();
  require_started(folder);
  Results out;
  out.tasks = read_tasks(folder / kTasks, study.decks.size());
  for (const Task& task : out.tasks) out.records.push_back(read_record(folder, task.key));
  return out;
}

std::vector<results::FileCheck> verify_study(const fs::path& folder) {
  using State = results::FileCheck::State;
  require_started(folder);
  std::vector<results::FileCheck> out;
  std::set<std::string> seen;
  long intact = 0;
  std::error_code error;
  for (const Task& task : read_tasks(folder / kTasks, read_job(folder).decks.size())) {
    const fs::path file = run_record_path(folder, task.key);
    if (!seen.insert(task.key).second || !fs::exists(file, error)) continue;
    if (read_record(folder, task.key))
      ++intact;
    else
      out.push_back({file, State::Damaged,
                     "the file does not match its checksum; `adore study resume` repeats the run"});
  }
  out.push_back(
      {folder / kTasks, State::Intact,
       fmt::format("{}, {} of them recorded and intact", counted(seen.size(), "run"), intact)});
  return out;
}

Status study_status(const Study& study) {
  const fs::path folder = study.folder();
  const Results results = read_results(study);
  Status out;
  out.runs = static_cast<long>(results.tasks.size());
  std::set<std::string> seen;
  for (std::size_t i = 0; i < results.tasks.size(); ++i) {
    const auto& record = results.records[i];
    if (!record) continue;
    ++out.done;
    if (record->exit_code == 0) continue;
    ++out.failed;
    std::string words;
    for (const char c : record->message)
      if ((c < '0' || c > '9') && c != '.') words += c;
    if (seen.insert(words).second)
      out.diagnoses.push_back(fmt::format("run {}: {}", results.tasks[i].number, record->message));
  }
  try {
    const runs::FolderLock lock(WriteFolder(folder), kOtherNameRemedy);
  } catch (const InputError&) {
    out.at_work = true;
  }
  return out;
}

}  // namespace adore::studies
