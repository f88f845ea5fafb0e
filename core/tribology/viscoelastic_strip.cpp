#include "tribology/viscoelastic_strip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::tribology {
namespace {

/// X of X + e sinh X = r, r >= 0, e >= 0. Convex for X > 0, root below both r and asinh(r/e):
/// Newton from the smaller of the two falls to it.
double solve_sinh(double e, double r) {
  double X = std::min(r, std::asinh(r / e));
  for (int i = 0; i < 60; ++i) {
    const double step = (X + e * std::sinh(X) - r) / (1.0 + e * std::cosh(X));
    X = std::max(0.0, X - step);
    if (std::abs(step) <= 1e-15 * (1.0 + X)) break;
  }
  return X;
}

/// X = tanh w of tanh w + e w = r: rises in w and is concave for w > 0, so that Newton from the
/// left of the root never passes it. Left of it are r/(1 + e), (r - 1)/e and, as e w <= e atanh r,
/// atanh(r - e atanh r).
double solve_atanh(double e, double r) {
  double w = std::max(r / (1.0 + e), (r - 1.0) / e);
  if (r < 1.0) {
    const double known = r - e * std::atanh(r);
    if (known > 0.0) w = std::max(w, std::atanh(known));
  }
  for (int i = 0; i < 100; ++i) {
    const double t = std::tanh(w), step = (t + e * w - r) / (1.0 - t * t + e);
    w -= step;
    if (!(step < -1e-13 * (1.0 + w))) break;  // at the root, or past it by rounding
  }
  return std::tanh(w);
}

double on_cells(const ViscoElasticStrip& s, double slip, int cells) {
  double stress = 0.0, x = -s.half_length, sum = 0.0;
  for (int i = 1; i <= cells; ++i) {
    const double angle = std::numbers::pi * i / cells;
    const double next = -s.half_length * std::cos(angle), length = next - x;
    const double p = s.peak_pressure * std::sin(angle);
    const double G = s.modulus + s.modulus_p * p, limit = s.stress + s.stress_p * p;
    const double viscosity = s.viscosity * std::exp(std::min(s.alpha * p, s.log_cap));
    const double k = G * length / s.speed;
    const double right = (stress + k * slip / s.thickness) / limit, e = k / viscosity;
    const double reached = limit * (s.sinh_law ? solve_sinh(e, right) : solve_atanh(e, right));
    sum += 0.5 * (stress + reached) * length;
    stress = reached;
    x = next;
  }
  return sum / (0.5 * std::numbers::pi * s.half_length * s.peak_pressure);
}

}  // namespace

double strip_coefficient(const ViscoElasticStrip& strip, double slip, int cells, bool extrapolate) {
  if (!(slip > 0.0)) return 0.0;
  const double fine = on_cells(strip, slip, cells);
  return extrapolate ? 2.0 * fine - on_cells(strip, slip, cells / 2) : fine;
}

}  // namespace adore::tribology
