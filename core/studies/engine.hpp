#pragma once

#include "studies/job.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

/// Computes the runs. Every engine gives the same records: only place and time differ.
namespace adore::studies {

/// For a live display; sent at least once a second while runs are under way.
struct StudyProgress {
  long done = 0, total = 0, failed = 0;    ///< runs of this study, those of earlier starts included
  int workers = 0;                         ///< at work now
  double elapsed = 0.0, remaining = -1.0;  ///< [s]; negative: not known yet
  std::string note;                        ///< reason for waiting; may be empty
  std::string last_failure;                ///< diagnosis of the run that failed last
};
using StudySink = std::function<void(const StudyProgress&)>;

/// A run that is finished: its record is on the disk.
using TaskDone = std::function<void(const Record&)>;
/// The engine's own words on how many work and what it waits for.
using EngineNews = std::function<void(int workers, const std::string& note)>;

struct EngineRequest {
  std::filesystem::path folder;   ///< of the study
  std::filesystem::path program;  ///< `adore` itself: its command `study work` computes
  int workers = 0;                ///< at a time; 0: as many as cores and memory allow
  double seconds_each = 0.0;      ///< measured by the pilot run [s]
  double megabytes_each = 0.0;    ///< memory of one worker, measured
  std::vector<Task> tasks;        ///< no two with one key
};

/// Computes tasks until all have a record, or `stop`. @throws WriteError when the disk is full or a
/// file cannot be written: what is recorded stays. @throws InputError when the engine cannot work
/// here.
using Engine = void (*)(const EngineRequest& work, const TaskDone& done, const EngineNews& news,
                        const std::stop_token& stop);

/// Crashes (SIGSEGV ...) of a run, after which the crash is recorded as its result.
inline constexpr int kMaxCrashes = 2;
/// Kills of a run from outside, after which it has no result: no study runs forever.
inline constexpr int kMaxKills = 20;
/// Exit code of a worker that could not write: EX_TEMPFAIL of sysexits.h.
inline constexpr int kWriteFailedExit = 75;

void run_local(const EngineRequest& work, const TaskDone& done, const EngineNews& news,
               const std::stop_token& stop);
void run_slurm(const EngineRequest& work, const TaskDone& done, const EngineNews& news,
               const std::stop_token& stop);

/// The worker's side of the local engine: a task a line on standard input, an answer a line on
/// standard output, "done KEY" or "halt SENTENCE". @return exit code
int run_tasks_from_stdin(const std::filesystem::path& folder, const std::stop_token& stop);
/// The worker's side of Slurm's: lines `first` to `first + count - 1` (from 0) of a file of tasks,
/// those without a record. @return exit code: 0, 75 (try again later) when a file cannot be
/// written
int run_tasks_from_file(const std::filesystem::path& folder, const std::filesystem::path& tasks,
                        long first, long count, const std::stop_token& stop);

/// Cores that this process may use.
[[nodiscard]] int usable_cores();
/// Memory that new processes may take [MB]: of the machine, or of the control group if that has
/// less.
[[nodiscard]] double available_memory_megabytes();

}  // namespace adore::studies
