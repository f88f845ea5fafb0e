#pragma once

#include "adrplot/run_motion.hpp"
#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace adore::adrplot {

/// "Contact load, outer race"; user-defined charts name curves by their quantity.
[[nodiscard]] std::string curve_name(const desktop::ChartPanel& panel,
                                     const desktop::ChartCurve& curve);

/// Which of the choices is meant by its name, a part of that, or its number from 1 on, if any.
[[nodiscard]] std::optional<std::size_t> choice_of(const std::vector<std::string>& choices,
                                                   const std::string& wanted);

/// Turns a curve of the page into its spectrogram: frequency across, time or shaft speed upward,
/// amplitude as color, in the scale of the options. Marks of a run with variable speed move with
/// the frequency. The rows of the map are the curves of the panel (ChartMapRows).
/// @param motion stored times and known revolutions
/// @param of the curve (choice_of); default: the first one with values. ChartPage::choices lists
/// those with values
void to_spectrogram(desktop::ChartPage& page, const RunMotion& motion,
                    const SpectrumOptions& options, const std::string& of = {});

/// Is the shaft speed constant within 1 % over the whole run? Then the frequencies of its elements
/// are constant.
[[nodiscard]] bool has_constant_speed(const std::vector<double>& times,
                                      const std::vector<double>& turns);

/// Lowest and highest shaft speed over twentieths of a run [rev/s]; 0, 0: unknown.
[[nodiscard]] std::pair<double, double> speed_range(const std::vector<double>& times,
                                                    const std::vector<double>& turns);

/// "10000 rpm", from rev/s: four digits, never a power of ten.
[[nodiscard]] std::string rpm_text(double speed);

}  // namespace adore::adrplot
