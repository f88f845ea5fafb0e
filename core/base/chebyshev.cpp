#include "base/chebyshev.hpp"

#include <cmath>
#include <numbers>

namespace adore {

std::vector<double> chebyshev_points(std::size_t n) {
  std::vector<double> points(n);
  for (std::size_t k = 0; k < n; ++k)
    points[k] =
        std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
  return points;
}

std::vector<double> chebyshev_coefficients(const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<double> cosine(4 * n);  // of π j/(2n)
  for (std::size_t j = 0; j < 4 * n; ++j) {
    cosine[j] = std::cos(0.5 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
  }
  std::vector<double> coefficients(n);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      sum += values[k] * cosine[i * (2 * k + 1) % (4 * n)];
    }
    coefficients[i] = (i == 0 ? 1.0 : 2.0) / static_cast<double>(n) * sum;
  }
  while (coefficients.size() > 2 && std::abs(coefficients.back()) < 2e-16) {
    coefficients.pop_back();
  }
  return coefficients;
}

std::vector<double> chebyshev_to_monomial(const std::vector<double>& coefficients) {
  const std::size_t n = coefficients.size();
  std::vector<double> sum(n, 0.0), last(n, 0.0), now(n, 0.0);  // of T_(k-1) and T_k
  if (n == 0) return sum;
  last[0] = 1.0;
  sum[0] = coefficients[0];
  if (n == 1) return sum;
  now[1] = 1.0;
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = 0; i <= k; ++i) sum[i] += coefficients[k] * now[i];
    std::vector<double> next(n, 0.0);  // T_(k+1) = 2 x T_k - T_(k-1)
    for (std::size_t i = 0; i + 1 < n; ++i) next[i + 1] = 2.0 * now[i];
    for (std::size_t i = 0; i < n; ++i) next[i] -= last[i];
    last = now;
    now = next;
  }
  return sum;
}

}  // namespace adore
