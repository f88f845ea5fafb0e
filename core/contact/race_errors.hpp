#pragma once

#include "bearing/imperfections.hpp"
#include "contact/guide_land.hpp"
#include "contact/race_surface.hpp"

#include <array>
#include <cmath>

/// Geometric imperfections of a race over the azimuth ψ of the race's own frame (bearing azimuth
/// minus race rotation, from its z axis) [choice]: for rollers and for ball grooves. SI, rad.
///   elliptical  R(ψ) = AB/√(B² cos² t + A² sin² t), A = R + v1, B = R + v2, t = ψ - v3
///   sinusoidal  R(ψ) = R + v1 sin(v2 ψ + v3)
///   land offset, taper, curvature factor   a sin(nψ + p) each
/// Evaluate once per element and race, at the azimuth of the contact.
namespace adore::contact {

using bearing::Harmonic;
using bearing::RaceErrors;

/// Values at one azimuth.
struct LocalRaceError {
  double radius = 0.0;            ///< R(ψ) - R [m]
  double radius_slope = 0.0;      ///< dR/dψ [m/rad]
  double land_offset = 0.0;       ///< [m]
  double taper = 0.0;             ///< [rad]
  double curvature_factor = 0.0;  ///< change of f [-]
};

/// @param nominal_radius R: race radius at mid contact, for a groove the radius of its bottom [m]
[[nodiscard]] inline LocalRaceError race_error_at(const RaceErrors& errors, double nominal_radius,
                                                  double psi) noexcept {
  LocalRaceError e;
  if (errors.roundness != RaceErrors::Roundness::None) {
    const bool wave = errors.roundness == RaceErrors::Roundness::Sinusoidal;
    LandProfile outline;
    outline.radius = nominal_radius;
    outline.kind = wave ? LandProfile::Kind::Wave : LandProfile::Kind::Ellipse;
    outline.variation_1 = wave ? errors.variation[0] : errors.variation[1];
    outline.variation_2 = wave ? errors.variation[1] : errors.variation[0];
    outline.phase = wave ? errors.variation[2] : 0.0;
    const auto [radius, slope] = outline.at(wave ? psi : psi - errors.variation[2]);
    e.radius = radius - nominal_radius;
    e.radius_slope = slope;
  }
  e.land_offset = errors.land_offset.at(psi);
  e.taper = errors.taper.at(psi);
  e.curvature_factor = errors.curvature_factor.at(psi);
  return e;
}

/// The race as it is at one azimuth.
/// Cone and cylinder: R(x) grows by ΔR and by (x - x_mid) tan τ (to first order in τ on cones: the
/// half angle falls by τ). Groove: radius r_g = 2 f R_c (ball: f D) changes by Δf ·
/// curvature_diameter; the bottom, where the nominal contact is, stays, so the groove centre moves
/// against the nominal contact normal by that change [choice]; ΔR moves it radially.
/// @param curvature_diameter 2 R_c, or the ball's D [m]; @param nominal_normal n of the nominal
/// contact in (x, r)
[[nodiscard]] RaceSurface race_with_error(const RaceSurface& ideal, const LocalRaceError& error,
                                          double curvature_diameter = 0.0,
                                          const std::array<double, 2>& nominal_normal = {
                                              0.0, 1.0}) noexcept;

/// Normal of a wavy race: n - n_r (R'/r) e_ψ, made unit. Without it the wave moves the roller but
/// does no work on it, and the energy ledger does not close [derived]. X and n in the race frame.
[[nodiscard]] inline Vec3 wavy_normal(const Vec3& normal, const Vec3& X_race,
                                      double radius_slope) noexcept {
  if (radius_slope == 0.0) return normal;
  const double r2 = X_race[1] * X_race[1] + X_race[2] * X_race[2], r = std::sqrt(r2);
  const double n_r = (normal[1] * X_race[1] + normal[2] * X_race[2]) / r;
  const Vec3 e_psi(0.0, -X_race[2] / r, X_race[1] / r);  // direction of growing ψ: x × e_r
  return (normal - n_r * radius_slope / r * e_psi).normalized();
}

}  // namespace adore::contact
