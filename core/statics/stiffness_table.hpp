#pragma once

#include "bearing/fits.hpp"
#include "statics/race_result.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Stiffness of the bearing over speed (kStif, record 9.2): the loads of the deck at speeds spaced
/// evenly between two pairs.
namespace adore::statics {

struct StiffnessRequest {
  int points = 0;      ///< kStif, at least 1
  double share = 0.0;  ///< pctDisp/100: displacement of the differences over the largest
                       ///< contact deflection; 0: no differences
  std::array<double, 2> first{}, last{};  ///< race speeds [rad/s]
};

struct StiffnessRow {
  std::array<double, 2> speed{};  ///< [rad/s]
  RaceResult result;  ///< meaningless when there is a failure; notes: friction equilibria not found
  std::optional<bearing::OperatingFits> operating;  ///< fits and clearance at this speed, where
                                                    ///< the caller knows them
  std::string failure;  ///< why there is no equilibrium at this speed; empty: there is one
};

/// Solves one speed; `previous` is the solution of the row before, or nullptr.
/// @throws SolverError when there is no equilibrium.
using SolveAtSpeed =
    std::function<RaceResult(const std::array<double, 2>& speed, const RaceResult* previous)>;

/// One row per point, in order; a single point stands at the first speeds. A speed without an
/// equilibrium is tried from a cold start too; then its row says why, and the next one starts cold.
[[nodiscard]] std::vector<StiffnessRow> stiffness_table(const StiffnessRequest& request,
                                                        const SolveAtSpeed& solve);

}  // namespace adore::statics
