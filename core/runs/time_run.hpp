#pragma once

#include "runs/film_tolerance.hpp"
#include "runs/progress_meter.hpp"
#include "runs/race_load_monitor.hpp"
#include "runs/rest_watch.hpp"
#include "runs/ring_growth.hpp"
#include "runs/step_watch.hpp"
#include "runs/system_ode.hpp"
#include "runs/thermal_run.hpp"

#include <optional>
#include <stop_token>

/// The steps of a run in time, and what is done between them.
namespace adore::runs {

/// Parts of a run in time; all of them outlive the TimeRun.
struct RunParts {
  Prepared& prepared;
  std::optional<dynamics::System>&
      system;  ///< present; thermal steps put another one into its place
  SystemOde& ode;
  integrators::Stepper& stepper;
  RunOutputs& outputs;
  ThermalRun* thermal;  ///< null: no thermal analysis
  const RingGrowth& growth;
  ProgressMeter& meter;
  const std::filesystem::path& master;
};

class TimeRun {
 public:
  /// @param last counted step that the run may make
  TimeRun(const RunParts& parts, const StartPoint& start, const RunSpan& span, long last,
          const integrators::StepControl& control, std::stop_token stop);

  /// From the start point to the end, an interruption or a diagnosed failure, with the last point
  /// stored and the energy judged; then the ledgers.
  /// @param remembers the stepper continues with its memory at the start point
  /// @throws InputError when that is incomplete
  RunOutcome run(bool remembers);

 private:
  [[nodiscard]] dynamics::System& system() noexcept { return *parts_.system; }
  [[nodiscard]] RunPoint point() const {
    return {step_, started_ ? parts_.stepper.time() : start_.time, h_, state()};
  }
  /// A stepper that refused to start has none.
  [[nodiscard]] std::span<const double> state() const {
    return started_ ? parts_.stepper.state() : std::span<const double>(start_.y);
  }
  /// Data for a continuation from here.
  [[nodiscard]] Resume resume(bool failed) const;
  /// Does something whose time is the output's.
  template <class Action>
  void output(Action&& action);

  void begin(bool remembers);
  void steps();
  /// nStps steps, fewer at the end of the run. @return false: somebody stopped the run
  [[nodiscard]] bool take_counted_step();
  void after_counted_step();
  /// One counted step of a bearing at rest, without integration; false: it moves.
  [[nodiscard]] bool take_rest_step();
  void checkpoint();
  void check_race_load();
  /// Another tolerance while films break down (film_tolerance.hpp).
  void adapt_tolerance();
  /// Light-load balance: after a finished step elements may be held or released; the stepper then
  /// starts anew from the changed state with its last step size. @returns whether any was
  bool update_held_elements();
  /// Thermal analysis: the window is full; the state continues in the new geometry, and the stepper
  /// restarts.
  void thermal_step();
  void add_thermal_remark(const ThermalRun::Step& done, bool settles);
  void restart_stepper(std::span<const double> y);
  void start_stepper_at(double t, std::span<const double> y);
  /// Continues y in the system of a changed bearing, moved to its equilibrium. @throws SolverError
  void move_into_system(dynamics::System next, double t, std::span<double> y,
                        const std::string& cause);
  /// The geometry goes with the speeds (ring_growth.hpp). @returns whether it changed
  bool apply_ring_growth();
  void fail(const std::string& why);
  /// The last point, and what is wrong with the run as a whole.
  void close(RunEnd& end);
  /// Seconds of the loop, of which what is neither right-hand side nor output is the stepper's.
  [[nodiscard]] double count_loop_time();
  void fill_outcome(RunOutcome& out, const RunEnd& end) const;

  RunParts parts_;
  StartPoint start_;
  RunSpan span_;
  long last_counted_step_;
  integrators::StepControl control_;
  std::stop_token stop_;
  StepErrorMonitor step_error_monitor_;
  RaceLoadMonitor race_load_monitor_;
  FilmTolerance film_tolerance_;
  RestDetector rest_detector_;
  double rest_start_time_ = -1.0;  ///< of the first step without integration [s]; below 0: none
  const RingGrowth& growth_;
  RingGrowth::Levels growth_levels_{};
  bool started_ = false;  ///< the stepper took the start state
  RunStatus status_ = RunStatus::Done;
  std::string message_;

  long step_;
  long substeps_;  ///< done of the counted step under way
  double h_;       ///< last step [s]
  /// Of the run before this process, and of the stepper before its last start.
  integrators::Counters counters_;
  long held_changes_;
  bool films_uncertain_ = false;              ///< by the last thermal step
  bool temperature_growth_reported_ = false;  ///< a remark said that temperature changes grow
  double error_sum_, error_largest_;          ///< in tolerances of the deck
  double reduced_tolerance_time_, smallest_tolerance_;  ///< Resume

  int stepper_cost_entry_, output_cost_entry_;  ///< entries of the ledger
  double loop_start_seconds_ = 0.0;             ///< [s] of the processor, as all of the ledger
  double output_seconds_ = 0.0;
};

}  // namespace adore::runs
