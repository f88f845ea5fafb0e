#pragma once

#include "desktop/chart_page.hpp"
#include "results/sol_file.hpp"

/// What a history is drawn over. It always grows from step to step, however the shaft turns.
namespace adore::adrplot {

enum class Abscissa : unsigned char { Revolutions, Time, Step };

/// Turns of the inner race against the outer one since time 0, each of them counted as positive:
/// a shaft that turns backwards goes on as one that turns forwards (the file keeps the sign, N102).
[[nodiscard]] std::vector<double> accumulated_turns(const results::SolFile& file);

/// Do the races turn to and fro against each other, by more than a thousandth of a turn each way?
[[nodiscard]] bool turns_back(const results::SolFile& file);

/// Sets values, title and unit of a page's abscissa. Where the races do not turn against each other
/// turns would put the whole run at one place: then it is time, and the page's note says so.
void set_abscissa(desktop::ChartPage& page, const results::SolFile& file, Abscissa abscissa);

}  // namespace adore::adrplot
