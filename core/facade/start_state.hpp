#pragma once

#include "dynamics/system.hpp"
#include "facade/prepare.hpp"

#include <string>
#include <vector>

namespace adore::facade {

/// Where a run from the quasi-static solution starts.
struct StartState {
  std::vector<double> y;
  std::string remark;  ///< what became of the balance of friction of its rollers; empty: balls
};

/// The quasi-static solution, rollers in balance of friction where they have one
/// (dynamics/friction_start.hpp) and nothing else decides how they stand: not where kDOF suppresses
/// motions of elements, nor with mass centres beside their axes, which never balance.
[[nodiscard]] StartState start_state(const Prepared& prepared, dynamics::System& system);

}  // namespace adore::facade
