#pragma once

#include "bearing/rollers.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_flange.hpp"
#include "contact/roller_profile.hpp"
#include "statics/roller_races.hpp"
#include "statics/slice_potential.hpp"

#include <array>
#include <cmath>
#include <vector>

/// Forces of race flanges on roller ends (contact/roller_flange.hpp) in the relative coordinates of
/// slice_potential.hpp.
///
/// Q = K δ^1.5 with K of the ideal roller's first contact, so that the force has a potential
/// [choice]; the gradient of the gap is exact (it is a minimum over the roller end: only the
/// contact point and the normal enter), its curvature comes from central differences of that
/// gradient.
namespace adore::statics {

/// One flange and the roller end that faces it.
struct FlangeEndPair {
  int race = 0, side = 0;  ///< side 0: -x
  contact::FlangeFace face;
  contact::RollerEnd end;
  double K = 0.0;  ///< of the contact of the ideal roller where it first touches [N/m^1.5]
  // A gap falls by no more than the roller's points move: what is surely open is not computed.
  Vec4 open_pose = Vec4::Zero();  ///< p at which the gap is `open_gap`
  double open_gap = 0.0;          ///< [m]
  double reach = 0.0;             ///< of the roller's points from its middle [m]

  [[nodiscard]] bool is_certainly_open(const Vec4& p) const noexcept {
    const Vec4 d = p - open_pose;
    return open_gap >
           std::abs(d(0)) + std::abs(d(1)) + 1.1 * reach * (std::abs(d(2)) + std::abs(d(3)));
  }
};

/// The flanges of both races with their faces placed (rollers.md 5): two on one race leave the
/// deck's play for the ideal roller; the rib of a tapered bearing touches the ideal roller; a
/// single flange on a cylindrical race leaves half the other race's play.
/// They are placed on the bench, for the nominal roller there, and grow with their race.
/// @param profile the roller whose end they meet
/// @throws InputError naming the flange that cannot be.
[[nodiscard]] std::vector<FlangeEndPair> flange_end_pairs(bearing::Type type,
                                                          const bearing::RollerGeometry& rollers,
                                                          const std::array<double, 2>& E_star,
                                                          const contact::RollerProfile& profile);

/// The contact at p, and the load on it.
struct FlangeContactLoad {
  contact::FlangeContact contact;
  double load = 0.0;  ///< [N]
};
[[nodiscard]] FlangeContactLoad flange_contact_load(const FlangeEndPair& pair, const Vec4& p);

/// Adds the flange's force at p; nothing when it is open. `with_curvature`: the derivative of the
/// gap's gradient too, which costs several contact searches and matters little while iterating.
void add_flange_force(const FlangeEndPair& pair, const Vec4& p, bool with_curvature,
                      PairPotential& sum);

}  // namespace adore::statics
