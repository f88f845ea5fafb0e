#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Type II of record 10.4.1: μ = μ0 exp(α p + β (1/T - 1/T0)). SI, kelvin, β in kelvin.
struct TypeTwoViscosity {
  double mu0 = 0.0, alpha = 0.0, beta = 0.0, T0 = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    return liquid(std::log(mu0) + alpha * p + beta * (1.0 / T - 1.0 / T0));
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double) const { return alpha; }
};

}  // namespace adore::tribology
