#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "dynamics/state_layout.hpp"
#include "results/cage_whirl.hpp"
#include "results/motion.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// State of the cage in a run, as a finding: centered, whirling or unstable.
///
/// Law: results/cage_whirl.hpp, over the second half of the run (the first belongs to the start),
/// as the cage map of a study judges it. "Centered" is its class resting: the orbit of the center
/// about its own mean place is below kRestingOrbit of the clearance. "Unstable" is its class
/// irregular: a wide orbit without a steady whirl speed. The center is divided by
/// results::cage_length_scale. Whether the cage yields is a separate finding (motion_watch.hpp).
///
/// Not judged: a cage of several segments (it has no single center), and a run whose second half
/// covers less than kMinCageRevolutions of the cage.
namespace adore::runs {

class CageStateMonitor {
 public:
  /// Estimate: one whirl at the speed of the cage.
  static constexpr double kMinCageRevolutions = 1.0;
  static constexpr std::size_t kMaxInstants = 8192;

  /// @param unit_length of the deck [m], for results::cage_length_scale
  CageStateMonitor(const bearing::Bearing& bearing, double unit_length);
  /// Finds the cage in the state of a run.
  void follow(const dynamics::StateLayout& layout);
  /// After each counted step.
  void add_step(double time, std::span<const double> y);
  /// Empty: the bearing has no cage, or nothing was followed.
  [[nodiscard]] std::optional<Finding> finding() const;

 private:
  bool has_cage_ = false;
  double scale_ = 1.0;
  results::CageLengthScale::Of of_ = results::CageLengthScale::Of::UnitOfLength;
  int segment_count_ = 0, position_index_ = -1, velocity_index_ = -1, omega_index_ = -1;
  /// Every `sampling_interval_`-th instant; where there are too many, every second of them goes.
  std::vector<double> times_;
  std::vector<results::CageInstant> instants_;
  long sampling_interval_ = 1, instant_count_ = 0;
};

}  // namespace adore::runs
