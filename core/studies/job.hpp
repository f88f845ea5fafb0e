#pragma once

#include "base/write_folder.hpp"
#include "studies/points.hpp"
#include "studies/study.hpp"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// The study's folder: what workers need to know, which runs there are, and one record for each
/// that is finished.
///
///   job.json         what all runs share; decks/K/NAME: the decks as they were
///   tasks.jsonl      one line per run of the table: number, key, what differs
///   runs/ab/KEY.json one record per finished run, written whole or not at all
///   files/KEY/       the run's own files, if the study keeps them
///   RUNS.csv STUDY.h5 TIMES.csv REPORT.txt   what comes of it
namespace adore::studies {

struct Job {
  struct BaseDeck {
    std::filesystem::path deck;  ///< copy in the study's folder
    Settings options;            ///< of the ADORE.json in the folder of the original
  };
  std::vector<BaseDeck> decks;
  Settings sets, options;
  std::string until, integrator;
  std::optional<double> tolerance;
  std::vector<Quantity> quantities;
  bool keep_files = false;
};

struct Task {
  long number = 0;  ///< line of the table, from 1
  std::string key;  ///< of what is computed: equal runs have equal keys
  Point point;
};

/// How a run ended, and what it says.
struct Record {
  std::string key;
  int exit_code = 0;               ///< 0 done, 2 refused, 3 failed or not to be trusted, 1 crashed
  std::vector<double> values;      ///< one per quantity; NaN: none
  std::string message;             ///< diagnosis, or missing data
  std::vector<std::string> codes;  ///< of its findings, each once, sorted
  // Measured.
  double processor = 0.0, wall = 0.0;  ///< [s]
  double memory_megabytes = 0.0, disk_megabytes = 0.0;
  std::string host;
};

/// Copies the decks and writes job.json. @throws InputError
[[nodiscard]] Job prepare_job(const Study& study, const WriteFolder& folder);
/// @throws InputError naming file, key and value
[[nodiscard]] Job read_job(const std::filesystem::path& folder);

/// Numbers and keys of the points. A key is the content hash of the deck with its sets as it is
/// written, options, end, method, tolerance, quantities and solver.
[[nodiscard]] std::vector<Task> make_tasks(const Job& job, const std::vector<Point>& points,
                                           long first_number);

/// Name of a file of tasks, in the folder of a study or of a submission.
inline constexpr const char* kTasks = "tasks.jsonl";

[[nodiscard]] std::string task_line(const Task& task);
/// Origin of a line of tasks, and the decks of its job.
struct TaskSource {
  std::string file;
  long line = 0;          ///< from 1
  std::size_t decks = 0;  ///< of the job: indices are below it
};
/// @throws InputError naming file, line, key and value
[[nodiscard]] Task parse_task(const std::string& line, const TaskSource& source);
/// tasks.jsonl, whole. @throws InputError
void write_tasks(const WriteFolder& folder, const std::string& name,
                 const std::vector<Task>& tasks);
/// @param decks of the job. Numbers of runs rise from line to line. @throws InputError naming file,
/// line, key and value
[[nodiscard]] std::vector<Task> read_tasks(const std::filesystem::path& file, std::size_t decks);

[[nodiscard]] std::filesystem::path run_record_path(const std::filesystem::path& folder,
                                                    const std::string& key);
/// Nothing when there is none, or a damaged one: the run is made again.
[[nodiscard]] std::optional<Record> read_record(const std::filesystem::path& folder,
                                                const std::string& key);
/// @param folder of the study @throws WriteError
void write_record(const std::filesystem::path& folder, const Record& record);

/// Computes one run. Nothing when it was interrupted, or a process that it needs was killed.
/// @throws WriteError when the disk is full,
/// which is not a result of the run.
[[nodiscard]] std::optional<Record> run_task(const Job& job, const Task& task,
                                             const std::filesystem::path& folder,
                                             const std::stop_token& stop);

}  // namespace adore::studies
