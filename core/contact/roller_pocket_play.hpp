#pragma once

#include "base/rotation.hpp"
#include "contact/roller_profile.hpp"

#include <span>

/// Play of a roller between the guide faces of a cage pocket (kPocType above 0), at rest in the
/// middle of its pocket.
namespace adore::contact {

/// One face of record 7.3; its mate is the mirror image in the pocket's x-z plane (N36). Pocket
/// frame: x along the roller, z outward, y = z × x.
struct RollerPocketFace {
  Vec3 angles = Vec3::Zero();  ///< η, ξ, λ from pocket to face frame; y of that frame is the normal
                               ///< away from the roller [rad]
  Vec3 centre = Vec3::Zero();  ///< of the face [m]
  double width = 0.0;          ///< along its z [m]
  double length = 0.0;         ///< along its x [m]
};

/// Least diametral play, twice the gap of the plane of a face over the part of the roller that it
/// covers: min over x of m·(c - x u) - ρ(x) √(1 - m_x²), u the pocket's x. Linear between a cone's
/// ends, so both ends and the middle are looked at; crowns only widen it. Negative: clamped.
/// @throws InputError when no face covers any part of the roller.
[[nodiscard]] double roller_pocket_play(std::span<const RollerPocketFace> faces,
                                        const RollerProfile& roller);

}  // namespace adore::contact
