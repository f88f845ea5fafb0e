#pragma once

#include <cmath>

namespace adore {

/// Root of f between a and b, where its values have opposite signs: Illinois' regula falsi, until
/// it moves by less than `end`. No throw, no allocation.
template <class F>
double root_between(double a, double f_a, double b, double f_b, double end, const F& f) noexcept {
  for (int n = 0; n < 60 && std::abs(b - a) > end; ++n) {
    const double c = (f_b * a - f_a * b) / (f_b - f_a);
    const double f_c = f(c);
    if (f_c == 0.0) return c;
    if ((f_c > 0.0) == (f_b > 0.0)) {
      const double step = std::abs(c - b);
      b = c, f_b = f_c;
      f_a *= 0.5;
      if (step < end) break;
    } else {
      a = b, f_a = f_b;
      const double step = std::abs(c - b);
      b = c, f_b = f_c;
      if (step < end) break;
    }
  }
  return b;
}

}  // namespace adore
