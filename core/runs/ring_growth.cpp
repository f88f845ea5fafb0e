#include "runs/ring_growth.hpp"

#include "runs/thermal_run.hpp"
#include "thermal/operating.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::runs {
namespace {

double clearance_at(bearing::Bearing as_built, const std::array<double, 2>& speed) {
  as_built.speed = speed;
  return thermal::operating_bearing(as_built).operating->operating.clearance;
}

}  // namespace

RingGrowth::RingGrowth(const Prepared& prepared, double share)
    : start_speeds_(prepared.as_built.speed) {
  const bearing::RaceMotions& motions = prepared.plan.race_motions;
  const bool varies =
      motions.ramp[0] || motions.ramp[1] || motions.variation[0] || motions.variation[1];
  if (!varies || !prepared.as_built.mounting.centrifugal_growth) return;
  constexpr double kMinSpeed = 1000.0;  ///< of the differences, at least [rad/s]
  const double at_rest = clearance_at(prepared.as_built, {0.0, 0.0});
  for (std::size_t j = 0; j < 2; ++j) {
    std::array<double, 2> speed{};
    speed[j] = std::max(kMinSpeed, std::abs(start_speeds_[j]));
    clearance_slope_[j] =
        (clearance_at(prepared.as_built, speed) - at_rest) / (speed[j] * speed[j]);
  }
  constexpr double kMinStep = 1e-9;  ///< [m]
  level_step_ = std::max(kMinStep, share * prepared.start.max_deflection);
}

RingGrowth::Levels RingGrowth::levels(const std::array<double, 2>& speed) const {
  Levels out{};
  for (std::size_t j = 0; active() && j < 2; ++j)
    out[j] = std::lround(clearance_slope_[j] *
                         (speed[j] * speed[j] - start_speeds_[j] * start_speeds_[j]) / level_step_);
  return out;
}

std::array<double, 2> RingGrowth::speeds(const Levels& levels,
                                         const std::array<double, 2>& now) const {
  std::array<double, 2> out = start_speeds_;
  for (std::size_t j = 0; j < 2; ++j) {
    if (levels[j] == 0) continue;
    const double square = start_speeds_[j] * start_speeds_[j] +
                          static_cast<double>(levels[j]) * level_step_ / clearance_slope_[j];
    out[j] = std::copysign(std::sqrt(std::max(square, 0.0)), now[j]);
  }
  return out;
}

void apply_race_speeds(Prepared& prepared, ThermalRun* thermal,
                       const std::array<double, 2>& speed) {
  bearing::Bearing operating;
  if (thermal != nullptr) {
    thermal->set_speed(speed);
    operating = thermal->operating();
  } else {
    bearing::Bearing as_built = prepared.as_built;
    as_built.speed = speed;
    operating = thermal::operating_bearing(as_built);
  }
  (void)move_keeping_start_speeds(prepared, operating);
}

std::vector<Finding> move_keeping_start_speeds(Prepared& prepared,
                                               const bearing::Bearing& operating) {
  const std::array<double, 2> at_start = prepared.as_built.speed;
  std::vector<Finding> doubts;
  try {
    doubts = move_to(prepared, operating);
  } catch (const SolverError&) {
    if (operating.speed == at_start) throw;
    bearing::Bearing slow = operating;  // held where the load at t = 0 puts it
    slow.speed = at_start;
    doubts = move_to(prepared, std::move(slow));
  }
  prepared.bearing.speed = at_start;
  return doubts;
}

}  // namespace adore::runs
