#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Type I of record 10.4.4: μ = μ0 exp(α p + β (T0 - T)). SI, kelvin.
struct TypeOneViscosity {
  double mu0 = 0.0, alpha = 0.0, beta = 0.0, T0 = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    return liquid(std::log(mu0) + alpha * p + beta * (T0 - T));
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double) const { return alpha; }
};

}  // namespace adore::tribology
