#include "runs/stiffness.hpp"

#include "base/interrupted.hpp"
#include "statics/ball_friction.hpp"
#include "statics/roller_statics.hpp"
#include "thermal/operating.hpp"

#include <array>
#include <map>
#include <optional>

namespace adore::runs {

std::vector<statics::StiffnessRow> stiffness_over_speed(const Prepared& prepared) {
  if (!prepared.control.stiffness) return {};
  const statics::StiffnessRequest& request = *prepared.control.stiffness;
  bearing::Bearing as_built = prepared.as_built;
  std::optional<statics::RollerSolution> last_rollers;
  std::map<std::array<double, 2>, std::optional<bearing::OperatingFits>> operating;
  const auto solve = [&](const std::array<double, 2>& speed,
                         const statics::RaceResult* previous) -> statics::RaceResult {
    if (prepared.input.stop.stop_requested())
      throw Interrupted("interrupted in the table of stiffness over speed; no files were written");
    const auto& tell = prepared.input.table_progress;
    if (tell && !operating.empty()) tell(static_cast<long>(operating.size()), request.points);
    as_built.speed = speed;
    bearing::Bearing bearing = thermal::operating_bearing(as_built);
    operating[speed] = bearing.operating;
    if (bearing.rollers()) {
      statics::RollerOptions options = prepared.options.rollers;
      options.difference_share = request.share;
      if (previous != nullptr && last_rollers) options.start = &*last_rollers;
      statics::RollerSolution solution = statics::solve_roller_statics(bearing, options);
      solution.notes = solution.friction.findings();
      last_rollers = std::move(solution);
      return *last_rollers;
    }
    statics::BallStaticsOptions options = ball_statics_options(prepared);
    options.difference_share = request.share;
    options.warm_start = previous != nullptr;
    if (previous != nullptr)
      for (std::size_t k = 0; k < 5; ++k)
        if (!bearing.constraints.displacement_given[k])
          bearing.constraints.displacement[k] = previous->displacement[k];
    statics::StaticSolution solution = statics::solve_ball_statics(bearing, options);
    solution.notes = statics::solve_ball_friction_balance(bearing, options, solution).findings();
    return solution;
  };
  std::vector<statics::StiffnessRow> rows = statics::stiffness_table(request, solve);
  if (prepared.input.table_progress) prepared.input.table_progress(request.points, request.points);
  for (statics::StiffnessRow& row : rows)
    if (const auto found = operating.find(row.speed); found != operating.end())
      row.operating = found->second;
  return rows;
}

}  // namespace adore::runs
