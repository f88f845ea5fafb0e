#pragma once

#include "dynamics/race_contacts.hpp"

namespace adore::dynamics {

/// Whether Hertz's theory holds for one contact as it is: the ball lies in the race by less than
/// its radius, and half the major axis [m] is shorter. load_limit() is the least load at which that
/// may fail, whatever the contact angle and the place on a wavy race; above it this tells.
[[nodiscard]] bool within_hertz(const RaceContactModel& model,
                                const RaceContactState& state) noexcept;

}  // namespace adore::dynamics
