#pragma once

#include "adrplot/run_motion.hpp"
#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Pages with amplitudes over frequency.
namespace adore::adrplot {

/// Appends a sentence to the page's note, once.
void add_note(desktop::ChartPage& chart, const std::string& text);

/// "Race interactions 1: load and angle" -> "Race interactions 1, load and angle"
[[nodiscard]] std::string without_colon(std::string title);

/// Replaces every curve of the page, stored at the times of the motion, by its amplitude spectrum,
/// envelope spectrum or order spectrum. Curves without spectrum leave the reason in the panel, or
/// in the note if other curves have one.
/// @param domain Spectrum, Envelope or Orders
void to_spectra(desktop::ChartPage& chart, const RunMotion& motion, const SpectrumOptions& options,
                Domain domain = Domain::Spectrum);

/// Adds a note with the reference of the heights and the line spacing of the spectra, in the unit
/// of the abscissa: nothing is known below the first line.
void note_spectrum_lines(desktop::ChartPage& chart, const std::vector<double>& distances,
                         const SpectrumOptions& options);

/// Removes marks below the first line of the spectra and adds a note.
void drop_low_marks(desktop::ChartPage& chart);

/// Selects a logarithmic frequency axis for curves whose lines above that fraction of their maximum
/// would otherwise use less than an eighth of the width of the others; adds a note.
void choose_frequency_axis(desktop::ChartPage& chart, const std::vector<double>& ends,
                           double visible);

/// The first view ends shortly after the last amplitude above 1 % of the maximum of its curve, and
/// after the mark of the shaft, for envelopes and orders after all marks without harmonics; the
/// note gives the largest line outside.
void set_initial_spectrum_view(desktop::ChartPage& chart, SpectrumScale scale,
                               Domain domain = Domain::Spectrum);

}  // namespace adore::adrplot
