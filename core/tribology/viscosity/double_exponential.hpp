#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Low-pressure law of MIL-L-7808: μ0 = c0 (exp(exp(c1 ln T + c2)) - c3), α = p0 + p1/(T - p2); at
/// pressure μ0 exp(α p). SI, kelvin; T > p2. Source: resources/lubricants.json.
struct DoubleExponentialViscosity {
  double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0, p0 = 0.0, p1 = 0.0, p2 = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    const double inner = std::exp(c1 * std::log(T) + c2);
    // ln(e^x - c3) without overflow.
    return liquid(std::log(c0) + inner + std::log1p(-c3 * std::exp(-inner)) +
                  pressure_viscosity_coefficient(T) * p);
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    return T > p2 ? p0 + p1 / (T - p2) : 1.0;
  }
};

}  // namespace adore::tribology
