#pragma once

#include "bearing/material.hpp"

#include <optional>
#include <string>
#include <vector>

/// Temperature dependence of the table's materials (resources/materials.json) and thermal strain.
///
/// Laws hold between T_min and T_max and are clamped to the nearest bound outside. Below 293.15 K a
/// cryogenic law replaces the main one where the table has it; otherwise the main law is clamped.
/// Density and Poisson's ratio stay constant, and so do properties without a law and materials
/// given in the deck. Most steels have no cryogenic law for specific heat: near 100 K the clamped
/// value is about twice the true one. Source: materials.json, each law with its own provenance.
namespace adore::bearing {

/// Reference of the mean expansion coefficients [K].
inline constexpr double kStrainReference = 293.15;

/// One property over temperature.
struct PropertyLaw {
  enum class Form : unsigned char {
    Polynomial,       ///< Σ c_i (T - T_ref)^i
    Log10Polynomial,  ///< 10^(Σ c_i (log10 T)^i)
    CopperRational,  ///< log10 k = (c0 + c2 √T + c4 T + c6 T^1.5 + c8 T²)/(1 + c1 √T + c3 T + c5
                     ///< T^1.5 + c7 T²)
    StrainPolynomial  ///< 1e-5 Σ c_i T^i from T_low on, 1e-5 value_low below: strain from 293 K [-]
  };
  Form form = Form::Polynomial;
  std::vector<double> c;
  double T_ref = 0.0;               ///< [K], Polynomial only
  double T_min = 0.0, T_max = 0.0;  ///< range [K]
  double T_low = 0.0, value_low = 0.0;
  std::string provenance, source;

  /// Value in the property's SI unit at T [K], clamped to the range.
  [[nodiscard]] double operator()(double T) const;
};

/// One property as the table has it.
struct PropertyEntry {
  std::string name, unit;       ///< key of the table, SI unit
  std::optional<double> value;  ///< at room temperature; none where the table knows none
  std::string provenance, source;
  std::optional<PropertyLaw> law, cryogenic;
};

/// Everything the table says about one material.
struct MaterialSheet {
  std::string key;  ///< "100", "mild_steel"
  int code = 0;
  std::string name, notes;
  std::vector<PropertyEntry> properties;
  std::optional<PropertyLaw>
      cryogenic_strain;  ///< replaces the expansion coefficient below 293.15 K

  /// @throws InternalError when there is no property of that name.
  [[nodiscard]] const PropertyEntry& property(const std::string& name) const;
  /// Value at T [K] by its laws; the room value where it has none.
  [[nodiscard]] double at(const std::string& name, double T) const;
};

/// Sheet of a key of the table. @throws InputError naming the valid keys.
[[nodiscard]] const MaterialSheet& material_sheet(const std::string& key);

/// A law that ends before the temperature asked for; its value at the nearer bound stands in.
struct ClampedLaw {
  std::string property;
  double T_min = 0.0, T_max = 0.0;  ///< range of the law [K]
};

/// Of material_at(material, T): elastic modulus, expansion, conductivity and specific heat. Empty
/// within all ranges, and for a material without laws.
[[nodiscard]] std::vector<ClampedLaw> clamped_laws(const Material& material, double T);

/// ε(T) = α_m(T) (T - 293.15 K), strain from 293.15 K [-]. Laws off: constant coefficient.
/// @param T [K], > 0. @throws InputError when it is not.
[[nodiscard]] double thermal_strain(const Material& material, double T, bool laws);

/// g = ε(T) - ε(T_room): every free dimension of the part becomes (1 + g) times its size at room
/// temperature [-]. Constant coefficient: g = α (T - T_room), exactly 0 at T = T_room. @throws
/// InputError when a temperature is not > 0.
[[nodiscard]] double thermal_growth(const Material& material, double T, double T_room, bool laws);

/// The material with elastic modulus, mean expansion coefficient, conductivity and specific heat at
/// T [K]. A material of the deck comes back as it is. @throws InputError when T is not > 0.
[[nodiscard]] Material material_at(const Material& material, double T);

}  // namespace adore::bearing
