#pragma once

#include "tribology/viscosity.hpp"

#include <string>
#include <vector>

/// The lubricants of kTrac 1 to 20 (record 10.0), from the embedded resources/lubricants.json,
/// where every number stands with its unit and where it comes from. SI, kelvin.
///
/// A contact has two regions. The inlet, at low pressure, makes the film: base viscosity μ0(T),
/// α(T). The pressed middle makes the traction, by one of four models:
namespace adore::tribology {

enum class LubricantModel : unsigned char {
  NewtonianThermal,  ///< kTrac 1-7, 9: film heated by its own shear, μ = μ*(T) exp(α* p)
  NewtonianGeneral,  ///< kTrac 10: the same with the measured viscosity over p and T
  ViscoElastic,      ///< kTrac 8, 12: (1/G) dτ/dt + (τ0/μ) F(τ/τ0) = slip/h
  ShearThinning      ///< kTrac 11, 13-20: Carreau-Yasuda with the measured viscosity over p and T
};

/// A property of a lubricant over temperature: a constant, a table (ends held), or
/// k0 + k1 |T - Tr|^m within 233 to 450 K.
struct LubricantProperty {
  std::vector<double> T, value;
  double k0 = 0.0, k1 = 0.0, Tr = 0.0, exponent = 1.0;
  bool signed_distance = true;

  [[nodiscard]] double at(double temperature) const;
};

/// Where a number of a lubricant comes from.
struct LubricantSource {
  std::string quantity;  ///< "traction.alphaT"
  double value = 0.0;
  std::string unit, provenance, source;
};

struct Lubricant {
  int code = 0;
  std::string name;
  LubricantModel model = LubricantModel::NewtonianThermal;
  LubricantProperty density, specific_heat, conductivity;  ///< kg/m³, J/(kg K), W/(m K)
  Viscosity base;     ///< of the inlet; of it only p -> 0 is used for films
  Viscosity pressed;  ///< NewtonianGeneral, ShearThinning: over p and T; ViscoElastic: base
  // NewtonianThermal: μ*(T) = tractionViscosity exp(d (Tref - T)), β*(T) = β0 (T/313 K)^n
  double traction_alpha = 0.0, traction_viscosity = 0.0, traction_reference = 0.0,
         traction_decay = 0.0, film_beta = 0.0, film_beta_exponent = 0.0;
  // ShearThinning: G(T) = G T/TR
  double carreau_G = 0.0, carreau_n = 1.0, carreau_a = 2.0, carreau_TR = 1.0;
  // ViscoElastic: G = (G0 + Gp p) e, τ0 = (τ00 + τ0p p) e, e = exp(-bT (T - 313.15 K))
  bool sinh_law = false;  ///< else atanh: τ0 is a limiting stress
  double modulus = 0.0, modulus_p = 0.0, stress = 0.0, stress_p = 0.0, softening = 0.0;
  /// τ <= Λ p, smooth minimum of fourth order; 0: no limit.
  double limiting_ratio = 0.0;

  std::vector<LubricantSource> sources;
  std::string provenance;  ///< weakest word: "seen", "recalled", "estimated"; "given" by the user

  [[nodiscard]] double base_viscosity(double T) const { return base.at(0.0, T); }
  [[nodiscard]] double base_alpha(double T) const { return base.pressure_coefficient(T); }
  [[nodiscard]] double base_beta(double T) const { return base.temperature_coefficient(0.0, T); }
  /// μ1(p, T) of the traction model [Pa s], at most that of the glass.
  [[nodiscard]] double pressed_viscosity(double pressure, double T) const;
  /// β of the film's own heating, -∂ln μ/∂T [1/K].
  [[nodiscard]] double pressed_beta(double pressure, double T) const;
};

/// Records 10.4.1 and 10.4.4: type II for the inlet, type I for the traction, both at T0.
struct UserLubricant {
  std::string name;
  double T0 = 0.0, viscosity = 0.0, alpha = 0.0, beta = 0.0;  ///< K, Pa s, 1/Pa, K
  double conductivity = 0.0, density = 0.0, specific_heat = 0.0;
  double traction_viscosity = 0.0, traction_alpha = 0.0, traction_beta = 0.0;  ///< Pa s, 1/Pa, 1/K
};

/// @throws InputError naming the codes of the table
[[nodiscard]] const Lubricant& lubricant(int code);
[[nodiscard]] Lubricant user_lubricant(const UserLubricant& given);

/// All codes of the table, ascending (9, the user's, is not among them).
[[nodiscard]] std::vector<int> lubricant_codes();

}  // namespace adore::tribology
