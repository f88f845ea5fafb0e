#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"
#include "contact/roller_pocket.hpp"
#include "contact/roller_profile.hpp"

#include <span>
#include <vector>

/// Play of a roller between the guide faces of a cage pocket (kPocType above 0), at rest in the
/// middle of its pocket.
namespace adore::contact {

using bearing::RollerPocketFace;

/// Least diametral play, twice the gap of the plane of a face over the part of the roller that it
/// covers: min over x of m·(c - x u) - ρ(x) √(1 - m_x²), u the pocket's x. Linear between a cone's
/// ends, so both ends and the middle are looked at; crowns only widen it. Negative: clamped.
/// @throws InputError when no face covers any part of the roller.
[[nodiscard]] double roller_pocket_play(std::span<const RollerPocketFace> faces,
                                        const RollerProfile& roller);

/// Least diametral play of a roller in the middle of a round pocket whose axis leans against its
/// own by `lean` in the plane of x and z [rad]. Negative: it does not fit.
[[nodiscard]] double round_pocket_clearance(const RoundPocket& pocket, const RollerProfile& roller,
                                            double lean);

/// The faces of a pocket whose clearance is larger by `clearance` (diametral, record 7.4): each is
/// moved by half of that along its normal, away from the roller.
[[nodiscard]] std::vector<RollerPocketFace> widened(std::span<const RollerPocketFace> faces,
                                                    double clearance);

}  // namespace adore::contact
