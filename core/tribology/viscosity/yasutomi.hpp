#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Improved Yasutomi (Bair, Mary, Bouscharain & Vergne 2013, recalled):
///   Tg = Tg0 + A1 ln(1 + A2 p),  F = (1 + b1 p)^b2,  X = (T - Tg) F,
///   log10 μ = log10 μg - C1 X/(C2 + X);  X <= 0: the glass, μg.
/// SI, kelvin. Fitted below about 1 GPa.
struct YasutomiViscosity {
  double mug = 0.0, Tg0 = 0.0, A1 = 0.0, A2 = 0.0, b1 = 0.0, b2 = 0.0, C1 = 0.0, C2 = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    const double X = (T - Tg0 - A1 * std::log1p(A2 * p)) * std::pow(1.0 + b1 * p, b2);
    const double drop = X > 0.0 ? std::log(10.0) * C1 * X / (C2 + X) : 0.0;
    return liquid(std::log(mug) - drop);
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    const double above = T - Tg0, bottom = C2 + above;
    if (!(above > 0.0)) return 0.0;
    return std::log(10.0) * C1 * C2 / (bottom * bottom) * (A1 * A2 - above * b1 * b2);
  }
};

}  // namespace adore::tribology
