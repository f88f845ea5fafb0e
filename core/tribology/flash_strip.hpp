#pragma once

/// Temperatures of both surfaces along one strip of a film, coupled to its shear. High Peclet
/// number (u b ρc/(2k) > 5): each wall conducts inwards only (Jaeger 1942; Archard 1958, recalled),
///   ΔT(x) = (π kρc u)^(-1/2) ∫_{-b}^{x} q(ξ) (x - ξ)^(-1/2) dξ,
/// the film as in newton_film_walls.hpp with μ = μ* exp(α* p + β* (Tref - T)). Marched in x on
/// cosine-graded cells with q constant in each; in a cell the wall temperatures are repeated with
/// half relaxation. SI.
namespace adore::tribology {

struct FlashStrip {
  double half_length = 0.0, peak_pressure = 0.0, thickness = 0.0;  ///< b, p0, h
  double speed_a = 0.0, speed_b = 0.0;              ///< of the walls, b the faster [m/s]
  double temperature_a = 0.0, temperature_b = 0.0;  ///< of the bodies [K]
  double viscosity = 0.0, reference = 0.0, alpha = 0.0, beta = 0.0, conductivity = 0.0;
  double effusivity2_a = 0.0, effusivity2_b = 0.0;  ///< k ρ c of each body [W² s/(m⁴ K²)]
};

struct FlashResult {
  double force = 0.0;                   ///< ∫τ dx [N/m]
  double heat_a = 0.0, heat_b = 0.0;    ///< ∫q dx [W/m]
  double flash_a = 0.0, flash_b = 0.0;  ///< largest rise of each surface [K]
};

[[nodiscard]] FlashResult flash_strip(const FlashStrip& strip, int cells);

/// Mean and largest rise of a surface under a uniform heat flux q [W/m²] over a band of half length
/// b that moves with u: (4/3) q √(2b/(π kρc u)) and 2 q √(2b/(π kρc u)).
[[nodiscard]] double mean_band_flash(double heat_flux, double half_length, double speed,
                                     double effusivity2);

/// Largest rise under a uniform flux on a circle of radius b, any Peclet number Pe = u b ρc/(2k):
/// 2 q b/(k √(π (1.273 + Pe))) (Tian & Kennedy 1994, recalled).
[[nodiscard]] double circle_flash(double heat_flux, double radius, double conductivity,
                                  double peclet);

}  // namespace adore::tribology
