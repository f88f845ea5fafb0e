#pragma once

#include <functional>

/// Newtonian film heated by its own shear between walls of different temperature, and with any
/// viscosity over temperature. As in newton_film.hpp: conduction across the film only, pressure and
/// shear stress τ constant through it, so that K T'' = -τ u', u' = τ/μ. Then K dT/μ = -(u - u*) du
/// for every μ(T), u* the speed where the heat flux turns. Own derivation, checked against the
/// boundary-value problem. SI.
namespace adore::tribology {

struct FilmShear {
  double stress = 0.0;                ///< τ [Pa], >= 0
  double heat_a = 0.0, heat_b = 0.0;  ///< into wall a (at rest) and b (moving with the slip) [W/m²]
  double hottest = 0.0;               ///< rise of the middle over the walls; equal walls only [K]
};

/// μ = μ_a exp(-β (T - T_a)); wall a at rest, b at `slip` >= 0:
///   u* = U/2 + K/(β U) (1/μ_b - 1/μ_a), 1/μ_m = 1/μ_a + β u*²/(2K), c = √(β μ_m/(2K)),
///   τ = μ_m/(h c) [atanh c(U - u*) + atanh c u*],  q_a = τ u*,  q_b = τ (U - u*).
/// @param viscosity_a, viscosity_b μ at each wall's temperature [Pa s], > 0; β > 0
[[nodiscard]] FilmShear film_shear_between_walls(double viscosity_a, double viscosity_b,
                                                 double beta, double conductivity, double thickness,
                                                 double slip);

/// Any μ(T), both walls at T1: T_m from ∫_{T1}^{Tm} dT/μ = U²/(8K), then τ = (2/h) ∫ K dT/v with v²
/// = 2K ∫_T^{Tm} dT/μ, by 20 Gauss points each in s, T = T_m - s². A middle hotter than T1 + 2000 K
/// is not looked for: the rise stays there and τ is that of the slip which makes it.
[[nodiscard]] FilmShear film_shear_any_viscosity(const std::function<double(double T)>& viscosity,
                                                 double wall_temperature, double conductivity,
                                                 double thickness, double slip);

}  // namespace adore::tribology
