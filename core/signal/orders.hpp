#pragma once

#include "signal/spectrum.hpp"

#include <cstddef>
#include <vector>

/// Order analysis: spectra over events per revolution of the shaft.
namespace adore::signal {

/// Values at equal angles of the shaft.
struct AngleSamples {
  std::vector<double> values;
  double start = 0.0, step = 0.0;  ///< [revolutions]
};

/// Values at equal angles, by default as many as there are stored values: the cubic polynomial
/// through the four nearest stored values over the angle. A tone with p stored values per period
/// loses about (pi/p)^4 of its amplitude (0.3 % at p = 16, 4 % at p = 8).
/// @param turns revolutions at the stored values; they must increase
/// @param count of the angles: fewer than one per stored value anywhere in the run folds vibration
/// above half of their rate into lower orders; 0: as many as there are values
/// Empty for fewer than 16 values, missing values, or turns that do not increase.
[[nodiscard]] AngleSamples angle_samples(const std::vector<double>& turns,
                                         const std::vector<double>& values, std::size_t count = 0);

/// Amplitude over order (events per revolution) of values at known revolutions.
[[nodiscard]] Spectrum order_spectrum(const std::vector<double>& turns,
                                      const std::vector<double>& values,
                                      Window window = Window::Hann);

}  // namespace adore::signal
