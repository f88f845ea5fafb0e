#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families B_line_contact and rollers_slices.
std::vector<Adapter> roller_slice_adapters();

/// Families rollers_flange, rollers_inertia, rollers_tapered, and the tapered rollers of
/// D_roller_bearing, which need no equilibrium solver.
std::vector<Adapter> roller_part_adapters();

}  // namespace adore::calculators
