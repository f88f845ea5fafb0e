#pragma once

#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Pages whose curves are amplitudes over frequency.
namespace adore::adrplot {

/// Appends a sentence to the page's note, once.
void add_note(desktop::ChartPage& chart, const std::string& text);

/// What changes by no more than that is how the numbers are kept, not a vibration: a thousandth of
/// the least range of an axis (1e-13 m, 1e-9 N; 1e-12 W or of a pure number), `known` of its
/// panel, 2e-13 of the values' size, or the last of the eight digits of a text file.
[[nodiscard]] bool only_rounding(const std::vector<double>& values, const std::string& unit,
                                 double known);

/// "Race interactions 1: load and angle" -> "Race interactions 1, load and angle"
[[nodiscard]] std::string without_colon(std::string title);

/// Values of a curve for a spectrum. Where at most one in a hundred is missing, and no gap is
/// longer than half a period of the highest line above a tenth of the largest, straight lines
/// bridge the gaps, and `told` says so. Else no values, and why; nothing bridges the ends of a run.
struct Bridged {
  std::vector<double> values;
  std::string told, why_none;
};
[[nodiscard]] Bridged bridge_gaps(const std::vector<double>& t, const std::vector<double>& values,
                                  Window window);

/// Every curve of the page, stored at the times `t` [s], becomes its amplitude spectrum. One
/// without leaves its reason in its panel, or in the page's note beside curves that have one.
void to_spectra(desktop::ChartPage& chart, const std::vector<double>& t,
                const SpectrumOptions& options);

/// Says in the note what the heights are relative to, and how far apart the spectra have lines
/// [Hz]: left of the first one nothing is known, whatever is marked there.
void tell_lines(desktop::ChartPage& chart, const std::vector<double>& distances,
                const SpectrumOptions& options);

/// Marks below the first line of spectra stand where nothing is known: they go, and the note says
/// so.
void drop_low_marks(desktop::ChartPage& chart);

/// The highest frequency with an amplitude above a level; 0: none.
[[nodiscard]] double last_above(const std::vector<double>& frequency,
                                const std::vector<double>& amplitude, double level);

/// Curves whose lines above that part of their largest end at such frequencies are drawn over a
/// logarithmic one at first where the lines of one of them would have less than an eighth of the
/// width of the others', and the note says so.
void choose_frequency_axis(desktop::ChartPage& chart, const std::vector<double>& ends,
                           double visible);

/// The first view ends a little beyond the last amplitude above 1 % of its curve's largest; the
/// note says which is the largest of the lines beyond.
void first_view_of_spectra(desktop::ChartPage& chart, SpectrumScale scale);

}  // namespace adore::adrplot
