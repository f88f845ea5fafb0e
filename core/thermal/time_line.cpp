#include "thermal/time_line.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

constexpr std::size_t kMostPoints = 2000;
constexpr double kSettled = 0.1;  ///< [K]

double largest_difference(const BulkTemperatures& a, const BulkTemperatures& b, bool with_medium) {
  const auto x = a.list(), y = b.list();
  double out = 0.0;
  for (std::size_t k = 0; k + (with_medium ? 0 : 1) < x.size(); ++k)
    out = std::max(out, std::abs(x[k] - y[k]));
  return out;
}

}  // namespace

ThermalTransient solve_thermal_transient(const bearing::Bearing& as_built,
                                         const statics::RollerOptions& rollers,
                                         const std::function<void()>& each_step,
                                         double largest_change) {
  demand(as_built.thermal.has_value(),
         "a thermal time line was requested for a deck without thermal analysis");
  ThermalTransient out;
  HeatStep step;
  step.duration = 1.0;
  double time = 0.0, stored = 0.0;
  BulkTemperatures bulk = BulkTemperatures::in(as_built);
  std::size_t without = 0;
  std::string first;
  while (out.points.size() < kMostPoints) {
    if (each_step) each_step();
    OperatingState at;
    try {
      at = operating_state(as_built, bulk, rollers);
    } catch (const SolverError& error) {
      out.end = fmt::format("no equilibrium after {:.4g} s: {}", time, error.what());
      return out;
    } catch (const InputError& error) {
      if (out.points.empty()) throw;
      out.end =
          fmt::format("the bearing can no longer operate after {:.4g} s: {}", time, error.what());
      return out;
    }
    if (!at.fallbacks.empty()) {
      if (++without == 1)
        first = fmt::format("first at {:.4g} s: {}", time, fmt::join(at.fallbacks, ". "));
      out.fallback =
          fmt::format("{} without a friction equilibrium, {}", counted(without, "step"), first);
    }
    const HeatSources heat = heat_sources(at.friction);
    out.points.push_back({time, heat.total(), stored, bulk,
                          at.bearing.operating ? at.bearing.operating->operating.clearance : 0.0});
    const BulkTemperatures steady = solve_bearing_heat(at.bearing, heat, at.orbit, at.contact).bulk;
    if (largest_difference(steady, bulk, false) < kSettled) {
      out.settled = true;
      return out;
    }
    BearingHeat next;
    for (;; step.duration *= 0.5) {
      next = solve_bearing_heat(at.bearing, heat, at.orbit, at.contact, &step);
      const double change = largest_difference(next.bulk, bulk, false);
      constexpr double kMinStep = 1e-3;  // [s]
      if (change <= largest_change || step.duration < kMinStep) break;
    }
    time += step.duration;
    if (largest_difference(next.bulk, bulk, false) < 0.5 * largest_change) step.duration *= 1.5;
    bulk = next.bulk;
    stored = next.stored;
    step.before = std::move(next.state);
    std::string hot = describe_thermal_runaway(bulk);
    if (hot.empty()) hot = describe_overheated_node(next);
    if (!hot.empty()) {
      out.end = fmt::format("temperatures run away after {:.4g} s ({})", time, hot);
      return out;
    }
  }
  out.end = fmt::format("no steady state after {}, {:.4g} s", counted(kMostPoints, "step"), time);
  return out;
}

}  // namespace adore::thermal
