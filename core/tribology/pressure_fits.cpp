#include "tribology/pressure_fits.hpp"

#include "base/chebyshev.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

double error_of(const PressureFit& fit, const std::function<double(double)>& value, double end) {
  constexpr int kGrid = 211;  // beside all points of the fits
  double largest = 0.0;
  for (int i = 0; i <= kGrid; ++i) {
    const double p = end * i / kGrid;
    largest = std::max(largest, std::abs(fit.at(p) - value(p)));
  }
  return largest;
}

}  // namespace

MeasuredFit fit_over_pressure(const std::function<double(double)>& value, double end,
                              double wanted) {
  MeasuredFit out;
  if (!(end > 0.0)) {
    out.fit.c[0] = value(0.0);
    return out;
  }
  for (int terms = 4; terms <= PressureFit::kMost; terms += 4) {
    std::vector<double> values;
    for (const double x : chebyshev_points(static_cast<std::size_t>(terms)))
      values.push_back(value(0.5 * end * (1.0 + x)));
    const std::vector<double> c = chebyshev_coefficients(values);
    out.fit = {};
    out.fit.terms = static_cast<int>(c.size());
    out.fit.scale = 2.0 / end;
    std::copy(c.begin(), c.end(), out.fit.c);
    out.error = error_of(out.fit, value, end);
    if (out.error <= wanted) break;
  }
  return out;
}

double pressure_of_viscosity(const std::function<double(double)>& log_viscosity, double limit,
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
