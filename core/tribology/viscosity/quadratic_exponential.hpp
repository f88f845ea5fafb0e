#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Low-pressure law of MIL-L-23699 and MIL-L-27502, d = 1/T - 1/Tr:
///   μ0 = m exp(b1 d + b2 d²),  α = exp(e1 ln μ0 - e0)/μ0,  at pressure μ0 exp(α p).
/// SI, kelvin. Source: resources/lubricants.json.
struct QuadraticExponentialViscosity {
  double m = 0.0, Tr = 0.0, b1 = 0.0, b2 = 0.0, e1 = 0.0, e0 = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    return liquid(log_base_viscosity(T) + pressure_viscosity_coefficient(T) * p);
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    return std::exp((e1 - 1.0) * log_base_viscosity(T) - e0);
  }

 private:
  [[nodiscard]] double log_base_viscosity(double T) const {
    const double d = 1.0 / T - 1.0 / Tr;
    return std::log(m) + (b1 + b2 * d) * d;
  }
};

}  // namespace adore::tribology
