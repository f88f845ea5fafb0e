#pragma once

#include "bearing/bearing.hpp"
#include "thermal/assembly.hpp"

/// From the bearing on the bench to the bearing at work: the one explicit step between
/// build_bearing and statics.
namespace adore::thermal {

/// The rings of a bearing with shaft and housing, with their growths and speeds.
/// Uses envelope, materials, mounting, temperatures and speeds only, so it serves every bearing
/// type. With material laws the elastic moduli are those at each part's temperature.
/// @param raceway_radius groove bottom or raceway of outer and inner race at room temperature [m]
/// @throws InputError when a raceway is outside its ring, or a temperature is not above 0 K.
[[nodiscard]] MountedRings mounted_rings(const bearing::Bearing& bearing,
                                         const std::array<double, 2>& raceway_radius);

/// Bearing in operation. Of rollers: sizes, pitch diameter and clearance as
/// roller_operating_geometry (assembly.hpp), with cage, inertia and material laws as below. Of
/// balls: fits, temperatures and centrifugal growth change ball diameter, grooves, pitch diameter,
/// clearance, free contact angle, shoulders, cage, guide lands and pockets (theory: ring.hpp,
/// assembly.hpp).
///   D' = D (1 + g_b);  groove radius f_j D (1 + g_j);  Pd' = Pd + 2 (u_o - u_i) - 2 (D' - D);
///   A' = groove radii - D';  cos α' = 1 - Pd'/(2A'), α' = 0 for Pd' <= 0, which stays as preload;
///   circles of curvature centers move with the raceways: R_o' = R_o + u_o - f_o D g_o, R_i' = R_i
///   + u_i + f_i D g_i; pitch diameter such that a ball touching both grooves at α' lies on it.
/// Masses stay, moments of inertia grow by (1 + g)² of their part. The envelope stays the nominal
/// one, as housing and shaft are made. With material laws E, k, c and the expansion
/// coefficient of every part are those at its temperature. The cage turns at its epicyclic speed
/// for its growth. Without growth and pressure the geometry is reproduced bit by bit.
/// The result carries its `operating` report, with warnings where clearance turned negative, an
/// interference came loose, or a hoop stress exceeds the elastic limit.
/// @throws InputError when a temperature is not above 0 K, or the operating clearance allows no
/// contact (α' >= 90°).
[[nodiscard]] bearing::Bearing operating_bearing(const bearing::Bearing& bearing);

/// Change of a roller bearing by fits, temperatures and speeds.
struct OperatingRollers {
  RollerOperatingGeometry rollers;  ///< roller sizes, pitch diameter, clearance, axial setting
  MountedState state;               ///< displacement of the races at any radius (lands, flanges)
  bearing::OperatingFits
      report;  ///< for Bearing::operating; contact angle, end play and loci stay 0
};

/// The same step for a roller bearing of any type, on plain numbers. Uses the envelope, materials,
/// mounting, temperatures and speeds of the bearing (element_material and element_temperature are
/// those of the rollers).
/// @param rollers free geometry, measured radially; raceway_radius at room temperature (cones: mean
/// radii) [m]
/// @param outer_half_angle of a tapered outer raceway [rad]; 0: cylindrical or spherical
/// @throws InputError as mounted_rings and tapered_setting_change.
[[nodiscard]] OperatingRollers operating_roller_bearing(const bearing::Bearing& free,
                                                        const RollerSizes& rollers,
                                                        const std::array<double, 2>& raceway_radius,
                                                        double outer_half_angle);

}  // namespace adore::thermal
