#pragma once

#include "contact/roller_profile.hpp"

/// Mass, mass centre and moments of inertia of a roller of any profile, domes and corners included.
/// SI.
///
/// Solid of revolution, s from mid length [derived]:
///   m = πϱ∫ρ² ds,  m s_G = πϱ∫sρ² ds,  I_a = (πϱ/2)∫ρ⁴ ds,  I_t = πϱ∫(ρ⁴/4 + s²ρ²) ds - m s_G²
///   (about the mass centre)
/// 20 Gauss points on each smooth piece: side between the ends of the land, corners over the angle
/// of their tube, domes (a polynomial in s). Relative error about 1e-14 for any crown radius;
/// closed forms of barrels cancel for R_c >> D.
namespace adore::contact {

struct RollerInertia {
  double mass = 0.0;         ///< [kg]
  double mass_centre = 0.0;  ///< s_G; negative: towards the large end of a tapered roller [m]
  double axial = 0.0;        ///< I_a about the axis [kg m²]
  double transverse = 0.0;   ///< I_t about a diameter through the mass centre [kg m²]
};

/// @param with_corners false: corners are taken as sharp although the profile has some, for
/// comparison with closed forms
/// @throws InputError when the shape does not exist or the density is not positive.
[[nodiscard]] RollerInertia roller_inertia(const RollerProfile& profile, double density,
                                           bool with_corners = true);

}  // namespace adore::contact
