#include "signal/orders.hpp"

#include "signal/sampling.hpp"

#include <algorithm>
#include <cmath>

namespace adore::signal {
namespace {

/// The polynomial of third degree through four points (Lagrange).
double cubic_at(const double* x, const double* y, double where) {
  double out = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double term = y[i];
    for (std::size_t k = 0; k < 4; ++k)
      if (k != i) term *= (where - x[k]) / (x[i] - x[k]);
    out += term;
  }
  return out;
}

}  // namespace

AngleSamples angle_samples(const std::vector<double>& turns, const std::vector<double>& values,
                           std::size_t count) {
  AngleSamples out;
  const std::size_t n = turns.size();
  if (n < kMinSamples || values.size() != n) return out;
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(values[i]) || !std::isfinite(turns[i]) ||
        (i > 0 && !(turns[i] > turns[i - 1])))
      return out;
  if (count < 2) count = n;
  out.start = turns.front();
  out.step = (turns.back() - turns.front()) / static_cast<double>(count - 1);
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double where = std::min(out.start + out.step * static_cast<double>(i), turns.back());
    while (at + 2 < n && turns[at + 1] < where) ++at;
    const std::size_t first = std::min(at > 0 ? at - 1 : 0, n - 4);
    out.values.push_back(cubic_at(turns.data() + first, values.data() + first, where));
  }
  return out;
}

Spectrum order_spectrum(const std::vector<double>& turns, const std::vector<double>& values,
                        Window window) {
  const AngleSamples samples = angle_samples(turns, values);
  return amplitude_spectrum(samples.values, samples.step, window);
}

}  // namespace adore::signal
