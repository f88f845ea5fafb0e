#include "tribology/starvation.hpp"

#include "base/gauss.hpp"

#include <cmath>

namespace adore::tribology {
namespace {

/// ∫ of c y^1.5/(1 + c y^1.5)³ from 0 to ψ, with y = z²/(1 - z)² so that the tail is finite and the
/// root at 0 smooth.
double inlet(double psi) {
  const double c = 4.0 * std::sqrt(2.0) / 3.0;
  const double root = std::sqrt(psi), end = std::isinf(psi) ? 1.0 : root / (1.0 + root);
  constexpr int kPanels = 8;
  double sum = 0.0;
  for (int panel = 0; panel < kPanels; ++panel)
    for (const GaussPoint& point : kGauss20) {
      const double z = end * (2 * panel + 1 + point.node) / (2 * kPanels);
      const double w = z / (1.0 - z), y = w * w, g = c * y * w, s = 1.0 + g;
      sum += point.weight * g / (s * s * s) * 2.0 * w / ((1.0 - z) * (1.0 - z));
    }
  return sum * end / (2 * kPanels);
}

}  // namespace

double starvation_parameter(double meniscus, double half_width, double radius,
                            double flooded_film) {
  return meniscus * std::pow(half_width * half_width / (2.0 * radius * flooded_film), 2.0 / 3.0);
}

double starvation_factor(double psi) {
  if (!(psi > 0.0)) return 0.0;
  constexpr double kFlooded = 1e3;  // far beyond where the exponential has underflown
  if (psi > kFlooded) return 1.0;
  return -std::expm1(-1.68005 * std::pow(psi, 0.8315) + 0.260137 * std::pow(psi, 1.558) -
                     0.016146 * std::pow(psi, 2.296));
}

double starvation_factor_cut(double psi) {
  constexpr double kCut = 8.0;
  return psi < kCut ? starvation_factor(psi) : 1.0;
}

double starvation_factor_integral(double psi) {
  if (!(psi > 0.0)) return 0.0;
  const double flooded = inlet(HUGE_VAL);
  // φ - [I(ψ φ^(-2/3))/I(∞)]^(3/4) rises with φ: bisection.
  double low = 0.0, high = 1.0;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double phi = 0.5 * (low + high);
    const double starved = std::pow(inlet(psi * std::pow(phi, -2.0 / 3.0)) / flooded, 0.75);
    (phi > starved ? high : low) = phi;
  }
  return 0.5 * (low + high);
}

}  // namespace adore::tribology
