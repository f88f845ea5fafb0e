#pragma once

#include <string>
#include <vector>

/// Coolants and churning media over temperature, from the embedded resources/fluids.json (codes 3
/// to 14 of kCoolant and kChrn, and the generic lubricant 1). Correlations: polynomial and
/// exponential polynomial in (T - T0)/S, ideal gas ρ = p/(R T), Walther ν = 10^(10^(A - B log10 T))
/// - 0.7 mm²/s. Provenance stands with each entry of the file.
namespace adore::tribology {

struct FluidProperties {
  std::string name, provenance;     ///< weakest provenance word of the four correlations
  double density = 0.0;             ///< [kg/m^3]
  double viscosity = 0.0;           ///< dynamic [Pa s]
  double specific_heat = 0.0;       ///< [J/(kg K)]
  double conductivity = 0.0;        ///< [W/(m K)]
  double T_min = 0.0, T_max = 0.0;  ///< common range of the correlations [K]
  bool clamped = false;             ///< T was outside and was taken as the nearest bound
};

/// Properties at T [K]. @throws InputError for T not above 0 or a code without an entry, naming the
/// valid codes.
[[nodiscard]] FluidProperties fluid_properties(int code, double T);

/// All codes of the table, ascending.
[[nodiscard]] std::vector<int> fluid_codes();

}  // namespace adore::tribology
