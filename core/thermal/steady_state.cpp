#include "thermal/steady_state.hpp"

#include "base/errors.hpp"
#include "statics/ball_friction.hpp"
#include "statics/ball_statics.hpp"
#include "thermal/operating.hpp"
#include "thermal/relaxation.hpp"
#include "thermal/too_cold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace adore::thermal {
namespace {

using bearing::Bearing;
using Field = std::array<double, 7>;

constexpr double kTolerance = 0.01;  ///< [K]
constexpr int kSteadyPasses = 300;

double largest(const Field& field) {
  double out = 0.0;
  for (const double value : field) out = std::max(out, std::abs(value));
  return out;
}
Field less(const Field& a, const Field& b) {
  Field out{};
  for (std::size_t k = 0; k < a.size(); ++k) out[k] = a[k] - b[k];
  return out;
}

/// Result of one pass.
struct Pass {
  Bearing operating;
  statics::FrictionEstimate friction;
  BearingHeat heat;
};

Pass one_pass(const Bearing& as_built, const BulkTemperatures& bulk,
              const statics::RollerOptions& rollers) {
  OperatingState at = operating_state(as_built, bulk, rollers);
  Pass out{std::move(at.bearing), std::move(at.friction), {}};
  out.heat = solve_bearing_heat(out.operating, heat_sources(out.friction), at.orbit, at.contact);
  return out;
}

constexpr const char* kRemedy =
    "Increase the coolant flow (cFlowRate), increase the clearance or reduce the interference "
    "(freeIntCls, raceFit1, raceFit2), reduce load or speed, or use a less viscous lubricant";

[[noreturn]] void give_up(const std::string& what, int passes, const std::optional<Pass>& last,
                          double gain) {
  std::string state;
  if (last) {
    const BulkTemperatures& T = last->heat.bulk;
    state = fmt::format(
        "; last iteration: power loss {:.4g} W, outer race {:.4g} K, inner race {:.4g} K, elements "
        "{:.4g} K, diametral clearance {:.4g} m",
        last->friction.power(), T.race[0], T.race[1], T.element,
        last->operating.operating ? last->operating.operating->operating.clearance : 0.0);
  }
  const std::string growth = std::isfinite(gain) && gain > 1.0
                                 ? fmt::format(
                                       "; with temperature, the generated heat increases {:.3g} "
                                       "times as fast as the removed heat",
                                       gain)
                                 : std::string();
  throw SolverError(fmt::format("thermal analysis: no steady state after iteration {}: {}{}{}. {}",
                                passes, what, state, growth, kRemedy));
}

}  // namespace

OperatingState operating_state(const Bearing& as_built, const BulkTemperatures& bulk,
                               const statics::RollerOptions& rollers) {
  OperatingState out;
  out.bearing = bearing_at_temperatures(as_built, bulk, as_built.thermal->geometry_every > 0);
  if (out.bearing.rollers()) {
    const auto solution = statics::solve_roller_statics(out.bearing, rollers);
    out.orbit = solution.orbital_speed;
    out.contact = race_conductance(out.bearing, solution);
    out.friction = statics::friction_estimate(out.bearing, solution);
    for (std::string& one : sentences_of(solution.friction.findings()))
      out.fallbacks.push_back(std::move(one));
  } else {
    statics::BallStaticsOptions balls;
    balls.frame = rollers.frame;
    balls.friction_balance = rollers.ball_balance;
    auto solution = statics::solve_ball_statics(out.bearing, balls);
    const statics::FrictionBalance balance =
        statics::solve_ball_friction_balance(out.bearing, balls, solution);
    for (const statics::StaticBall& ball : solution.balls)
      out.orbit += ball.orbital_speed / static_cast<double>(solution.balls.size());
    out.contact = race_conductance(out.bearing, solution);
    out.friction = statics::friction_estimate(out.bearing, solution, balance);
    out.fallbacks = sentences_of(balance.findings());
  }
  return out;
}

HeatSources heat_sources(const statics::FrictionEstimate& friction) {
  HeatSources out;
  for (std::size_t j = 0; j < 2; ++j) {
    out.race[j] = friction.of_race(static_cast<int>(j)).total();
    out.flange[j] = friction.flange[j];
  }
  out.churning = friction.drag();
  return out;
}

Bearing bearing_at_temperatures(const Bearing& as_built, const BulkTemperatures& bulk,
                                bool geometry_follows) {
  if (geometry_follows) {
    Bearing warm = as_built;
    bulk.set(warm);
    return operating_bearing(warm);
  }
  Bearing out = operating_bearing(as_built);
  bulk.set(out);
  return out;
}

SteadyState solve_steady_state(const Bearing& as_built, const statics::RollerOptions& rollers,
                               const std::function<void()>& each_pass) {
  demand(as_built.thermal.has_value(),
         "a thermal steady state was requested for a deck without thermal analysis");
  BulkTemperatures at = BulkTemperatures::in(as_built);
  SteadyState out;
  out.gain = std::numeric_limits<double>::quiet_NaN();
  std::optional<Pass> last;
  Relaxation relaxation;
  for (int pass = 1;; ++pass) {
    if (each_pass) each_pass();
    Pass now;
    try {
      now = one_pass(as_built, at, rollers);
    } catch (const SolverError& error) {
      if (!last) throw;
      give_up(fmt::format("the bearing no longer has an equilibrium ({})", error.what()), pass,
              last, out.gain);
    } catch (const InputError& error) {
      if (!last) throw;
      give_up(fmt::format("the bearing can no longer operate ({})", error.what()), pass, last,
              out.gain);
    }
    last = now;
    const Field r = less(now.heat.bulk.list(), at.list());
    out.passes = pass;
    out.change = largest(r);
    if (out.change < kTolerance) {
      if (const std::string cold = describe_too_cold_nodes(now.heat); !cold.empty())
        give_up(cold, pass, last, out.gain);
      if (const std::string hot = describe_overheated_node(now.heat); !hot.empty())
        give_up(hot, pass, last, out.gain);
      out.heat = std::move(now.heat);
      out.friction = std::move(now.friction);
      out.as_built = as_built;
      if (as_built.thermal->geometry_every > 0) at.set(out.as_built);
      out.operating = std::move(now.operating);
      return out;
    }
    if (!std::isfinite(out.change)) give_up("temperatures are not finite", pass, last, out.gain);
    if (pass == kSteadyPasses)
      give_up(fmt::format("temperatures still change by {:.3g} K", out.change), pass, last,
              out.gain);
    at = BulkTemperatures::of(relaxation.step(at.list(), now.heat.bulk.list()));
    if (pass > 1) out.gain = relaxation.gain;
    if (const std::string hot = describe_thermal_runaway(at); !hot.empty())
      give_up(fmt::format("temperatures run away ({})", hot), pass, last, out.gain);
  }
}

}  // namespace adore::thermal
