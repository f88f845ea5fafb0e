#pragma once

#include "desktop/chart_page.hpp"
#include "results/static_tables.hpp"
#include "results/sweep_table.hpp"

#include <vector>

/// Pages without time histories: the quasi-static solution in a RUN.json, and the key results of a
/// sweep.
namespace adore::desktop {

/// Load around the bearing, loads and angles of the elements, contact ellipses against the groove's
/// edges, pressure along the roller, stiffness over speed: those of them that the run has.
std::vector<ChartPage> static_pages(const results::StaticTables& tables);

/// Every key result over the swept variable; quantities of one kind share a panel.
std::vector<ChartPage> sweep_pages(const results::SweepTable& sweep);

}  // namespace adore::desktop
