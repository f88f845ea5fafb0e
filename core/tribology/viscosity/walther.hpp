#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Low-pressure law of the Santotracs and 5P4E, after Walther with a falling density:
///   μ0 = 1e-3 (d0 + d1 (422.2222 - T)) (10^(10^(m log10 T + n)) - 0.8) Pa s,
///   α = α0 exp(-γ (T - 277.78)),  at pressure μ0 exp(α p).
/// SI, kelvin; densities in g/cm³. Source: resources/lubricants.json.
struct WaltherViscosity {
  double d0 = 0.0, d1 = 0.0, m = 0.0, n = 0.0, alpha0 = 0.0, gamma = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    const double outer = std::log(10.0) * std::pow(10.0, m * std::log10(T) + n);
    const double density = 1e-3 * (d0 + d1 * (422.2222 - T));
    return liquid(std::log(density) + outer + std::log1p(-0.8 * std::exp(-outer)) +
                  pressure_viscosity_coefficient(T) * p);
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    return alpha0 * std::exp(-gamma * (T - 277.78));
  }
};

}  // namespace adore::tribology
