#include "adrplot/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace adore::adrplot {

Spectrum relative_spectrum(const std::vector<double>& samples, double step) {
  Spectrum spectrum;
  const std::size_t n = samples.size();
  if (n < 4 || !(step > 0.0)) return spectrum;
  double mean = 0.0, size = 0.0;
  for (const double s : samples) mean += s / static_cast<double>(n);
  std::vector<double> centred(n);
  for (std::size_t i = 0; i < n; ++i) {
    centred[i] = samples[i] - mean;
    size = std::max(size, std::abs(samples[i]));
  }
  std::vector<std::complex<double>> transform;
  Eigen::FFT<double> fft;
  fft.fwd(transform, centred);
  double largest = 0.0;
  for (std::size_t k = 1; k <= n / 2; ++k) {
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(n) * step));
    spectrum.amplitude.push_back(std::abs(transform[k]));
    largest = std::max(largest, spectrum.amplitude.back());
  }
  // A constant leaves rounding errors of the mean only: about 1e-16 of the size per sample.
  const bool still = !(largest > 1e-13 * size * static_cast<double>(n));
  for (double& a : spectrum.amplitude) a = still ? 0.0 : a / largest;
  return spectrum;
}

TimeStep common_time_step(const std::vector<double>& times) {
  constexpr std::size_t kFewest = 16;
  if (times.size() < kFewest)
    return {0.0,
            fmt::format("The frequency spectrum needs at least {} stored steps; {} are loaded.",
                        kFewest, times.size())};
  double smallest = times[1] - times[0], largest = smallest;
  for (std::size_t i = 1; i < times.size(); ++i) {
    smallest = std::min(smallest, times[i] - times[i - 1]);
    largest = std::max(largest, times[i] - times[i - 1]);
  }
  const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  const double rounding = 2e-7 * std::max(std::abs(times.front()), std::abs(times.back()));
  if (!(mean > 0.0))
    return {0.0, "The stored times do not increase, so there is no frequency spectrum."};
  if (largest - smallest > 1e-3 * mean + rounding || rounding > 0.5 * mean)
    return {0.0, fmt::format("The frequency spectrum needs stored steps at equal time intervals. "
                             "Here they range from {:.4g} s to {:.4g} s. "
                             "Run with a constant step size to see this page.",
                             smallest, largest)};
  return {mean, ""};
}

}  // namespace adore::adrplot
