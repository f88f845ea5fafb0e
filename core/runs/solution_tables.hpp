#pragma once

#include "results/static_tables.hpp"
#include "runs/prepare.hpp"

namespace adore::runs {

/// The quasi-static solution of a prepared deck as named columns: what RUN.json keeps, and what its
/// charts are drawn from.
[[nodiscard]] results::StaticTables solution_tables(const Prepared& prepared);

}  // namespace adore::runs
