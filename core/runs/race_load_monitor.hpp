#pragma once

#include "dynamics/race_load.hpp"

#include <algorithm>

/// Ends a run in mode 2 whose elements do not carry the specified load of the inner race.
///
/// That race has no inertia: it moves to where the elements carry its load, and a difference decays
/// within a few of the elements' characteristic times √(m/k) (dynamics/balanced_race.hpp): to 1e-9
/// of the load without friction, to 5e-6 to 0.08 of it, in the mean of such times, from rest,
/// through zero, under a rotating load and with a cage at half its speed (decision 561). Rollers
/// with little contact, because gravity, heat or the cage act on them more than the load does, open
/// and close about their balance; nothing then holds the race, its steps shrink, and the result is
/// not a motion of a bearing. So the mean magnitude of the difference is formed over windows of
/// kWindowLength such times; where it is above kMaxDifference of the load, and the steps are
/// kShortStepRatio times more than the longest would be (a tolerance of 1e-9 takes less than twice
/// as many), in kMaxWindows consecutive windows, the run ends with that cause. Balls that a light
/// load leaves to their centrifugal force differ as much at such steps: they continue, and the run
/// warns of the actual load (results/mean_load.hpp).
namespace adore::runs {

class RaceLoadMonitor {
 public:
  static constexpr double kWindowLength = 40.0;
  static constexpr double kMaxDifference = 0.1;
  static constexpr double kShortStepRatio = 10.0;
  static constexpr int kMaxWindows = 3;

  /// @param time_scale √(m/k) [s]
  /// @param longest step of the run [s]
  RaceLoadMonitor(double time_scale, double longest)
      : window_length_(kWindowLength * time_scale), longest_step_(std::min(longest, time_scale)) {}
  /// After every step of the integration, counted (nStps) or not; does nothing if no
  /// race is in balance.
  /// @param contact largest contact load now [N]: kMaxDifference refers to the specified load or,
  /// if larger, to results::kLoadFloor of this one (a small load on preloaded contacts)
  /// @throws SolverError
  void check(double t, const dynamics::RaceLoad& load, double contact = 0.0);

 private:
  void begin(double t) noexcept;

  double window_length_, longest_step_;  ///< [s]
  bool window_open_ = false;
  double window_start_ = 0.0, last_time_ = 0.0;  ///< of the window; the step before [s]
  double difference_integral_ = 0.0,
         specified_load_integral_ = 0.0;  ///< integrals over the window [N s]
  long window_steps_ = 0;                 ///< in it
  int bad_windows_ = 0;                   ///< consecutive windows above the limits
};

}  // namespace adore::runs
