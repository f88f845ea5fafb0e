#pragma once

#include "bearing/bearing.hpp"
#include "contact/angle_law.hpp"

namespace adore::contact {

/// The law of the balls on one race (angle_law.hpp): Chebyshev series over -1 <= cos α <= 1 of what
/// hertz_constants says at each angle, cut after HertzAngleLaw::kTerms.
/// @param E_star 1/E* = (1-ν1²)/E1 + (1-ν2²)/E2 [Pa]
/// @throws InputError where the curvatures make no contact.
[[nodiscard]] HertzAngleLaw make_angle_law(const bearing::BallGeometry& balls, int race,
                                           double E_star);

}  // namespace adore::contact
