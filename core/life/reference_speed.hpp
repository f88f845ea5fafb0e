#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Thermal reference speed of ISO 15312: speed at which the friction of a bearing under reference
/// conditions is the heat that its seats carry away at 50 K above ambient.
///
///   pi n / 30e3 (M0 + M1) = q_r A_r         n [rpm], M [N mm], A_r [mm^2], heat [W]
///   M0 = 1e-7 f0r (nu n)^(2/3) dm^3 (nu n >= 2000 mm^2/s rpm), else 160e-7 f0r dm^3
///   M1 = f1r P1 dm, dm = (d + D)/2, P1 = 5 % of C0 (thrust roller bearings 2 %)
///   radial: A_r = pi B (D + d) (tapered: total width), nu 12 mm^2/s,
///           q_r = 0.016 W/mm^2, times (A_r/50000)^-0.34 above 50000 mm^2
///   thrust roller: A_r = pi/2 (D^2 - d^2), nu 24 mm^2/s, q_r = 0.020, exponent -0.16
/// Not for thrust ball bearings, contact seals and axially loaded cylindrical roller bearings.
namespace adore::life {

/// Mean friction factors of a series, oil bath.
struct FrictionFactors {
  double f0r = 0.0, f1r = 0.0;
};
/// @param series "62", "NU2", "302", "811" ... @throws InputError with the known series
[[nodiscard]] FrictionFactors reference_friction_factors(std::string_view series);

struct ReferenceBearing {
  double bore = 0.0, outside = 0.0, width = 0.0;  ///< [m]; width: tapered: total, thrust: not used
  double static_rating = 0.0;                     ///< C0 [N]
  bool thrust_roller = false;
  FrictionFactors friction;
};

struct ReferenceSpeed {
  double speed = 0.0;                          ///< [rpm]
  double seat_area = 0.0, heat_flow = 0.0;     ///< A_r [m^2], q_r [W/m^2]
  double heat = 0.0;                           ///< [W]
  double load_torque = 0.0, oil_torque = 0.0;  ///< M1, M0 [N m]
  double load = 0.0;                           ///< P1 [N]
};

/// @throws InputError for sizes and ratings that are not positive
[[nodiscard]] ReferenceSpeed reference_speed(const ReferenceBearing& bearing);

}  // namespace adore::life
