#include "runs/start_state.hpp"

#include "base/errors.hpp"
#include "dynamics/element_masses.hpp"
#include "dynamics/friction_start.hpp"
#include "runs/changed_equilibrium.hpp"

#include <fmt/format.h>

namespace adore::runs {

constexpr double kAligned = 1e-8;  ///< [rad]

StartState start_state(const Prepared& prepared, dynamics::System& system) {
  StartState out;
  out.y = system.initial_state();
  const scene::ScenePlan& plan = prepared.plan;
  const bool balls = prepared.roller_scene == nullptr;
  if (plan.suppressed.of_elements() ||
      dynamics::ElementMasses(prepared.bearing).has_eccentric_mass())
    return out;
  if (balls && (plan.rigid_balls || !plan.has(scene::Effect::RaceTraction))) return out;
  const dynamics::FrictionBalanceResult found = dynamics::balance_friction(system, out.y);
  std::array<bool, 3> free{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (plan.has(scene::Effect::RaceBalance))
      free[k] = !prepared.bearing.constraints.displacement_given[k];
    else if (const auto& race = plan.race_motions.free[1])
      free[k] = !race->translation_held[k];
  }
  (void)dynamics::balance_race(system, out.y, prepared.start.stiffness.topLeftCorner<3, 3>(), free);
  const std::size_t left = found.rollers - found.balanced;
  if (balls) {
    if (left > 0)
      out.remark = fmt::format(
          "{} of {} balls start in pure rolling, because no friction equilibrium was found: "
          "the first revolutions contain a transient",
          left, found.rollers);
    return out;
  }
  if (left == 0 && found.largest_skew < kAligned)
    out.remark = "the rollers start in friction equilibrium, without skew";
  else if (left == 0)
    out.remark =
        fmt::format("the rollers start in friction equilibrium, skewed by up to {:.3g} mrad",
                    1e3 * found.largest_skew);
  else
    out.remark = fmt::format(
        "{} of {} rollers start without skew, because no friction equilibrium was found: the "
        "first revolutions contain a transient. Averages over later revolutions are not affected",
        left, found.rollers);
  return out;
}

namespace {

std::string free_directions(const scene::ScenePlan& plan) {
  std::string names;
  if (const auto& race = plan.race_motions.free[1])
    for (std::size_t k = 0; k < 3; ++k)
      if (!race->translation_held[k])
        names += fmt::format("{}kFD{}2 = 0", names.empty() ? "" : ", ", k + 1);
  return names.empty() ? names
                       : ", and whether the loads can balance the inner race in the directions in "
                         "which it moves freely (" +
                             names + ")";
}

}  // namespace

std::optional<Finding> judge_start_energy(const Prepared& prepared, dynamics::System& system,
                                          const std::vector<double>& y) {
  if (prepared.plan.suppressed.of_elements()) return std::nullopt;
  const dynamics::EquilibriumChange start =
      dynamics::assess_start_excess_energy(moving_scene(prepared, system), 0.0, y);
  if (!start.why_not.empty())
    return make_finding("run.start_unknown",
                        "the excess energy at the start is not computed: " + start.why_not);
  if (!(start.ratio() > dynamics::kExcessWarned)) return std::nullopt;
  const std::string text = fmt::format(
      "start: excess energy = {:.3g} J, {:.0f} % of the elastic energy of the equilibrium ({:.3g} "
      "J)",
      start.excess, 100.0 * start.ratio(), start.elastic);
  if (const std::string specified = user_routine_motion_text(prepared); !specified.empty())
    return excess_energy_finding(text + ": " + specified + "; the run continues", start.ratio());
  if (start.ratio() > dynamics::kExcessRefused)
    throw SolverError(text +
                      ": the contacts start with an impact. Check the clearances and "
                      "displacements of the races" +
                      free_directions(prepared.plan));
  return excess_energy_finding(text + ", so the loads of the first revolutions contain a vibration",
                               start.ratio());
}

}  // namespace adore::runs
