#pragma once

#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Pages whose curves are amplitudes over frequency.
namespace adore::adrplot {

/// Appends a sentence to the page's note, once.
void add_note(desktop::ChartPage& chart, const std::string& text);

/// Every curve of the page, stored at the times `t` [s], becomes its amplitude spectrum.
void to_spectra(desktop::ChartPage& chart, const std::vector<double>& t,
                const SpectrumOptions& options);

/// The first view ends a little beyond the last amplitude above 1 % of its curve's largest.
void first_view_of_spectra(desktop::ChartPage& chart, SpectrumScale scale);

}  // namespace adore::adrplot
