#pragma once

#include "bearing/bearing.hpp"
#include "contact/wavy_groove.hpp"

namespace adore::contact {

/// Of one race of a ball bearing that has errors. K, a and b over the curvature factor: polynomials
/// after hertz_constants at `fixed_angle`, right to 1e-8 where f changes by a fifth of f - 1/2, and
/// to 3e-5 where by three fifths.
/// @param race 0 outer, 1 inner; fixed_angle contact angle of the curvature [rad]
/// @throws InputError when the waves per turn are not whole numbers, or the ball does not fit
[[nodiscard]] WavyGroove make_wavy_groove(const bearing::BallGeometry& balls, int race,
                                          const bearing::RaceErrors& errors, double fixed_angle);
/// The ratios of a ball that is `growth` larger than the nominal one [m], in that groove.
[[nodiscard]] HertzConstantRatios<double> ratios_with_ball_growth(
    const bearing::BallGeometry& balls, double growth, int race, const bearing::RaceErrors& errors,
    double fixed_angle);

}  // namespace adore::contact
