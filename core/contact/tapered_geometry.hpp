#pragma once

#include "contact/race_surface.hpp"

#include <array>

/// Geometry of tapered and of grooved (spherical) roller bearings in the nominal pose, pure-rolling
/// speeds, rib load. SI, rad. Meridian plane (x, r): x along the bearing, r from its axis;
/// mid-length point of the roller at (0, d_m/2); large ends at -x, apex at +x, so that thrust
/// towards +x on the inner race seats it (N40). e_ρ = (sin β, cos β) points outwards across the
/// roller axis a = (cos β, -sin β).
namespace adore::contact {

using Meridian = std::array<double, 2>;  ///< (x, r)

/// Common apex of both races and the rollers [derived, N38]: ν = (α_o - α_i)/2, β = (α_o + α_i)/2,
/// ℓ = D/(2 tan ν), d_m = D sin β/tan ν, contacts at mid length x = ±(D/2) sin β, r = d_m/2 ± (D/2)
/// cos β, apex x = ℓ cos β, cone radius at x = 0: R0 = ℓ cos β tan α. Both lines touch along the
/// whole length.
struct TaperedGeometry {
  double pitch_diameter = 0.0;                ///< d_m, a result, not an input [m]
  double half_angle = 0.0;                    ///< ν of the roller
  double axis_angle = 0.0;                    ///< β of the roller axis
  double apex_distance = 0.0;                 ///< ℓ from mid length along the roller axis [m]
  double apex_x = 0.0;                        ///< [m]
  std::array<Meridian, 2> contact{};          ///< mid contact, outer and inner [m]
  std::array<double, 2> race_angle{};         ///< half angles, outer and inner
  std::array<double, 2> cone_radius_at_x0{};  ///< [m]
};

/// @param race_angle half angles of outer and inner race
/// @throws InputError when not 0 < α_i < α_o < π/2; when the angles are so close that the pitch
/// diameter exceeds kLargestPitchRatio roller diameters (they approach each other: d_m → D (α_o +
/// α_i)/(α_o - α_i) grows without bound, and a rounding δα of the deck moves it by d_m δα/(2ν));
/// when d_m would not exceed D (α_i too small).
[[nodiscard]] TaperedGeometry tapered_geometry(double roller_diameter,
                                               const std::array<double, 2>& race_angle);
inline constexpr double kLargestPitchRatio = 1000.0;

/// Change of the pitch diameter per change of one race angle, d_m/(2ν) in size [m/rad]: how far to
/// trust d_m.
[[nodiscard]] double pitch_diameter_sensitivity(const TaperedGeometry& g);

/// D ± L tan ν. @throws InputError when the roller reaches the apex (L/2 >= ℓ).
struct EndDiameters {
  double large = 0.0, small = 0.0;  ///< [m]
};
[[nodiscard]] EndDiameters end_diameters(const TaperedGeometry& g, double roller_diameter,
                                         double length);

/// Largest number of cones with a common apex that do not overlap: sin ν < sin β sin(π/Z)
/// [derived].
[[nodiscard]] int max_roller_count(const TaperedGeometry& g);

/// The races as surfaces, mid_x at the contacts.
[[nodiscard]] std::array<RaceSurface, 2> tapered_races(const TaperedGeometry& g);

/// Grooves of a spherical tapered bearing: the groove touches the roller at its mid contact, centre
/// = contact - r_g n, n_o = (sin α_o, cos α_o), n_i = -(sin α_i, cos α_i), r_g = 2 f R_c (f on the
/// crown diameter) [derived].
/// @throws InputError when f is not above 0.5 (the limit that fits the crown exactly).
[[nodiscard]] std::array<RaceSurface, 2> grooved_tapered_races(
    const TaperedGeometry& g, double crown_radius, const std::array<double, 2>& curvature_factor);

/// Grooves of a row of spherical rollers of contact angle α: centre = C + σ(D/2)e_ρ - r_g n + g n,
/// n = σ e_ρ, with the normal gap g = (play/4) cos α at each race, which makes the diametral play
/// of the bearing `play` [choice].
struct SphericalRow {
  double normal_gap = 0.0;  ///< g [m]
  std::array<RaceSurface, 2> race{};
};
[[nodiscard]] SphericalRow spherical_row(double roller_diameter, double pitch_diameter,
                                         double contact_angle, double crown_radius,
                                         const std::array<double, 2>& curvature_factor,
                                         double play);

/// Rolling without slip at mid contact [derived]: ω_m = (Ω_o r_o + Ω_i r_i)/(r_o + r_i), ω_s = (Ω_o
/// - ω_m) r_o/(D/2), ω = ω_m e_x + ω_s a. Cylinders and barrels too (r = d_m/2 ± (D/2) cos β). ω_s
/// < 0 for a driven inner race.
struct RollingSpeeds {
  double orbital = 0.0;       ///< ω_m [rad/s]
  double spin = 0.0;          ///< ω_s about a, relative to the orbiting frame [rad/s]
  Vec3 omega = Vec3::Zero();  ///< absolute, azimuth frame [rad/s]
};
/// @param contact_radius r_o, r_i [m]; @param axis_angle β; @param race_speed Ω_o, Ω_i [rad/s]
[[nodiscard]] RollingSpeeds rolling_speeds(const std::array<double, 2>& contact_radius,
                                           double roller_diameter, double axis_angle,
                                           const std::array<double, 2>& race_speed);

/// M = ω_m e_x × H, H = I_a (ω·a)a + I_t(ω - (ω·a)a): what the contacts must supply [N m]; along y.
[[nodiscard]] Vec3 gyroscopic_moment(const RollingSpeeds& speeds, double axis_angle,
                                     double axial_inertia, double transverse_inertia);

/// Frictionless forces on one tapered roller under pure thrust [derived]. Rib normal at angle ε to
/// the bearing axis (ε = α_i - γ for layback γ from the perpendicular to the inner raceway): Q_o =
/// F_a/(Z sin α_o), Q_f cos(α_i - ε) = Q_o sin(α_o - α_i) + F_c sin α_i, Q_i from the radial
/// balance.
struct RibLoads {
  double outer = 0.0, inner = 0.0, rib = 0.0;  ///< Q_o, Q_i, Q_f [N]
};
/// @throws InputError when the outer angle is not positive or the rib normal lies across the
/// raceway normal.
[[nodiscard]] RibLoads rib_loads(double thrust_per_roller, const std::array<double, 2>& race_angle,
                                 double rib_angle, double centrifugal_force);

}  // namespace adore::contact
