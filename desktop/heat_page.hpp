#pragma once

#include "desktop/chart_page.hpp"
#include "results/static_tables.hpp"

#include <optional>

/// The thermal network of a quasi-static solution as a picture: nodes with their temperatures,
/// links with the heat that flows through them.
namespace adore::desktop {

/// Nothing without the table "thermal network".
[[nodiscard]] std::optional<ChartPage> heat_page(const results::StaticTables& all);

}  // namespace adore::desktop
