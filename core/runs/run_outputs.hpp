#pragma once

#include "integrators/stepper.hpp"
#include "results/averages.hpp"
#include "results/energy_judgement.hpp"
#include "runs/output_folder.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"
#include "runs/thermal_run.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// All files of one run: which step goes where, restart, checkpoints, and the closing ledgers.
namespace adore::runs {

/// Position of the run inside a counted step, and the stepper's memory there: needed,
/// in addition to time and state, to continue without a break.
struct Resume {
  long substeps = 0;  ///< done of the counted step under way (nStps)
  integrators::Memory memory;
  integrators::Counters counters;  ///< of the whole run so far, however often it was continued
  long held_changes = 0;           ///< steps after which elements were held or released (qFac)
  /// Error estimates of the steps (StepInfo::error, in tolerances), added up, and the largest.
  double error_sum = 0.0, error_largest = 0.0;
  /// Tolerance in force where films need a tighter one than the deck's (film_tolerance.hpp), time
  /// under such a one [s] and the tightest so far; 0: none.
  double tolerance = 0.0, tight_time = 0.0, tightest = 0.0;
};

/// One instant of the run.
struct RunPoint {
  long step = 0;
  double time = 0.0, step_size = 0.0;  ///< [s]
  std::span<const double> y;
};

struct StartPoint {
  std::vector<double> y;
  double time = 0.0;
  long step = 0;
  double step_size = 0.0;  ///< last step of the run that is continued [s]; 0 for a new one
  bool continued = false;
  bool at_rest = false;   ///< moved to the rest position (rest_watch.hpp)
  Resume resume;          ///< of the run that is continued; memory empty: its stepper starts anew
  long segment = 0;       ///< step from which maxStps counts
  bool complete = false;  ///< the run that is continued has its last page
  /// Of the last step in SOL7, SOL8 or PRINT.txt, which is behind the checkpoint when the run was
  /// killed.
  long stored_step = 0;
  double stored_time = 0.0;    ///< of that record, to the digits of the files [s]
  double turned_before = 0.0;  ///< shaft rotation beyond speed times time: of earlier speeds [rad]
};

struct RunEnd {
  RunStatus status = RunStatus::Done;
  std::string message;
  RunPoint point;
  Resume resume;
  double loop_seconds = 0.0;
};

class RunOutputs {
 public:
  /// `request`: digest for RUN.json. `overwrite`: results of an earlier run may be replaced
  /// (runs/output_folder.hpp).
  RunOutputs(const Prepared& prepared, const RunPlace& place, std::string request, bool overwrite);
  ~RunOutputs();

  /// A quasi-static deck's only output: PRINT.txt and RUN.json. @return the results in a few lines
  std::vector<std::string> write_quasi_static();

  /// Finds the start state (statics, FINAL, or MASTER's run) and checks every file that will be
  /// written; touches none.
  [[nodiscard]] StartPoint find_start_point(dynamics::System& system, setup::StartState start);
  /// Opens every file for a run from there, and writes the front part of PRINT.txt.
  void open(dynamics::System& system, const StartPoint& start);
  /// The thermal analysis whose last step every instant shows, and the bearing that it has left;
  /// outlives these outputs.
  void set_thermal_run(const ThermalRun& thermal);
  /// A thermal step is done: into PRINT.txt, and its temperatures into all that is stored later.
  void thermal_step(const ThermalRun::Step& step, double time);
  /// A finding for RUN.json, RESULTS.h5, the last page and remarks().
  void remark(Finding finding);
  /// Does any file store this step? (print, plot and animation intervals)
  [[nodiscard]] bool wants(long step) const;
  /// Stores a point in the files whose interval it meets; `always` in all of them (first and last
  /// step).
  void store(dynamics::System& system, const RunPoint& point, bool always);
  /// Routines of the user at the end of a counted step; what they write goes to SOL9.
  /// @throws SolverError
  void call_user_routines(dynamics::System& system, const RunPoint& point);
  /// Follows what averages need between stored points; after every counted step.
  void follow(const RunPoint& point);
  /// Follows what is shown of the steps between stored points, and the mean loads; after every
  /// integration step, which ended at that time [s].
  /// @param stored RESULTS.h5 will have this state: it is looked at as it is stored
  void follow_step(const dynamics::System& system, double time, bool stored);
  /// Must the life of the run see this step as a snapshot? Depends on no output interval.
  [[nodiscard]] bool life_due() const;
  /// The start of a run, or a counted step that was followed and whose life_due().
  void evaluate_life(dynamics::System& system, const RunPoint& point);
  /// After a counted step, its state or its bearing has jumped (elements held or
  /// released, a thermal step): extremes between stored steps include both sides.
  void sample_state_jump(const dynamics::System& system, bool stored);
  /// Will RESULTS.h5 have this step? @param last of the run: all files do
  [[nodiscard]] bool saves(long step, bool last) const;
  /// Has the checkpoint interval of computing time passed?
  [[nodiscard]] bool checkpoint_due() const;
  /// FINAL and MASTER of this point, from where the run can be continued. Points stored later are
  /// dropped when it is.
  void checkpoint(dynamics::System& system, const RunPoint& point, Resume resume);
  /// The last point; FINAL and MASTER unless the run failed after a checkpoint.
  void store_last_point(dynamics::System& system, const RunEnd& end);
  /// The ledgers of PRINT.txt, and RUN.json. @pre store_last_point
  void finish(dynamics::System& system, const RunEnd& end);

  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  [[nodiscard]] results::KeyResults summary() const;
  [[nodiscard]] results::MeanSeries means() const;
  /// Of the last stored instant and the worst before, against the elastic energy of the
  /// quasi-static solution.
  [[nodiscard]] results::EnergyJudgment judge_energy() const;
  /// Why a law makes the results untrusted (runs/law_ranges.hpp); empty: none does.
  [[nodiscard]] std::string untrusted_law_reason() const;
  /// A sentence when the elements carried another load than the deck asks; empty when not.
  [[nodiscard]] std::string load_warning() const;
  /// Notes on the deck from the start and end of the run.
  [[nodiscard]] std::vector<Finding> remarks() const;
  [[nodiscard]] double energy_residual() const;  ///< [J]
  [[nodiscard]] double energy_scale() const;     ///< [J]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace adore::runs
