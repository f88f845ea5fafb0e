#pragma once

#include "bearing/lubrication.hpp"
#include "tribology/viscosity.hpp"

#include <string>
#include <vector>

/// The lubricants of kTrac 1 to 20 (record 10.0), from the embedded resources/lubricants.json,
/// where every number has its unit and source. SI, kelvin.
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

/// Source of a number of a lubricant.
struct LubricantSource {
  std::string quantity;  ///< "traction.alphaT"
  double value = 0.0;
  std::string unit, provenance, source;
};

/// Limiting shear stress τ_L = Λ(T) p (laws/limited.hpp), T the temperature of the walls:
/// Λ = ratio exp(-softening (T - reference)). ViscoElastic: the law has its own (stress, stress_p).
struct StressLimit {
  double ratio = 0.0;         ///< Λ at the reference; 0: no limit
  double softening = 0.0;     ///< [1/K]
  double reference = 313.15;  ///< [K]
  std::string provenance;     ///< of the ratio

  [[nodiscard]] double at(double temperature) const;
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
  StressLimit limit;

  std::vector<LubricantSource> sources;
  std::string provenance;  ///< weakest word: "seen", "recalled", "estimated"; "given" by the user

  [[nodiscard]] double base_viscosity(double T) const { return base.at(0.0, T); }
  [[nodiscard]] double base_alpha(double T) const { return base.pressure_coefficient(T); }
  [[nodiscard]] double base_beta(double T) const { return base.temperature_coefficient(0.0, T); }
  /// μ1(p, T) of the traction model [Pa s], at most that of the glass.
  [[nodiscard]] double viscosity_under_pressure(double pressure, double T) const;
  /// β of the film's own heating, -∂ln μ/∂T [1/K].
  [[nodiscard]] double beta_under_pressure(double pressure, double T) const;
  /// Limiting shear stress over pressure at high pressure, Λ(T); 0: no limit.
  [[nodiscard]] double limiting_ratio(double T) const;
};

/// @throws InputError naming the codes of the table
[[nodiscard]] const Lubricant& lubricant(int code);
/// Λ at 40 °C of a user's lubricant without a given value: middle of mineral oils (0.06 to 0.09
/// between discs, Johnson & Cameron 1967 [recalled, medium]) and esters (0.03 to 0.08) [choice].
inline constexpr double kUserLimit = 0.07;
[[nodiscard]] Lubricant user_lubricant(const bearing::UserLubricant& given);
/// The lubricant of a deck: of the table, or the user's, without a stress limit if the run has
/// none.
[[nodiscard]] Lubricant lubricant_of(const bearing::Lubrication& lubrication);

/// Codes that describe one oil, and the one whose traction law is recommended.
struct Oil {
  std::string name;
  std::vector<int> codes;  ///< ascending
  int recommended = 0;
  std::string why;
};
/// The oil of a code of the table; of one that no other code describes the code alone.
[[nodiscard]] Oil oil_of(int code);

/// All codes of the table, ascending (9, the user's, is not among them).
[[nodiscard]] std::vector<int> lubricant_codes();

}  // namespace adore::tribology
