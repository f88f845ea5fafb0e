#pragma once

#include "bearing/lubrication.hpp"

#include <optional>
#include <string>

/// Oils by their grade: viscosities at two temperatures, or one and the viscosity index.
///
/// Viscosity (ASTM D341, Walther): lg lg(ν + 0.7) = A - B lg T, ν in mm²/s above 2, T in K.
/// Viscosity index (ASTM D2270): reference oils L and H of the same viscosity at 100 °C.
/// Estimates where the user gives no value, by base oil [recalled, medium]:
/// - density at 15 °C; it falls by 0.65 kg/m³ per K;
/// - pressure coefficient α = s ν(T)^t 1e-9 /Pa (Gold et al. 2001), a secant to 200 MPa; measured
///   coefficients of the same base oil differ by 25 %;
/// - heat conductivity and specific heat.
namespace adore::bearing {

enum class BaseOil : unsigned char { Mineral = 1, Polyalphaolefin, Ester, Polyglycol };

struct OilGradeInput {
  std::string name;
  BaseOil base = BaseOil::Mineral;
  bool grease = false;                         ///< viscosities are those of the base oil
  std::optional<int> grade;                    ///< ISO VG: ν at 40 °C [mm²/s]
  std::optional<double> viscosity_index;       ///< with a grade or one viscosity at 40 °C
  std::optional<double> first, second;         ///< ν [m²/s]
  std::optional<double> first_at, second_at;   ///< [K]; empty: 40 and 100 °C
  std::optional<double> density;               ///< at 15 °C [kg/m³]
  std::optional<double> pressure_coefficient;  ///< at 40 °C [1/Pa]
  std::optional<double> bearing_temperature;   ///< for ISO 281 [K]
};

struct OilByGrade {
  OilGradeInput given;
  double A = 0.0, B = 0.0;  ///< Walther
  double viscosity_index = 0.0;
  bool index_given = false;  ///< the user gives it, or two viscosities
  double density = 0.0;      ///< at 15 °C [kg/m³]

  /// ν(T) [m²/s]
  [[nodiscard]] double kinematic_viscosity(double T) const;
  /// ρ(T) [kg/m³]
  [[nodiscard]] double density_at(double T) const;
  /// μ(T) [Pa s]
  [[nodiscard]] double viscosity(double T) const;
  /// α(T) [1/Pa]: the given one follows the estimate's change with temperature.
  [[nodiscard]] double pressure_coefficient(double T) const;
  /// "ISO VG 68 mineral oil"
  [[nodiscard]] std::string name() const;
  /// "viscosity index (95), density (880 kg/m³ at 15 °C)"; empty when the user gives all of them
  [[nodiscard]] std::string estimates() const;
};

/// @throws InputError for contradicting or missing data
[[nodiscard]] OilByGrade oil_by_grade(const OilGradeInput& given);

/// VI of viscosities at 40 and 100 °C [mm²/s]; L and H by interpolation, within 0.7 % and 0.2 %.
[[nodiscard]] double viscosity_index(double at_40, double at_100);

/// As a lubricant of films and traction. Type II viscosity with the value and slope of Walther's
/// law at T0, traction viscosity with the same value, slope and pressure coefficient; the limiting
/// shear stress is that of every user lubricant.
[[nodiscard]] UserLubricant film_oil(const OilByGrade& oil, double T0);

}  // namespace adore::bearing
