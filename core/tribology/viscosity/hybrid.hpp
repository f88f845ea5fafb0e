#pragma once

#include "tribology/viscosity/glass.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {

/// Hybrid of McEwen and Paluch (Bair 2015, form recalled):
///   μ = A exp(B/(T - T∞)) (1 + a1 p/q)^q exp(CF p/(p∞ - p)),
///   a1(T) = a1 exp(-aT (T - TR)),  p∞(T) = p∞ + p∞' (T - TR).
/// Above 0.9 p∞ ln μ continues with its slope there [choice]. SI, kelvin; T > T∞.
struct HybridViscosity {
  double A = 0.0, B = 0.0, Tinf = 0.0, a1 = 0.0, q = 1.0, CF = 0.0, pInf = 0.0, aT = 0.0,
         pInfT = 0.0, TR = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    const double limit = divergence_pressure(T);
    if (!(T > Tinf) || !(limit > 0.0)) return kLogGlassViscosity;
    const double inside = std::min(p, 0.9 * limit), a = slope(T);
    const double thick = q * std::log1p(a * inside / q) + CF * inside / (limit - inside);
    const double gap = limit - inside;
    const double rise = a / (1.0 + a * inside / q) + CF * limit / (gap * gap);
    return liquid(std::log(A) + B / (T - Tinf) + thick + rise * (p - inside));
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    return slope(T) + CF / divergence_pressure(T);
  }

 private:
  [[nodiscard]] double slope(double T) const { return a1 * std::exp(-aT * (T - TR)); }
  [[nodiscard]] double divergence_pressure(double T) const { return pInf + pInfT * (T - TR); }
};

}  // namespace adore::tribology
