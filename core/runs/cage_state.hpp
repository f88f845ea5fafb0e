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
/// results::cage_scale. Whether the cage yields is a separate finding (motion_watch.hpp).
///
/// Not judged: a cage of several segments (it has no single center), and a run whose second half
/// covers less than kLeastTurns of the cage.
namespace adore::runs {

class CageState {
 public:
  static constexpr double kLeastTurns = 1.0;  ///< estimate: one whirl at the speed of the cage
  static constexpr std::size_t kMostInstants = 8192;

  /// @param unit_length of the deck [m], for results::cage_scale
  CageState(const bearing::Bearing& bearing, double unit_length);
  /// Finds the cage in the state of a run.
  void follow(const dynamics::StateLayout& layout);
  /// After each counted step.
  void look(double time, std::span<const double> y);
  /// Empty: the bearing has no cage, or nothing was followed.
  [[nodiscard]] std::optional<Finding> finding() const;

 private:
  bool cage_ = false;
  double scale_ = 1.0;
  results::CageScale::Of of_ = results::CageScale::Of::UnitOfLength;
  int pieces_ = 0, position_ = -1, velocity_ = -1, omega_ = -1;
  /// Every `every_`-th instant; where there are too many, every second of them goes.
  std::vector<double> times_;
  std::vector<results::CageInstant> instants_;
  long every_ = 1, seen_ = 0;
};

}  // namespace adore::runs
