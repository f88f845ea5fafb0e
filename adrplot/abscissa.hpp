#pragma once

#include "desktop/chart_page.hpp"
#include "results/sol_file.hpp"

/// Horizontal axis of a history. Its values increase from step to step for any shaft motion.
namespace adore::adrplot {

enum class Abscissa : unsigned char { Revolutions, Time, Step };

/// Relative revolutions of the races since time 0, each counted as positive: they increase for
/// backward rotation, too (the file keeps the sign, N102).
[[nodiscard]] std::vector<double> accumulated_revolutions(const results::SolFile& file);

/// Do the races oscillate relative to each other by more than a thousandth of a revolution in both
/// directions?
[[nodiscard]] bool has_reversals(const results::SolFile& file);

/// Sets values, title and unit of the horizontal axis. Without relative rotation of the races,
/// revolutions would put the whole run at one point: then time is used, with a note.
void set_abscissa(desktop::ChartPage& page, const results::SolFile& file, Abscissa abscissa);

}  // namespace adore::adrplot
