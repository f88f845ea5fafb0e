#pragma once

#include "thermal/steady_state.hpp"

#include <functional>
#include <string>
#include <vector>

/// Temperatures over time of a quasi-static deck (mode -1, kTherm = 1, thermalTransient = on): from
/// those of record 9.1.3 at constant speed and load, with the heat capacities of rings, elements,
/// cage, shaft and housing (HeatStep). Each step: equilibrium and friction at the present
/// temperatures, then one implicit step of the network with that heat. The step is halved until no
/// part changes by more than kLargestChange and grows by half while parts change by less than half
/// of it: first order in it (test).
namespace adore::thermal {

struct ThermalTransientPoint {
  double time = 0.0;                ///< [s]
  double heat = 0.0, stored = 0.0;  ///< made; of it what warms the parts [W]
  BulkTemperatures bulk;
  double clearance = 0.0;  ///< diametral, in operation [m]
};

struct ThermalTransient {
  std::vector<ThermalTransientPoint> points;
  bool settled = false;  ///< otherwise `end` has the reason of its end
  std::string end;       ///< lost equilibrium or runaway, in words; empty: settled
  /// Steps without a friction equilibrium, with the first reason; empty: none.
  std::string fallback;
};

inline constexpr double kLargestChange = 2.0;  ///< of a part in a step [K] [choice]

/// Until all parts are within 0.1 K of the steady state of the present heat, the bearing has no
/// equilibrium any more (seizure), temperatures run away, or `kMostPoints` are reached.
[[nodiscard]] ThermalTransient solve_thermal_transient(const bearing::Bearing& as_built,
                                                       const statics::RollerOptions& rollers = {},
                                                       const std::function<void()>& each_step = {},
                                                       double largest_change = kLargestChange);

}  // namespace adore::thermal
