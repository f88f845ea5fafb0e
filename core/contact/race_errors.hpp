#pragma once

#include "bearing/imperfections.hpp"
#include "contact/race_slope.hpp"
#include "contact/race_surface.hpp"
#include "contact/race_wave.hpp"
#include "contact/slice_circle.hpp"

#include <array>
#include <cmath>
#include <memory>

/// Geometric imperfections of a race over the azimuth ψ of the race's own frame (bearing azimuth
/// minus race rotation, from its z axis) [choice]: for rollers and for ball grooves. SI, rad.
///   elliptical  R(ψ) = AB/√(B² cos² t + A² sin² t), A = R + v1, B = R + v2, t = ψ - v3
///   sinusoidal  R(ψ) = R + v1 sin(v2 ψ + v3)
///   land offset, taper, curvature factor   a sin(nψ + p) each
/// Evaluate once per element and race, at the azimuth of the contact. The formulas: race_wave.hpp.
namespace adore::contact {

using bearing::Harmonic;
using bearing::RaceErrors;

/// Ready for evaluation by race_error_at of race_wave.hpp.
/// @param nominal_radius R: race radius at mid contact, for a groove the radius of its bottom [m]
[[nodiscard]] RaceErrorModel make_race_error_model(const RaceErrors& errors, double nominal_radius);

/// For races in motion: a wave that does not close has a step where the turn closes, over which no
/// finite force lifts an element.
/// @throws InputError naming the number of waves that is not whole
void check_integer_wave_counts(const RaceErrors& errors);

/// At an angle; waves of any number.
[[nodiscard]] inline LocalRaceError race_error_at(const RaceErrors& errors, double nominal_radius,
                                                  double psi) {
  return race_error_at(make_race_error_model(errors, nominal_radius), AzimuthAngle{psi});
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

/// n of the nominal contact in (x, r) where a groove is touched.
[[nodiscard]] inline std::array<double, 2> nominal_groove_normal(const RaceSurface& groove) {
  return {(groove.mid_x - groove.groove_x) / groove.groove_radius,
          (groove.mid_r - groove.groove_centre_radius) / groove.groove_radius};
}

/// ψ of a meridian frame in a race that turned by an angle beyond its axes.
[[nodiscard]] inline AzimuthDirection<double> azimuth_in_rotated_race(const MeridianRotation& at,
                                                                      double cosine,
                                                                      double sine) noexcept {
  return {at.ez * cosine - at.ey * sine, -at.ey * cosine - at.ez * sine};
}

/// A race for rollers that has errors, in motion.
struct WavyRace {
  RaceErrorModel form;
  RaceSurface ideal;
  double curvature_diameter = 0.0;  ///< 2 R_c [m]
  std::array<double, 2> normal{0.0, 1.0};
  std::shared_ptr<const bearing::SurfaceSeries> given;  ///< whose numbers the form reads

  struct LocalSurface {
    RaceSurface surface;
    RaceAzimuthSlope slope;
  };
  [[nodiscard]] LocalSurface at(const AzimuthDirection<double>& psi) const noexcept;
};
/// @param nominal_radius as in make_race_error_model; crown_radius R_c [m]
/// @throws InputError when the waves per turn are not whole numbers
[[nodiscard]] WavyRace make_wavy_race(const RaceErrors& errors, const RaceSurface& ideal,
                                      double nominal_radius, double crown_radius);

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
