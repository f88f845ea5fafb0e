#pragma once

#include "base/constants.hpp"
#include "base/scalar_math.hpp"
#include "bearing/material.hpp"
#include "contact/slice_law.hpp"
#include "contact/subsurface.hpp"

#include <algorithm>
#include <cmath>

/// Line contact: pressure, approach, and the load of a roller slice. SI.
///
/// q load per length [N/m], b half width, p peak pressure, c_i = (1-ν_i²)/(πE_i), R = 1/(1/R1 +
/// 1/R2). In two dimensions the approach has no unique value; four printed formulas are given as
/// they stand.
namespace adore::contact {

inline constexpr double kLineConstantSteel =
    8.06e10;  ///< K_l of Q = K_l L^(8/9) δ^(10/9), steel [N/m²] [recalled, Palmgren]

/// K_l for other materials: scaled by E*/E*_steel, E*_steel of 206 GPa, 0.3 [choice; agrees to 1 %
/// with approach_palmgren].
[[nodiscard]] inline double line_constant(double E_star) noexcept {
  constexpr double kSteel = 206e9 / (2.0 * (1.0 - 0.3 * 0.3));
  return kLineConstantSteel * E_star / kSteel;
}

/// Hertz line contact [johnson1985]: b = √(4 q R/(πE*)), p = 2q/(πb) = √(q E*/(πR)).
struct LinePressure {
  double half_width = 0.0;  ///< b [m]
  double peak = 0.0;        ///< p [Pa]
};
[[nodiscard]] inline LinePressure line_pressure(double q, double relative_curvature,
                                                double E_star) noexcept {
  if (q <= 0.0) return {};
  return {std::sqrt(4.0 * q / (kPi * relative_curvature * E_star)),
          std::sqrt(q * E_star * relative_curvature / kPi)};
}

/// Stresses below a line contact, plane strain: the ellipse of half axes 1e10 b and b; an ellipse
/// differs from the line by about b/a, here 1e-10. Closed forms it must give: orthogonal shear p/4
/// at z = b/2, y = ±(√3/2)b; on the axis σ_y = -p((1+2ζ²)/√(1+ζ²) - 2ζ), σ_z = -p/√(1+ζ²), σ_x =
/// ν(σ_y + σ_z), ζ = z/b.
/// @throws InputError when ν is not in 0 to 0.5 or the line carries no load.
[[nodiscard]] inline SubsurfaceStress line_subsurface_stress(const LinePressure& line,
                                                             double poisson) {
  return subsurface_stress(1e10 * line.half_width, line.half_width, line.peak, poisson);
}

/// δ[mm] = 3.84e-5 Q[N]^0.9/L[mm]^0.8, steel on steel [recalled, Palmgren]. Argument and result in
/// SI.
[[nodiscard]] double approach_palmgren_steel(double load, double length);
/// δ = 3.81 (c1 + c2)^0.9 Q^0.9/L^0.8, any materials [recalled, Palmgren].
[[nodiscard]] double approach_palmgren(double load, double length, const bearing::Material& one,
                                       const bearing::Material& two);
/// δ = 2g/(πEL) ln(πEL²/(g(1 ∓ γ))), g = Q(1-ν²), - inner, + outer race, γ = D/dm; like materials
/// only [recalled, Lundberg].
[[nodiscard]] double approach_lundberg(double load, double length, const bearing::Material& both,
                                       double gamma, int race);
/// Compression of one cylinder from the contact to its centre, q c (2 ln(4 R1/b) - 1) [recalled,
/// Johnson].
[[nodiscard]] double approach_half_cylinder(double q, const bearing::Material& cylinder,
                                            double radius, double half_width);

/// Load of one slice and its derivative.
struct SliceLoad {
  double load = 0.0;   ///< Q [N]
  double slope = 0.0;  ///< dQ/dδ [N/m]
};

[[nodiscard]] inline PowerLaw power_law(double line_constant, double effective_length) noexcept {
  return {line_constant * std::pow(effective_length, -1.0 / 9.0)};
}
[[nodiscard]] inline SliceLoad slice_load(const PowerLaw& law, double width,
                                          double delta) noexcept {
  if (delta <= 0.0 || width <= 0.0) return {};
  const double secant = slice_secant_stiffness(law, width, delta);
  return {secant * delta, (10.0 / 9.0) * secant};
}

/// L_e replaced by the length in contact, min(L_e, 2√(2 R_t δ_max)) [choice, off by default]: for
/// curved rollers on grooves (types 3 and 5), whose L^(-1/9) belongs to the contact. R_t relative
/// transverse radius (1/R_c - 1/r_g)^-1.
struct ContactLength {
  double length = 0.0;
  double log_slope = 0.0;  ///< d ln L/d ln δ_max: 1/2, or 0 once the whole roller touches
};
[[nodiscard]] inline ContactLength contact_length(double effective_length, double transverse_radius,
                                                  double largest_delta) noexcept {
  const double touching = 2.0 * std::sqrt(2.0 * transverse_radius * std::max(largest_delta, 0.0));
  if (!(touching < effective_length)) return {effective_length, 0.0};
  const double shortest = 1e-3 * effective_length;  // keeps L^(-1/9) finite as the contact opens
  return touching > shortest ? ContactLength{touching, 0.5} : ContactLength{shortest, 0.0};
}

/// Half-space law, no roller length in it [recalled, Johnson; the depth term checked against the
/// strain integral]:
///   δ = q c1 (2 ln(4 R1/b) - 1) + q c2 (2 ln(2 d/b) - ν2/(1-ν2)),   b = √(4 q R/(πE*))
/// roller from contact to centre, race from contact to depth d (the ring's thickness; D where that
/// is unknown [choice]). With δ = q(A - B ln q), B = c1 + c2: Newton in x = ln q on x + ln(A - Bx)
/// = ln δ, which is concave and rises up to A - Bx = B, so every step lands left of the root and
/// rises to it. Beyond A - Bx = 2B (b about the size of the roller: no half-space any more) the law
/// goes on along its tangent, so that it exists for every δ [choice].
struct HalfSpaceLaw {
  double roller_compliance = 0.0, race_compliance = 0.0;  ///< c1, c2 [1/Pa]
  double E_star = 0.0;                                    ///< [Pa]
  double depth = 0.0;                                     ///< d [m]
  double race_poisson_ratio = 0.0;                        ///< ν2
};
/// @throws InputError when a modulus or the depth is not positive.
[[nodiscard]] HalfSpaceLaw half_space_law(const bearing::Material& roller,
                                          const bearing::Material& race, double depth);
/// δ for a load per length q > 0 [m].
[[nodiscard]] double half_space_approach(const HalfSpaceLaw& law, double q, double roller_radius,
                                         double race_curvature) noexcept;
/// @param race_curvature signed, added to 1/roller_radius: 1/R_i inner, -1/R_o outer [1/m]
[[nodiscard]] SliceLoad slice_load(const HalfSpaceLaw& law, double width, double delta,
                                   double roller_radius, double race_curvature) noexcept;

}  // namespace adore::contact
