#pragma once

#include "base/constants.hpp"
#include "bearing/material.hpp"
#include "contact/hertz.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// Normal load of closely conforming contacts, where Hertz alone would stiffen without bound. SI.
/// All laws are C1, convex, exactly zero without overlap, and own a closed-form potential: load =
/// d(energy)/d(approach).
namespace adore::contact {

/// Ball in pocket. Q = K δ^1.5 up to δ_c, where the major half axis reaches χ r_b; the tangent
/// beyond. Basis: the stiffness of a frictionless half-space contact is that of a flat punch on the
/// present patch, so freezing the patch freezes the slope.
struct CappedHertz {
  double K = 0.0;          ///< [N m^-1.5]
  double delta_cap = 0.0;  ///< δ_c [m]
  double slope_cap = 0.0;  ///< dQ/dδ beyond δ_c [N/m]
  double load_cap = 0.0;   ///< Q(δ_c) [N]
};

/// @param a1 major half axis per √δ [m^0.5], a = a1 √δ
/// @param E_star 1/E* = Σ(1-ν²)/E [Pa]; the slope 2E*χ r_b rules when K or a1 is infinite (no
/// clearance at all)
[[nodiscard]] CappedHertz capped_hertz(double K, double a1, double ball_radius, double E_star,
                                       double cap_ratio = 0.5);

/// Load [N] at penetration δ [m].
[[nodiscard]] inline double load(const CappedHertz& law, double delta) noexcept {
  if (delta <= 0.0) return 0.0;
  if (delta <= law.delta_cap) return law.K * delta * std::sqrt(delta);
  return law.load_cap + law.slope_cap * (delta - law.delta_cap);
}

/// dQ/dδ [N/m].
[[nodiscard]] inline double slope(const CappedHertz& law, double delta) noexcept {
  if (delta <= 0.0) return 0.0;
  return delta <= law.delta_cap ? 1.5 * law.K * std::sqrt(delta) : law.slope_cap;
}

/// ∫ Q dδ [J].
[[nodiscard]] inline double energy(const CappedHertz& law, double delta) noexcept {
  if (delta <= 0.0) return 0.0;
  if (delta <= law.delta_cap) return 0.4 * law.K * delta * delta * std::sqrt(delta);
  const double beyond = delta - law.delta_cap;
  return 0.4 * law.load_cap * law.delta_cap +
         (law.load_cap + 0.5 * law.slope_cap * beyond) * beyond;
}

/// Constants of a ball in a pocket wall, with what a report wants of the uncapped Hertz contact.
struct PocketLaw {
  CappedHertz law;
  HertzConstants hertz;
  double E_star = 0.0;  ///< [Pa]
};

/// Set-up from materials and the wall curvatures [around, along] (concave negative), relative
/// curvatures 2/D + wall. A wall that fits the ball (relative curvature below 1e-6 of 2/D) is taken
/// at that limit: Hertz is then capped at once. Evaluated once per pocket at the wall middle and
/// kept: a constant that followed the contact place would have no potential.
/// @throws InputError when a size or modulus is not positive.
[[nodiscard]] PocketLaw ball_pocket_law(const bearing::Material& ball,
                                        const bearing::Material& cage, double ball_diameter,
                                        const std::array<double, 2>& wall_curvature,
                                        double cap_ratio = 0.5);
/// The same from the contact modulus E* [Pa].
[[nodiscard]] PocketLaw ball_pocket_law(double E_star, double ball_diameter,
                                        const std::array<double, 2>& wall_curvature,
                                        double cap_ratio = 0.5);

/// Guide land: a cylinder in a cylinder as an elastic foundation of radial springs k_w = 3πE*/(16
/// R) per area. Circular and aligned, eccentricity e beyond the radial clearance c, ψ0 = acos(c/e):
/// F/L = (3π/16) E* (e ψ0 - c sin ψ0). The factor makes small loads agree with F/L = (π/2) E* δ
/// √(δ/(2(ΔR+δ))) [liu2007].
struct LandLaw {
  double E_star = 0.0;     ///< [Pa]
  double clearance = 0.0;  ///< radial clearance c [m]; <= 0: contact all around (interference)
};

namespace detail {

/// Twice the half angle of contact, x = 2ψ0 in [0, 2π].
inline double land_contact_arc(const LandLaw& law, double e) noexcept {
  if (law.clearance <= -e) return 6.283185307179586476925;
  return 2.0 * std::atan2(std::sqrt((e - law.clearance) * (e + law.clearance)), law.clearance);
}

/// x - sin x without cancellation.
inline double x_minus_sin(double x) noexcept {
  if (x > 0.5) return x - std::sin(x);
  const double s = x * x;
  return x * s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110 * (1 - s / 156)))));
}

/// x (2 + cos x) - 3 sin x = x^5/60 - x^7/1260 + x^9/60480 ... without cancellation.
inline double land_energy_shape(double x) noexcept {
  if (x > 0.8) return x * (2 + std::cos(x)) - 3 * std::sin(x);
  const double s = x * x;
  return x * s * s / 60 *
         (1 - s / 21 * (1 - s / 48 * (1 - s / 82.5 * (1 - s / 124.8 * (1 - s / 175)))));
}

}  // namespace detail

/// F/L [N/m] at eccentricity e >= 0 [m], with x = 2ψ0: (3π/32) E* e (x - sin x).
[[nodiscard]] inline double land_load_per_length(const LandLaw& law, double eccentricity) noexcept {
  constexpr double kFactor = 3 * 3.14159265358979323846 / 32;
  if (eccentricity <= law.clearance || eccentricity <= 0.0) return 0.0;
  return kFactor * law.E_star * eccentricity *
         detail::x_minus_sin(detail::land_contact_arc(law, eccentricity));
}

/// d(F/L)/de [Pa]: (3π/32) E* (x + sin x), at most (3π²/32) E* for c >= 0.
[[nodiscard]] inline double land_stiffness_per_length(const LandLaw& law,
                                                      double eccentricity) noexcept {
  constexpr double kFactor = 3 * 3.14159265358979323846 / 32;
  if (eccentricity <= law.clearance || eccentricity <= 0.0) return 0.0;
  const double x = detail::land_contact_arc(law, eccentricity);
  return kFactor * law.E_star * (x + std::sin(x));
}

/// Potential per length [J/m], zero without contact: (3π/64) E* e² (x (2 + cos x) - 3 sin x); with
/// contact all around (3π²/32) E* (e² + 2c²).
[[nodiscard]] inline double land_energy_per_length(const LandLaw& law,
                                                   double eccentricity) noexcept {
  const double e = std::max(eccentricity, 0.0), c = law.clearance;
  if (e <= c) return 0.0;
  if (c <= -e) return 3 * kPi * kPi / 32 * law.E_star * (e * e + 2 * c * c);
  return 3 * kPi / 64 * law.E_star * e * e *
         detail::land_energy_shape(detail::land_contact_arc(law, e));
}

}  // namespace adore::contact
