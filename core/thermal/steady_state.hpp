#pragma once

#include "bearing/bearing.hpp"
#include "statics/friction.hpp"
#include "statics/roller_statics.hpp"
#include "thermal/bearing_heat.hpp"

#include <functional>

/// The thermal steady state of a quasi-static deck (mode -1 with kTherm = 1): temperatures,
/// clearance, loads and friction that agree with each other.
///
/// One pass: temperatures -> operating geometry -> equilibrium -> friction (statics/friction.hpp)
/// -> network (bearing_heat.hpp) -> temperatures, T' = g(T). The root of g(T) = T by relaxation
/// with a factor after Irons & Tuck (1969) from the last two passes, held to 0.05 to 3: thinning
/// oil makes g fall with T, lost clearance makes it grow. A root where g grows faster than T is
/// unstable, and such a relaxation leaves it: then temperatures run away until kHottest, until the
/// bearing clamps, or to a stable root. Decision 302.
/// kGeoMod = 0: geometry and material stay those of record 9.1.3; oil and medium follow.
namespace adore::thermal {

struct SteadyState {
  BearingHeat heat;
  statics::FrictionEstimate friction;
  int passes = 0;
  double change = 0.0;  ///< of the last pass, before relaxation: largest |g(T) - T| [K]
  /// dg/dT along the last way: R_th dQ/dT, unstable above 1; NaN: no heat, or one pass.
  double gain = 0.0;
  bearing::Bearing as_built, operating;
};

/// @param medium_cage_speed nothing: the epicyclic one
/// @throws SolverError when temperatures run away or do not settle, saying how; InputError as
/// operating_bearing and solve_bearing_heat at the first pass
[[nodiscard]] SteadyState solve_steady_state(const bearing::Bearing& as_built,
                                             const statics::RollerOptions& rollers = {},
                                             const std::function<void()>& each_pass = {});

/// The bearing at given temperatures of its parts, in equilibrium.
struct OperatingState {
  bearing::Bearing bearing;
  statics::FrictionEstimate friction;
  double orbit = 0.0;                  ///< mean orbital speed of the elements [rad/s]
  RaceConductance contact;             ///< of the race contacts [W/K]
  std::vector<std::string> fallbacks;  ///< friction equilibria not found (friction_balance.hpp)
};
/// @throws InputError, SolverError where the bearing has no equilibrium at these temperatures
[[nodiscard]] OperatingState operating_state(const bearing::Bearing& as_built,
                                             const BulkTemperatures& bulk,
                                             const statics::RollerOptions& rollers);

/// Heat of an estimate where it arises.
[[nodiscard]] HeatSources heat_sources(const statics::FrictionEstimate& friction);

/// The bearing at work with its parts at `bulk`; with fixed geometry that of `as_built`'s own
/// temperatures, for oil and medium at `bulk`.
[[nodiscard]] bearing::Bearing bearing_at_temperatures(const bearing::Bearing& as_built,
                                                       const BulkTemperatures& bulk,
                                                       bool geometry_follows);

}  // namespace adore::thermal
