#include "signal/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace adore::signal {

Spectrum amplitude_spectrum(const std::vector<double>& samples, double step, Window window) {
  Spectrum spectrum;
  const std::size_t n = samples.size();
  if (n < 4 || !(step > 0.0)) return spectrum;
  double mean = 0.0, size = 0.0, weights = 0.0;
  for (const double s : samples) {
    mean += s / static_cast<double>(n);
    size = std::max(size, std::abs(s));
  }
  std::vector<double> centered = window_weights(window, n);
  for (std::size_t i = 0; i < n; ++i) {
    weights += centered[i];
    centered[i] *= samples[i] - mean;
  }
  std::vector<std::complex<double>> transform;
  Eigen::FFT<double> fft;
  fft.fwd(transform, centered);
  double largest = 0.0;
  for (std::size_t k = 1; k <= n / 2; ++k) {
    const double sides = 2 * k == n ? 1.0 : 2.0;
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(n) * step));
    spectrum.amplitude.push_back(sides * std::abs(transform[k]) / weights);
    largest = std::max(largest, spectrum.amplitude.back());
  }
  if (!(largest > 2e-13 * size))
    std::fill(spectrum.amplitude.begin(), spectrum.amplitude.end(), 0.0);
  return spectrum;
}

double decibels(double amplitude, double reference, double floor) {
  return amplitude > 0.0 ? std::max(floor, 20.0 * std::log10(amplitude / reference)) : floor;
}

}  // namespace adore::signal
