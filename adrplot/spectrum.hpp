#pragma once

#include <string>
#include <vector>

namespace adore::adrplot {

/// Relative amplitude spectrum of equally spaced samples: mean removed, discrete Fourier transform
/// without a window, amplitudes over the largest one (all zero when the signal stands still).
/// Frequencies k/(n dt), k = 1 .. n/2.
struct Spectrum {
  std::vector<double> frequency;  ///< [Hz]
  std::vector<double> amplitude;  ///< 0 to 1
};
Spectrum relative_spectrum(const std::vector<double>& samples, double step);

/// The common time increment of stored steps, or the reason why there is none.
/// Increments may differ by 0.1 % of their mean plus what seven digits of the times explain.
struct TimeStep {
  double step = 0.0;   ///< [s]; 0 when `reason` is not empty
  std::string reason;  ///< a sentence for the page
};
TimeStep common_time_step(const std::vector<double>& times);

}  // namespace adore::adrplot
