#pragma once

#include "base/finding.hpp"
#include "runs/prepare.hpp"

#include <array>
#include <string>
#include <vector>

/// Growth of rings, shaft, housing and cage under their own rotation (thermal/ring.hpp) where the
/// race speeds follow a law of the time (record 9.4). The clearance goes with Ω² of each race:
///   c(Ω) = c(0) + Σ_j s_j Ω_j²,   s_j by differences of thermal::operating_bearing.
/// The geometry follows in levels: level n_j = round(s_j (Ω_j² - Ω_j(0)²)/Δ), with Δ a share of the
/// largest contact deflection of the static solution. Levels depend on the present speed alone, so
/// that a continued run has the geometry of an unbroken one.
namespace adore::runs {

class ThermalRun;

/// Δ over the largest contact deflection: contact loads change by 1.5 times this share in a step.
/// The geometry is off by at most half a level, the loads by 0.4 % [choice; test_ring_growth.cpp].
inline constexpr double kGrowthShare = 0.005;

class RingGrowth {
 public:
  using Levels = std::array<long, 2>;

  explicit RingGrowth(const Prepared& prepared, double share = kGrowthShare);
  /// The speeds vary and the rings grow.
  [[nodiscard]] bool active() const noexcept { return level_step_ > 0.0; }
  [[nodiscard]] Levels levels(const std::array<double, 2>& speed) const;
  /// Race speeds of the geometry at these levels [rad/s].
  [[nodiscard]] std::array<double, 2> speeds(const Levels& levels,
                                             const std::array<double, 2>& now) const;

 private:
  std::array<double, 2> start_speeds_{};     ///< race speeds at t = 0 [rad/s]
  std::array<double, 2> clearance_slope_{};  ///< s_j [m s²]
  double level_step_ = 0.0;                  ///< Δ [m]; 0: not active
};

/// The bearing of `prepared` at work at these race speeds, with the present temperatures of a
/// thermal analysis; the motion's laws keep the speeds of t = 0. @throws InputError, SolverError
void apply_race_speeds(Prepared& prepared, ThermalRun* thermal, const std::array<double, 2>& speed);

/// move_to() of a bearing at its present speeds, for laws that keep the speeds of t = 0. Where the
/// present speeds leave no equilibrium under the specified load (a tapered row without enough
/// thrust), that of t = 0 places the race. @return as move_to()
[[nodiscard]] std::vector<Finding> move_keeping_start_speeds(Prepared& prepared,
                                                             const bearing::Bearing& operating);

}  // namespace adore::runs
