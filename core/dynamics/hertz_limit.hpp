#pragma once

#include "dynamics/race_contacts.hpp"

namespace adore::dynamics {

/// Is Hertz's theory valid for one contact in its present state: the ball penetrates the race by
/// less than its radius, and half the major axis [m] is shorter. load_limit() is the smallest load
/// at which that may fail, for any contact angle and position on a wavy race; above it this
/// function decides.
[[nodiscard]] bool is_hertz_valid(const RaceContactModel& model,
                                  const RaceContactState& state) noexcept;

}  // namespace adore::dynamics
