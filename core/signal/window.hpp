#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Window functions of spectra.
namespace adore::signal {

/// Periodic cosine sums over n samples, a = 2 pi i / n:
/// None: 1. Hann: 1 - cos a. Flat top: 1 - 1.93 cos a + 1.29 cos 2a - 0.388 cos 3a + 0.0322 cos 4a
/// (ISO 18431-2). Each has the mean 1, so that the amplitude of a sine at a line is kept.
enum class Window : unsigned char { None, Hann, FlatTop };

[[nodiscard]] std::vector<double> window_weights(Window window, std::size_t n);

/// "Hann window", "flat top window", "no window"
[[nodiscard]] std::string window_name(Window window);

/// Equivalent noise bandwidth in lines: mean(w^2) / mean(w)^2. 1, 1.5 and 3.77 for the three
/// windows. The sum of squared amplitudes over all lines is this factor times that of the signal.
[[nodiscard]] double noise_bandwidth(Window window, std::size_t n);

}  // namespace adore::signal
