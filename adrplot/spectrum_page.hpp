#pragma once

#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Pages with amplitudes over frequency.
namespace adore::adrplot {

/// Appends a sentence to the page's note, once.
void add_note(desktop::ChartPage& chart, const std::string& text);

/// Smaller changes are rounding, not vibration: a thousandth of the smallest range of an axis
/// (1e-13 m, 1e-9 N; 1e-12 W or of a pure number), `known` of its panel, 2e-13 of the magnitude of
/// the values, or the last of the eight digits of a text file.
[[nodiscard]] bool only_rounding(const std::vector<double>& values, const std::string& unit,
                                 double known);

/// "Race interactions 1: load and angle" -> "Race interactions 1, load and angle"
[[nodiscard]] std::string without_colon(std::string title);

/// Values of a curve for a spectrum. Gaps are interpolated linearly, with a note in `told`, if at
/// most 1 % of the values is missing and no gap is longer than half a period of the highest line
/// above 10 % of the largest. Otherwise there are no values, with a reason; gaps at the ends are
/// never filled.
struct Bridged {
  std::vector<double> values;
  std::string told, why_none;
};
[[nodiscard]] Bridged bridge_gaps(const std::vector<double>& t, const std::vector<double>& values,
                                  Window window);

/// Replaces every curve of the page, stored at the times `t` [s], by its amplitude spectrum. Curves
/// without spectrum leave the reason in the panel, or in the note if other curves have one.
void to_spectra(desktop::ChartPage& chart, const std::vector<double>& t,
                const SpectrumOptions& options);

/// Adds a note with the reference of the heights and the line spacing of the spectra [Hz]: nothing
/// is known below the first line.
void tell_lines(desktop::ChartPage& chart, const std::vector<double>& distances,
                const SpectrumOptions& options);

/// Removes marks below the first line of the spectra and adds a note.
void drop_low_marks(desktop::ChartPage& chart);

/// The highest frequency with an amplitude above a level; 0: none.
[[nodiscard]] double last_above(const std::vector<double>& frequency,
                                const std::vector<double>& amplitude, double level);

/// Selects a logarithmic frequency axis for curves whose lines above that fraction of their maximum
/// would otherwise use less than an eighth of the width of the others; adds a note.
void choose_frequency_axis(desktop::ChartPage& chart, const std::vector<double>& ends,
                           double visible);

/// The first view ends shortly after the last amplitude above 1 % of the maximum of its curve; the
/// note gives the largest line outside.
void first_view_of_spectra(desktop::ChartPage& chart, SpectrumScale scale);

}  // namespace adore::adrplot
