#pragma once

#include "signal/window.hpp"

#include <vector>

/// Amplitude spectra of equally spaced samples.
namespace adore::signal {

/// Single-sided amplitudes of sines, in the unit of the samples: mean removed, window w, discrete
/// Fourier transform X; amplitude 2 |X| / sum(w), of the highest line of an even number
/// |X| / sum(w). Exact for a sine at a line; between two lines the window decides: none up to 36 %
/// low, Hann 15 %, flat top 0.1 %. Frequencies k/(n step), k = 1 .. n/2, in Hz for a step in
/// seconds, in orders for a step in revolutions.
/// Without window: sum(amplitude^2) / 2, the highest line of an even number counted twice, is the
/// mean square of the samples without their mean (Parseval); with one, noise_bandwidth() times it.
struct Spectrum {
  std::vector<double> frequency;
  std::vector<double> amplitude;
};
/// Empty for fewer than four samples. Amplitudes below 2e-13 of the largest sample are rounding of
/// the mean and become 0 if no line is higher.
[[nodiscard]] Spectrum amplitude_spectrum(const std::vector<double>& samples, double step,
                                          Window window = Window::None);

/// 20 log10(amplitude / reference) [dB], at least `floor`; `floor` for an amplitude of 0.
[[nodiscard]] double decibels(double amplitude, double reference, double floor);

}  // namespace adore::signal
