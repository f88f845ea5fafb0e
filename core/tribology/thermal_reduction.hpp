#pragma once

/// Factor by which shear heating in the inlet thins an elastohydrodynamic film. SI.
///   L = μ0 β u²/K (u the mean speed, β = -∂ln μ0/∂T, K conductivity), S = slip/u.
namespace adore::tribology {

[[nodiscard]] constexpr double thermal_loading(double viscosity, double beta, double speed,
                                               double conductivity) noexcept {
  return viscosity * beta * speed * speed / conductivity;
}

/// Gupta, Cheng, Zhu, Forster & Schrand 1992 (recalled), the default of the suite:
///   φ = [1 - 13.2 (p0/E') L^0.42]/[1 + 0.213 (1 + 2.23 S^0.83) L^0.64]
/// without a limit: below 0 when L > (13.2 p0/E')^(-1/0.42), about 160.
[[nodiscard]] double thermal_reduction_raw(double L, double S, double pressure_over_modulus);

/// The same, not below `floor`: φ where φ > floor + w, floor where φ < floor - w, a parabola
/// between, w = floor/2 [choice].
[[nodiscard]] double thermal_reduction(double L, double S, double pressure_over_modulus,
                                       double floor = 0.1);

/// Murch & Wilson 1975 (recalled), pure rolling: 3.94/(3.94 + L^0.62).
[[nodiscard]] double thermal_reduction_rolling(double L);

/// Wilson & Sheu 1983 (recalled; its sliding term is far too strong): 1/[1 + 0.241 (1 + 14.8
/// S^0.83) L^0.64].
[[nodiscard]] double thermal_reduction_sliding(double L, double S);

}  // namespace adore::tribology
