#include "statics/stiffness_table.hpp"

#include "base/errors.hpp"
#include "statics/stiffness_difference.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {

double stiffness_disagreement(const Mat5& a, const Mat5& b) {
  double worst = 0.0;
  for (const Eigen::Index row : {0, 3})
    for (const Eigen::Index column : {0, 3}) {
      const Eigen::Index rows = row == 0 ? 3 : 2, columns = column == 0 ? 3 : 2;
      const auto block = a.block(row, column, rows, columns);
      // A coupling block that is zero by symmetry is judged by the blocks on the diagonal.
      const double diagonal =
          std::sqrt(a.block(row, row, rows, rows).cwiseAbs().maxCoeff() *
                    a.block(column, column, columns, columns).cwiseAbs().maxCoeff());
      const double scale = std::max(block.cwiseAbs().maxCoeff(), 1e-3 * diagonal);
      if (scale > 0.0)
        worst = std::max(
            worst, (block - b.block(row, column, rows, columns)).cwiseAbs().maxCoeff() / scale);
    }
  return worst;
}

std::vector<StiffnessRow> stiffness_table(const StiffnessRequest& request,
                                          const SolveAtSpeed& solve) {
  std::vector<StiffnessRow> rows;
  for (int k = 0; k < request.points; ++k) {
    const double t = request.points > 1 ? static_cast<double>(k) / (request.points - 1) : 0.0;
    StiffnessRow row;
    for (std::size_t j = 0; j < 2; ++j)
      row.speed[j] = request.first[j] + t * (request.last[j] - request.first[j]);
    const RaceResult* previous =
        rows.empty() || !rows.back().failure.empty() ? nullptr : &rows.back().result;
    for (const RaceResult* start : {previous, static_cast<const RaceResult*>(nullptr)}) {
      try {
        row.result = solve(row.speed, start);
        row.failure.clear();
        break;
      } catch (const SolverError& error) {
        row.failure = error.what();
        if (start == nullptr) break;
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace adore::statics
