#pragma once

#include "facade/prepare.hpp"
#include "results/static_tables.hpp"

namespace adore::facade {

/// The quasi-static solution of a prepared deck as named columns: what RUN.json keeps, and what its
/// charts are drawn from.
[[nodiscard]] results::StaticTables solution_tables(const Prepared& prepared);

}  // namespace adore::facade
