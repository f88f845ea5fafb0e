#pragma once

#include "adrplot/page_builder.hpp"

/// Histories as spectra, envelope and order spectra, and spectrograms, for any source of curves.
namespace adore::adrplot {

/// Replaces the curves of a page by their spectra, with marks, notes and first view.
/// @param motion stored times and known revolutions; a shaft that oscillates has no frequency marks
/// @param domain Spectrum, Envelope or Orders
/// @return false: no curve has a spectrum
bool show_spectra(desktop::ChartPage& chart, const RunMotion& motion,
                  const SpectrumOptions& options, Domain domain = Domain::Spectrum);

/// The chart type of the options, of a page of histories.
void show_domain(desktop::ChartPage& chart, const RunMotion& motion, const PageOptions& options);

}  // namespace adore::adrplot
