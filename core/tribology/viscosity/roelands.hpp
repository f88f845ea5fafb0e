#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Roelands 1966: μ = μR exp{ln(μR/6.31e-5) [-1 + (1 + p/1.96e8)^Z ((T - 138)/(TR - 138))^-S0]}.
/// SI, kelvin; T > 138 K, else a glass. Too stiff above about 1 GPa.
struct RoelandsViscosity {
  double muR = 0.0, TR = 0.0, Z = 0.0, S0 = 0.0;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    if (!(T > kPole)) return kLogGlassViscosity;
    const double H = std::log(muR / kMu), heat = std::pow((T - kPole) / (TR - kPole), -S0);
    return liquid(std::log(muR) + H * (std::pow(1.0 + p / kPressure, Z) * heat - 1.0));
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    return std::log(muR / kMu) * Z / kPressure * std::pow((T - kPole) / (TR - kPole), -S0);
  }

 private:
  static constexpr double kMu = 6.31e-5, kPressure = 1.96e8, kPole = 138.0;
};

}  // namespace adore::tribology
