#pragma once

#include "tribology/viscosity/glass.hpp"

#include <cmath>

namespace adore::tribology {

/// Tait's equation of state: V/V0 = 1 - ln[1 + (p/K0)(1 + K0')]/(1 + K0'),  K0 = K00 exp(-βK T),
/// V0/VR = 1 + aV (T - TR). SI, kelvin.
struct TaitVolume {
  double K0p = 0.0, K00 = 0.0, betaK = 0.0, aV = 0.0, TR = 0.0;

  [[nodiscard]] double bulk_modulus(double T) const { return K00 * std::exp(-betaK * T); }
  /// V/VR.
  [[nodiscard]] double ratio(double p, double T) const {
    return (1.0 + aV * (T - TR)) *
           (1.0 - std::log1p(p / bulk_modulus(T) * (1.0 + K0p)) / (1.0 + K0p));
  }
};

/// Vogel-like scaling (Habchi et al. 2010, Shell T9, recalled): φ = (T/TR)(V/VR)^g,
/// μ = μ∞ exp(BF φ∞/(φ - φ∞));  φ <= φ∞: a glass. SI, kelvin.
struct VogelScalingViscosity {
  double muInf = 0.0, BF = 0.0, phiInf = 0.0, g = 0.0;
  TaitVolume volume;

  [[nodiscard]] double log_viscosity(double p, double T) const {
    const double above = phi(p, T) - phiInf;
    return above > 0.0 ? liquid(std::log(muInf) + BF * phiInf / above) : kLogGlassViscosity;
  }
  [[nodiscard]] double pressure_viscosity_coefficient(double T) const {
    const double here = phi(0.0, T), above = here - phiInf;
    return above > 0.0 ? BF * phiInf * here * g / (volume.bulk_modulus(T) * above * above) : 0.0;
  }

 private:
  [[nodiscard]] double phi(double p, double T) const {
    return T / volume.TR * std::pow(volume.ratio(p, T), g);
  }
};

}  // namespace adore::tribology
