#pragma once

#include "bearing/bearing.hpp"

#include <optional>
#include <string>
#include <string_view>

/// ISO 281 rating life and ISO 76 static rating, after public implementations and memory: a
/// companion for comparison with catalogues, NOT the Lundberg-Palmgren life of this bearing (the
/// rating factor b_m and the reduction λ differ). Lengths here are in mm and forces in N, as in the
/// standard.
namespace adore::life {

enum class IsoType : unsigned char { RadialBall, ThrustBall, RadialRoller, ThrustRoller };

struct IsoGeometry {
  IsoType type = IsoType::RadialBall;
  double element_diameter = 0.0;                            ///< D_w or D_we [mm]
  double length = 0.0;                                      ///< L_we [mm], rollers
  double pitch_diameter = 0.0;                              ///< D_pw [mm]
  int count = 0;                                            ///< Z per row
  int rows = 1;                                             ///< i
  double contact_angle = 0.0;                               ///< nominal [rad]
  double conformity_inner = 0.52, conformity_outer = 0.52;  ///< groove radius / D_w, balls
  double rating_factor = 1.3;                               ///< b_m
};

/// Axial thrust bearings at 90° measure γ without the angle. @throws InputError
[[nodiscard]] double iso_gamma(const IsoGeometry& geometry);
/// f_c [N, mm]
[[nodiscard]] double iso_fc(const IsoGeometry& geometry);
/// Dynamic rating C (radial or axial) [N]
[[nodiscard]] double iso_dynamic_rating(const IsoGeometry& geometry);
/// Static rating C_0 [N]; empty for thrust bearings, whose factors are not held here.
[[nodiscard]] std::optional<double> iso_static_rating(const IsoGeometry& geometry);
/// Axial static rating of thrust bearings [N]: ball from 4200 MPa at the heavier race with all
/// balls loaded equally, times sin(angle); roller 220 (1 - gamma) Z L D sin(angle) [recalled high].
[[nodiscard]] double iso_thrust_static_rating(const IsoGeometry& geometry);
/// Static rating of self-aligning ball bearings [N]: 4600 MPa at the heavier race, load share Z/5
/// [recalled high]. The conformity of the outer race is that of its sphere.
[[nodiscard]] double iso_self_aligning_static_rating(const IsoGeometry& geometry);
/// f_0 of radial ball bearings: table as recalled, linear in γ.
[[nodiscard]] double iso_static_factor(double gamma);
/// The same from 4200 MPa at conformity 0.52/0.53, 207 GPa and load share Z/5: derived, checks the
/// table.
[[nodiscard]] double iso_static_factor_from_pressure(double gamma);

struct EquivalentLoad {
  double P = 0.0, X = 1.0, Y = 0.0, e = 0.0;
};
/// Radial ball: below 15° deep-groove table in f_0 F_a/C_0 (rows of 5° and 10° are not held), then
/// between rows of 15° and 20°, angular-contact table from 20° to 45°. Radial roller: e = 1.5 tan
/// α, X 0.4, Y 0.4 cot α. Thrust: P = F_a, empty when a radial load acts.
[[nodiscard]] std::optional<EquivalentLoad> iso_equivalent_load(const IsoGeometry& geometry,
                                                                double radial, double axial);

/// 3 for balls, 10/3 for rollers.
[[nodiscard]] double iso_load_exponent(IsoType type);

/// a_1 = 0.95 (ln(1/S)/ln(1/0.9))^(2/3) + 0.05: three-parameter Weibull, within 1.6 % of the table.
[[nodiscard]] double iso_reliability_factor(double survival);

struct AisoResult {
  double value = 0.1;
  bool outside = false;  ///< κ < 0.1: not covered by the standard
};
/// @param load_ratio e_C C_u / P
[[nodiscard]] AisoResult iso_life_factor(IsoType type, double kappa, double load_ratio);

/// e_C = min(C1 κ^0.68 D_pw^0.55, 1)(1 - C2/D_pw^(1/3)), not below 0. @param code e.g.
/// "oil_online_17/14", "grease_slight" @throws InputError naming the codes
[[nodiscard]] double iso_contamination(std::string_view code, double kappa, double pitch_mm);

/// ν_1 [mm²/s]: 45000 n^-0.83 D_pw^-0.5 below 1000 rpm, else 4500 n^-0.5 D_pw^-0.5.
[[nodiscard]] double iso_reference_viscosity(double rpm, double pitch_mm);

/// Fatigue load limit: C_0/22 (balls) or C_0/8.2 (rollers), times the size factor above 100 mm [N].
[[nodiscard]] double iso_fatigue_limit_simple(IsoType type, double static_rating, double pitch_mm);
/// From the load Q_u of 1500 MPa in the worse race: 0.2288 Z Q_u i cos α, balls [N].
/// @param E [Pa] @param nu of both bodies @param pressure [Pa]
[[nodiscard]] double iso_fatigue_limit_ball(const IsoGeometry& geometry, double E, double nu,
                                            double pressure = 1.5e9);

}  // namespace adore::life
