#pragma once

#include "bearing/rollers.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_flange.hpp"
#include "contact/roller_profile.hpp"
#include "statics/slice_potential.hpp"

#include <array>
#include <vector>

/// Forces of race flanges on roller ends (contact/roller_flange.hpp) in the relative coordinates of
/// slice_potential.hpp.
///
/// Q = K δ^1.5 with K of the nominal pose's contact, so that the force has a potential [choice];
/// the gradient of the gap is exact (it is a minimum over the roller end: only the contact point
/// and the normal enter), its curvature comes from central differences of that gradient.
namespace adore::statics {

/// One flange and the roller end that faces it.
struct FlangePair {
  int race = 0, side = 0;  ///< side 0: -x
  contact::FlangeFace face;
  contact::RollerEnd end;
  double E_star = 0.0;
};

/// The flanges of both races with their faces placed (rollers.md 5): two on one race leave the
/// deck's play for the ideal roller; the rib of a tapered bearing touches the ideal roller; a
/// single flange on a cylindrical race leaves half the other race's play.
/// @throws InputError naming the flange that cannot be.
[[nodiscard]] std::vector<FlangePair> flange_pairs(const bearing::RollerGeometry& rollers,
                                                   const std::array<contact::RaceSurface, 2>& races,
                                                   const std::array<double, 2>& E_star,
                                                   const contact::RollerProfile& profile);

}  // namespace adore::statics
