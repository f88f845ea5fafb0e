#pragma once

#include "adrplot/page_builder.hpp"

/// Histories as spectra and spectrograms, for any source of curves.
namespace adore::adrplot {

/// Replaces the curves of a page by their spectra, with marks, notes and first view.
/// @param motion stored times and known revolutions
/// @param oscillates the shaft turns back: it has no frequency marks
/// @return false: no curve has a spectrum
bool show_spectra(desktop::ChartPage& chart, const RunMotion& motion, bool oscillates,
                  const SpectrumOptions& options);

/// The chart type of the options, of a page of histories.
void show_domain(desktop::ChartPage& chart, const RunMotion& motion, bool oscillates,
                 const PageOptions& options);

}  // namespace adore::adrplot
