#pragma once

#include "base/errors.hpp"
#include "results/file_sums.hpp"
#include "studies/engine.hpp"

/// A whole study: points, engines, records, rounds.
namespace adore::studies {

/// parse_study() of a file, its lots with an element for each of the first deck. @throws InputError
[[nodiscard]] Study open_study(const std::filesystem::path& file);
/// The same for an unsaved text; `file` names it, and its decks are in the folder of that file.
[[nodiscard]] Study open_study_text(const std::string& text, const std::filesystem::path& file);

/// The plan exceeds the budget of the study, or the disk.
class OverBudget : public InputError {
 public:
  using InputError::InputError;
};

struct CampaignRequest {
  Study study;                    ///< of open_study()
  std::string engine = "local";   ///< or "slurm"
  std::filesystem::path program;  ///< see EngineRequest
  int workers = 0;
  bool retry_failed = false;  ///< repeat runs whose record reports a failure
  bool over_budget = false;   ///< the user has seen the plan and starts the study anyway
};

struct CampaignOutcome {
  long runs = 0, done = 0, failed = 0;  ///< of the table; done includes failed
  long computed = 0, known = 0;         ///< now; of earlier starts or of equal runs
  double seconds = 0.0;
  bool complete = false;
  std::string note;  ///< worst case: how the search ended
};

/// The first run of each deck, and its cost. It is a record like any other, so it is not lost.
struct Pilot {
  double wall = 0.0, processor = 0.0;  ///< [s]
  double memory_megabytes = 0.0;
  double disk_megabytes = 0.0;     ///< that stay: the record, and the files if they are kept
  double passing_megabytes = 0.0;  ///< of one run while it is under way
  std::string trouble;             ///< why it failed; empty: it did not
};

struct Plan {
  long runs = 0, known = 0;  ///< all; that have their record already
  Pilot pilot;
  int workers = 1;
  double hours = 0.0, disk_megabytes = 0.0, free_disk_megabytes = 0.0;
  std::string over_budget;  ///< limits of the study or the disk that are exceeded; empty: none
};

/// Measures the pilot (in the middle of the points: neither the easiest nor the hardest corner) in
/// this process and estimates the cost of the study. @throws InputError, Interrupted
[[nodiscard]] Plan make_plan(const CampaignRequest& request, const std::stop_token& stop);
[[nodiscard]] std::string plan_text(const CampaignRequest& request, const Plan& plan);

/// "3 of 18 runs done, 0 failed, 2 active, 0.4 s left"
[[nodiscard]] std::string progress_text(const StudyProgress& progress);
/// "18 runs: 18 done, 0 of them failed; 15 computed now in 0.4 s, 3 known before"
[[nodiscard]] std::string outcome_text(const CampaignOutcome& outcome);

/// Runs what has no record yet. Interrupted studies come back `complete` false.
/// @throws InputError (over budget, wrong pilot, engine), WriteError (disk full)
CampaignOutcome run_campaign(const CampaignRequest& request, const StudySink& progress,
                             const std::stop_token& stop);

/// Contents of the folder. @throws InputError when the study was never started.
struct Status {
  long runs = 0, done = 0, failed = 0;
  bool at_work = false;                ///< a driver is running
  std::vector<std::string> diagnoses;  ///< of failed runs, with number; those alike once
};
/// The study's list of runs and the record of each, as far as there is one. @throws InputError when
/// the folder is none of a study that was started
[[nodiscard]] std::vector<results::FileCheck> verify_study(const std::filesystem::path& folder);

[[nodiscard]] Status study_status(const Study& study);

/// All tasks and their records, in the order of the table.
struct Results {
  std::vector<Task> tasks;
  std::vector<std::optional<Record>> records;
};
/// @throws InputError when the study was never started.
[[nodiscard]] Results read_results(const Study& study);

}  // namespace adore::studies
