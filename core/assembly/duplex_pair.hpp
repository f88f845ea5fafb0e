#pragma once

#include "runs/prepare.hpp"

#include <optional>

/// Back-to-back pair of two rows of one deck, for comparison with printed figures of makers. SI.
/// Rings and spacers are rigid (set_statics.hpp); rows are mounted, without speed (row_model.hpp).
namespace adore::assembly {

struct DuplexPair {
  double offset = 0.0;               ///< of the set at the preload, from touching rows [m]
  double axial = 0.0, radial = 0.0;  ///< stiffness without external load, all else held [N/m]
};

/// @param preload axial load of each row [N] @throws SolverError
[[nodiscard]] DuplexPair duplex_pair(const runs::Prepared& row, double preload);
/// Axial force that unloads one row of the pair [N]; empty: none was found.
[[nodiscard]] std::optional<double> duplex_unloading_force(const runs::Prepared& row,
                                                           double preload);

}  // namespace adore::assembly
