#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/write_error.hpp"
#include "studies/engine.hpp"
#include "studies/slurm.hpp"
#include "studies/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <set>
#include <thread>

/// Job arrays: each element computes a part of the list, run by run, and skips runs with a record.
/// So a part that Slurm requeues (node failure) or that is submitted again (time limit, memory)
/// loses at most its current run. Records show the progress, never the messages of Slurm;
/// Slurm is only asked why a part ended without them.
namespace adore::studies {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

/// Times that a run may reach its time or memory limit.
constexpr int kMaxLimitHits = 4;
/// Consecutive submissions without a record.
constexpr int kMaxFruitlessJobs = 5;
/// Computing time of an array task; its start takes about 1 s.
constexpr double kPieceSeconds = 120.0;
/// Time and memory limits over the estimates from the pilot runs, and their least values.
constexpr double kTimeLimitFactor = 4.0, kMemoryLimitFactor = 2.0, kMinMegabytes = 256.0;
constexpr int kMinMinutes = 2;
constexpr const char* kCurrent = "current.json";
constexpr const char* kSubmission = "submission";  ///< folders: submission-1, submission-2 ...

bool is_submission(const std::string& name) {
  const std::string stem = std::string(kSubmission) + "-";
  return name.starts_with(stem) && name.size() > stem.size() &&
         name.find_first_not_of("0123456789", stem.size()) == std::string::npos;
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// A death that is not caused by the run: it gives no record. A shell reports a signal as
/// exit code 128 + signal.
bool was_killed_externally(const SlurmExitState& end) {
  constexpr int kShellSignalBase = 128;
  for (const int signal : {SIGKILL, SIGTERM, SIGINT, SIGHUP})
    if (end.signal == signal || end.exit_code == kShellSignalBase + signal) return true;
  return false;
}

/// The kernel reports it to Slurm if control groups limit memory. If Slurm checks it itself
/// (OverMemoryKill) the job fails by SIGKILL, and only its last output shows the cause.
bool exceeded_memory(const SlurmExitState& end, const std::string& task_output) {
  if (end.state == "OUT_OF_MEMORY") return true;
  return end.state == "FAILED" &&
         (task_output.find("Exceeded job memory limit") != std::string::npos ||
          task_output.find("exceeded memory limit") != std::string::npos);
}

class SlurmEngine {
 public:
  SlurmEngine(const EngineRequest& work, const TaskDone& done, const EngineNews& news,
              const std::stop_token& stop)
      : work_(work),
        done_(done),
        news_(news),
        stop_(stop),
        place_(open_study_folder(work.folder).folder("slurm")),
        folder_(place_.path()) {
    for (const Task& task : work.tasks) left_.insert(&task);
    cores_ = slurm_cores();
    megabytes_ = std::max(kMinMegabytes, kMemoryLimitFactor * work.megabytes_each);
  }

  void run() {
    if (resume_job()) watch();  // a job of a driver that was killed
    while (!left_.empty() && !stop_.stop_requested()) {
      const std::size_t before = left_.size();
      submit();
      watch();
      if (stop_.stop_requested()) break;
      fruitless_ = left_.size() < before ? 0 : fruitless_ + 1;
      killed_ = limited_ = 0;
      if (!left_.empty()) find_causes();
      if (killed_ > 0 || limited_ > 0) fruitless_ = 0;  // bounded by kMaxKills and kMaxLimitHits
      forget_job();
      if (fruitless_ >= kMaxFruitlessJobs)
        throw InputError(fmt::format(
            "--engine slurm: {} consecutive submissions gave no result: {}. The output of the jobs "
            "is in {}",
            kMaxFruitlessJobs, reason_.empty() ? "Slurm gives no reason" : reason_,
            folder_.string()));
    }
    if (stop_.stop_requested())
      cancel();
    else if (given_up_ > 0)
      throw InputError(
          fmt::format("{} no result, because the process was killed {} times. All other "
                      "runs are recorded. Continue with `adore study resume --engine slurm`",
                      counted(given_up_, "run has", "runs have"), kMaxKills));
  }

 private:
  [[nodiscard]] std::string job_name() const { return "adore-" + work_.folder.stem().string(); }
  [[nodiscard]] fs::path current() const { return folder_ / kCurrent; }

  bool resume_job() {
    std::error_code error;
    if (!fs::exists(current(), error)) return false;
    try {
      const Json json = parse_json<Json>(read_text_file(current()), current().string());
      job_ = json.at("job").get<std::string>();
      piece_ = json.at("piece").get<long>();
      const std::string folder = json.at("folder").get<std::string>();
      if (!is_slurm_job(job_) || piece_ < 1 || !is_submission(folder)) throw InputError("damaged");
      submission_ = folder_ / folder;
      batch_ = read_tasks(submission_ / kTasks, read_job(work_.folder).decks.size());
    } catch (const std::exception&) {
      forget_job();
      return false;
    }
    return true;
  }

  void forget_job() {
    place_.remove(kCurrent);
    job_.clear();
  }

  void submit() {
    batch_.clear();
    for (const Task& task : work_.tasks)
      if (left_.contains(&task)) batch_.push_back(task);
    const auto n = static_cast<double>(batch_.size());
    // Pieces long enough that their start does not matter, and four to a core, so that all end at
    // nearly the same time; no more of them than an array may have.
    const double by_time = kPieceSeconds / std::max(1e-3, work_.seconds_each);
    const double by_share = n / (4.0 * cores_);
    const double by_array = n / static_cast<double>(slurm_max_array_size() - 1);
    piece_ = static_cast<long>(std::ceil(std::max({1.0, std::min(by_time, by_share), by_array})));
    const long elements = (static_cast<long>(batch_.size()) + piece_ - 1) / piece_;
    const int minutes =
        minutes_ +
        static_cast<int>(std::ceil(more_time_ * kTimeLimitFactor * static_cast<double>(piece_) *
                                   std::max(0.05, work_.seconds_each) / 60.0));
    // A new folder: Slurm itself writes into it, and follows links.
    const WriteFolder place = place_.new_folder(kSubmission);
    submission_ = place.path();
    const fs::path tasks = submission_ / kTasks, script = submission_ / "job.sh";
    write_tasks(place, kTasks, batch_);
    write_file_atomically({place, "job.sh"},
                          fmt::format("#!/bin/sh\nexec {} study work {} --tasks {} --first "
                                      "$((SLURM_ARRAY_TASK_ID * {})) --count {}\n",
                                      quoted(work_.program.string()), quoted(work_.folder.string()),
                                      quoted(tasks.string()), piece_, piece_));
    std::string array = fmt::format("--array=0-{}", elements - 1);
    if (work_.workers > 0) array += fmt::format("%{}", work_.workers);
    std::string rejection;
    const auto answer = command_output(
        {"sbatch", "--parsable", array, "--requeue", "--open-mode=append", "--ntasks=1",
         "--cpus-per-task=1", fmt::format("--time={}", minutes),
         fmt::format("--mem={:.0f}M", std::ceil(more_memory_ * megabytes_)),
         "--job-name=" + job_name(), "--output=" + (submission_ / "said-%A_%a.txt").string(),
         "--chdir=" + work_.folder.string(), script.string()},
        &rejection);
    if (!answer || answer->empty())
      throw InputError(fmt::format("--engine slurm: sbatch rejected the job: {}",
                                   rejection.substr(0, rejection.find('\n'))));
    job_ = answer->substr(0, answer->find_first_of(";\n"));
    if (!is_slurm_job(job_))
      throw InputError("--engine slurm: sbatch returned no job number: " + *answer);
    write_into_study(
        place_, kCurrent,
        dump_json(
            Json{{"job", job_}, {"piece", piece_}, {"folder", submission_.filename().string()}}) +
            "\n");
  }

  /// Records that are new.
  void collect() {
    for (auto task = left_.begin(); task != left_.end();) {
      std::error_code error;
      const auto record = fs::exists(run_record_path(work_.folder, (*task)->key), error)
                              ? read_record(work_.folder, (*task)->key)
                              : std::nullopt;
      if (!record) {
        ++task;
        continue;
      }
      task = left_.erase(task);
      done_(*record);
    }
  }

  /// Until the job is over.
  void watch() {
    constexpr double kMinWait = 0.5, kWaitPerQuery = 20.0;  // [s], [-]
    while (!stop_.stop_requested()) {
      const auto begin = Clock::now();
      const auto queue = slurm_queue(job_);
      collect();
      if (left_.empty() && (!queue || queue->empty())) return;
      if (queue && queue->empty()) return;
      if (!queue) {
        news_(0, "Slurm does not respond; waiting for it");
      } else {
        int running = 0, waiting = 0;
        for (const auto& [state, count] : *queue)
          (state == "RUNNING" || state == "COMPLETING" ? running : waiting) += count;
        news_(running, waiting > 0
                           ? fmt::format("job {}, {}", job_,
                                         counted(waiting, "array task waits", "array tasks wait"))
                           : fmt::format("job {}", job_));
      }
      const double looked = std::chrono::duration<double>(Clock::now() - begin).count();
      const auto until =
          Clock::now() + std::chrono::duration<double>(std::max(kMinWait, kWaitPerQuery * looked));
      while (Clock::now() < until && !stop_.stop_requested())
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

  [[nodiscard]] std::string task_output(long element) const {
    try {
      return read_text_file(submission_ / fmt::format("said-{}_{}.txt", job_, element));
    } catch (const InputError&) {
      return {};
    }
  }

  /// Why pieces of the job that is over have no record for all their runs.
  void find_causes() {
    const std::map<long, SlurmExitState> ends = slurm_exit_states(job_);
    std::map<std::string, const Task*> open;
    for (const Task* task : left_) open[task->key] = task;
    bool time_was_short = false, memory_was_short = false;
    for (const auto& [element, end] : ends) {
      // The first run of the piece without a record was under way.
      const Task* culprit = nullptr;
      for (long i = element * piece_;
           i < (element + 1) * piece_ && i < static_cast<long>(batch_.size()); ++i)
        if (const auto found = open.find(batch_[static_cast<std::size_t>(i)].key);
            found != open.end()) {
          culprit = found->second;
          break;
        }
      if (culprit == nullptr || end.state == "COMPLETED") continue;
      reason_ = fmt::format("an array task of the job ended in the state {}", end.state);
      if (end.exit_code == kWriteFailedExit) {
        const std::string text = task_output(element);
        const std::size_t at = text.rfind("halt ");
        forget_job();
        throw WriteError(at == std::string::npos
                             ? "a worker process could not write the record of its run"
                             : text.substr(at + 5, text.find('\n', at) - at - 5));
      }
      const bool late = end.state == "TIMEOUT" || end.state == "DEADLINE";
      if (late || exceeded_memory(end, task_output(element))) {
        (late ? time_was_short : memory_was_short) = true;
        ++limited_;
        if (++limits_[culprit->key] < kMaxLimitHits) continue;
        record_limit(*culprit, late);
        left_.erase(culprit);
        open.erase(culprit->key);
      } else if (end.state == "CANCELLED") {
        forget_job();
        throw InputError(
            "the job was canceled in Slurm; finished runs are recorded. Continue with `adore study "
            "resume`");
      } else if (end.state == "FAILED" && was_killed_externally(end)) {
        ++killed_;
        if (++kills_[culprit->key] < kMaxKills) continue;
        ++given_up_;
        left_.erase(culprit);
        open.erase(culprit->key);
      } else if (end.state == "FAILED" && ++deaths_[culprit->key] >= kMaxCrashes) {
        record_crash(*culprit, end, task_output(element));
        left_.erase(culprit);
        open.erase(culprit->key);
      }
    }
    // Once, however many pieces of the job met it.
    if (time_was_short) {
      more_time_ = std::min(64.0, 2.0 * more_time_);
      minutes_ = std::min(1440, 2 * minutes_);
    }
    if (memory_was_short) more_memory_ = std::min(64.0, 2.0 * more_memory_);
  }

  void record_limit(const Task& task, bool late) {
    Record record;
    record.key = task.key;
    record.exit_code = 3;
    record.values.assign(read_job(work_.folder).quantities.size(),
                         std::numeric_limits<double>::quiet_NaN());
    record.message = fmt::format(
        "Slurm ended the run at its {} limit {} times, although the limit was doubled each time. "
        "The run needs far more time or memory than the pilot runs. Examine the run separately, "
        "then repeat it with --retry-failed",
        late ? "time" : "memory", kMaxLimitHits);
    write_record(work_.folder, record);
    done_(record);
  }

  void record_crash(const Task& task, const SlurmExitState& end, const std::string& text) {
    Record record;
    record.key = task.key;
    record.exit_code = 1;
    record.values.assign(read_job(work_.folder).quantities.size(),
                         std::numeric_limits<double>::quiet_NaN());
    constexpr std::size_t kShownOutput = 200;
    record.message = fmt::format(
        "the process of this run ended with {} (exit code {}, signal {}), {}. {}. Repeat the run "
        "with --retry-failed",
        end.state, end.exit_code, end.signal, counted(deaths_[task.key], "time"),
        text.empty() ? "It had no output"
                     : "The end of its output is: " +
                           text.substr(text.size() - std::min(kShownOutput, text.size())));
    write_record(work_.folder, record);
    done_(record);
  }

  void cancel() {
    // Of this name only: the number comes from a file.
    (void)command_output({"scancel", "--name=" + job_name(), job_});
    constexpr int kCancelPolls = 100;  // of 100 ms: the runs under way end at once
    for (int i = 0; i < kCancelPolls; ++i) {
      const auto queue = slurm_queue(job_);
      if (!queue || queue->empty()) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    collect();
    forget_job();
  }

  const EngineRequest& work_;
  const TaskDone& done_;
  const EngineNews& news_;
  std::stop_token stop_;
  WriteFolder place_;
  fs::path folder_, submission_;
  std::set<const Task*> left_;
  std::vector<Task> batch_;
  std::string job_, reason_;
  long piece_ = 1;
  int cores_ = 1, minutes_ = kMinMinutes, fruitless_ = 0;
  double more_time_ = 1.0, more_memory_ = 1.0, megabytes_ = 0.0;
  std::map<std::string, int> deaths_, kills_, limits_;
  long limited_ = 0;                ///< pieces of the last job that met a limit
  long killed_ = 0, given_up_ = 0;  ///< pieces of the last job, and runs left for it
};

}  // namespace

void run_slurm(const EngineRequest& work, const TaskDone& done, const EngineNews& news,
               const std::stop_token& stop) {
  SlurmEngine(work, done, news, stop).run();
}

}  // namespace adore::studies
