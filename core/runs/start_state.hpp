#pragma once

#include "dynamics/system.hpp"
#include "runs/prepare.hpp"

#include <optional>
#include <string>
#include <vector>

namespace adore::runs {

/// Start of a run from the quasi-static solution.
struct StartState {
  std::vector<double> y;
  std::string remark;  ///< on the balance of friction of rollers; empty: balls
};

/// The quasi-static solution with the elements in balance of friction (dynamics/friction_start.hpp)
/// and, where the inner race moves under its load, that race in balance, too: the first step has no
/// jump of force. Not if kDOF suppresses motions of elements, nor with mass centers off the
/// axes, which never balance; balls of unequal moments and balls without traction start in pure
/// rolling.
[[nodiscard]] StartState start_state(const Prepared& prepared, dynamics::System& system);

/// Excess energy of a start (dynamics::assess_start_excess_energy). Above 10 %: run.start_excess;
/// where there is no equilibrium to judge against: run.start_unknown; empty: nothing to report.
/// @throws SolverError above 100 %, unless routine ADRX1 specifies shocks (changed_equilibrium.hpp)
[[nodiscard]] std::optional<Finding> judge_start_energy(const Prepared& prepared,
                                                        dynamics::System& system,
                                                        const std::vector<double>& y);

}  // namespace adore::runs
