#pragma once

/// Carreau-Yasuda film between equal walls. SI.
///   η = μ [1 + (μ γ̇/G)^a]^((n-1)/a),  γ̇ = slip/h when isothermal.
/// Heated by its own shear (β acts on μ, G constant through the film) the film keeps the closed
/// form of newton_film.hpp with μ replaced by η* = μ τ/y(τ), y the Newtonian stress μγ̇ that gives
/// τ: own derivation, agrees with the boundary-value problem to 1e-12.
namespace adore::tribology {

struct ShearThinningFilm {
  double thickness = 0.0;     ///< h [m]
  double viscosity = 0.0;     ///< μ at wall temperature and pressure [Pa s]
  double modulus = 0.0;       ///< G [Pa]
  double n = 1.0, a = 2.0;    ///< 0 < n <= 1, a > 0
  double beta = 0.0;          ///< -∂ln μ/∂T [1/K]
  double conductivity = 0.0;  ///< K [W/(m K)]
};

struct ShearThinningStress {
  double isothermal = 0.0, thermal = 0.0;  ///< [Pa]
  double hottest = 0.0;                    ///< rise of the middle [K]
};

/// @param slip >= 0 [m/s]
[[nodiscard]] ShearThinningStress shear_thinning_stress(const ShearThinningFilm& film, double slip);

}  // namespace adore::tribology
