#include "signal/envelope.hpp"

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace adore::signal {

std::vector<double> envelope(const std::vector<double>& samples, double step, double low,
                             double high) {
  const std::size_t n = samples.size();
  if (n < 4 || !(step > 0.0)) return {};
  double mean = 0.0;
  for (const double s : samples) mean += s / static_cast<double>(n);
  std::vector<double> centered(n);
  for (std::size_t i = 0; i < n; ++i) centered[i] = samples[i] - mean;
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  fft.fwd(transform, centered);
  bool any = false;
  for (std::size_t k = 0; k < n; ++k) {
    const double frequency = static_cast<double>(k) / (static_cast<double>(n) * step);
    const bool inside = k > 0 && 2 * k <= n && frequency >= low && frequency <= high;
    // The highest line of an even number is its own mirror image.
    transform[k] *= inside ? (2 * k == n ? 1.0 : 2.0) : 0.0;
    any = any || inside;
  }
  if (!any) return {};
  std::vector<std::complex<double>> analytic;
  fft.inv(analytic, transform);
  std::vector<double> out(n);
  for (std::size_t i = 0; i < n; ++i) out[i] = std::abs(analytic[i]);
  return out;
}

}  // namespace adore::signal
