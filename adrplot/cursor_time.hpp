#pragma once

#include "adrplot/run_motion.hpp"
#include "desktop/chart_page.hpp"

#include <optional>

/// Times of places on the abscissa of a page where cursors can be. No Qt.
namespace adore::adrplot {

/// Time at an abscissa [s]; a place beyond the first or last step gives the time of that step.
/// Nothing on pages without a time, such as spectra. Revolutions are looked up in `motion`.
[[nodiscard]] std::optional<double> time_of_cursor(const desktop::ChartPage& page,
                                                   const RunMotion& motion, double abscissa);
/// Abscissa at a time [s], limited to the steps of the run; nothing on pages without a time.
[[nodiscard]] std::optional<double> cursor_at_time(const desktop::ChartPage& page,
                                                   const RunMotion& motion, double time);

}  // namespace adore::adrplot
