#include "tribology/pressure_fits.hpp"

#include "base/chebyshev.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

/// Σ c_k T_k(x) in powers of x.
void to_powers(const std::vector<double>& chebyshev, double* power) {
  std::vector<double> last(chebyshev.size(), 0.0), now(chebyshev.size(), 0.0);
  std::fill_n(power, chebyshev.size(), 0.0);
  now[0] = 1.0;  // T_0; T_k+1 = 2 x T_k - T_k-1
  for (std::size_t k = 0; k < chebyshev.size(); ++k) {
    std::vector<double> next(chebyshev.size(), 0.0);
    for (std::size_t i = 0; i < chebyshev.size(); ++i) {
      power[i] += chebyshev[k] * now[i];
      next[i] = (i > 0 ? (k > 0 ? 2.0 : 1.0) * now[i - 1] : 0.0) - last[i];
    }
    last = now;
    now = next;
  }
}

double error_of(const PressurePolynomial& fit, const std::function<double(double)>& value,
                double end) {
  constexpr int kGrid = 211;  // different from all points of the fits
  double largest = 0.0;
  for (int i = 0; i <= kGrid; ++i) {
    const double p = end * i / kGrid;
    largest = std::max(largest, std::abs(fit.at(p) - value(p)));
  }
  return largest;
}

}  // namespace

PolynomialWithError fit_over_pressure(const std::function<double(double)>& value, double end,
                                      double wanted) {
  PolynomialWithError out;
  if (!(end > 0.0)) {
    out.fit.c[0] = value(0.0);
    out.fit.single[0] = static_cast<float>(out.fit.c[0]);
    return out;
  }
  for (int terms = 4; terms <= PressurePolynomial::kMost; terms += 4) {
    std::vector<double> values;
    for (const double x : chebyshev_points(static_cast<std::size_t>(terms)))
      values.push_back(value(0.5 * end * (1.0 + x)));
    const std::vector<double> c = chebyshev_coefficients(values);
    out.fit = {};
    out.fit.terms = static_cast<int>(c.size());
    out.fit.scale = 2.0 / end;
    to_powers(c, out.fit.c);
    for (int k = 0; k < PressurePolynomial::kMost; ++k)
      out.fit.single[k] = static_cast<float>(out.fit.c[k]);
    out.error = error_of(out.fit, value, end);
    if (out.error <= wanted) break;
  }
  return out;
}

double pressure_at_viscosity(const std::function<double(double)>& log_viscosity, double limit,
                             double largest) {
  if (log_viscosity(largest) < limit) return largest;
  double low = 0.0, high = largest;
  if (log_viscosity(low) >= limit) return 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (log_viscosity(middle) < limit ? low : high) = middle;
  }
  return low;
}

}  // namespace adore::tribology
