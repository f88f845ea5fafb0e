#pragma once

#include "adrplot/run_motion.hpp"
#include "desktop/chart_page.hpp"

#include <optional>

/// Times of places on the abscissa of a page where cursors can be. No Qt.
namespace adore::adrplot {

/// Time at an abscissa [s]; nothing if the page is not over the course of a run, such as a
/// spectrum, and outside the run. Revolutions are those of `motion`; of a shaft at rest the end.
[[nodiscard]] std::optional<double> time_of_cursor(const desktop::ChartPage& page,
                                                   const RunMotion& motion, double abscissa);
/// Abscissa at a time, within the run.
[[nodiscard]] std::optional<double> cursor_at_time(const desktop::ChartPage& page,
                                                   const RunMotion& motion, double time);

}  // namespace adore::adrplot
