#pragma once

/// Newtonian lubricant film heated by its own shear, both walls at one temperature T.
///
/// Viscosity μ(p, T') = μ exp(α p - β (T' - T)); conduction across the film only, pressure and
/// shear stress constant through it. Then K dT/μ = -(u - Δu/2) du holds through the film and gives
///   S = Δu sqrt(β μ1/(8 K)),  μ1 = μ exp(α p),  τ = (μ1 Δu/h) asinh(S)/(S sqrt(1 + S²)).
/// Largest at S = 1.509. Source: own derivation, checked against the boundary-value problem; SI
/// units. Limits: no inertia, no limiting stress, exponential pressure law (not to be trusted above
/// ~1.5 GPa).
namespace adore::tribology {

struct NewtonFilm {
  double thickness = 0.0;             ///< h [m], > 0
  double viscosity = 0.0;             ///< μ at the wall temperature and p = 0 [Pa s]
  double pressure_exponent = 0.0;     ///< α [1/Pa]
  double temperature_exponent = 0.0;  ///< β [1/K], >= 0
  double conductivity = 0.0;          ///< K [W/(m K)], > 0
};

/// τ [Pa] for slip Δu >= 0 [m/s] at pressure p [Pa].
[[nodiscard]] double film_shear_stress(const NewtonFilm& film, double slip,
                                       double pressure) noexcept;

}  // namespace adore::tribology
