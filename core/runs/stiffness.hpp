#pragma once

#include "runs/prepare.hpp"
#include "statics/stiffness_table.hpp"

/// The stiffness-speed table that a deck asks for (kStif, record 9.2).
namespace adore::runs {

/// Rows in the order of the speeds; empty without a table in the deck. Every speed is a separate
/// bearing, with all speed-dependent quantities. A speed without an equilibrium has its
/// reason in its row.
[[nodiscard]] std::vector<statics::StiffnessRow> stiffness_over_speed(const Prepared& prepared);

}  // namespace adore::runs
