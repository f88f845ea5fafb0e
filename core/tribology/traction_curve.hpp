#pragma once

#include "bearing/bearing.hpp"

#include <array>

/// The hypothetical traction-slip curve κ(u) in its four prescriptions (records 10.1, 10.2, 10.5;
/// notes N44, N45). κ = traction / normal load [-], u = slip speed >= 0 [m/s]; the traction acts
/// along the slip.
///
///   type -1  A, B, C, D       κ = (A + B u) exp(-C u) + D
///   type  0  A, B, C, u0      κ = A + B u for u <= u0, A + B u0 + C (u - u0) above (continuous,
///   N44) type  1  κ0, κm, κ∞, u_m  exponential with κ(0) = κ0, maximum κm at u_m, κ(∞) = κ∞ (N45)
///   type  2  κ0, κ∞, slope    exponential with κ(0) = κ0, κ(∞) = κ∞, κ'(0) = slope, B = 0 (N45)
///
/// Type 1. κ(0) and κ(∞) give D = κ∞ and A = κ0 - κ∞. With x = C u_m, κ'(u_m) = 0 gives A + B u_m =
/// B/C, and κ(u_m) = κm gives (B/C) exp(-x) = κm - κ∞ = M. Eliminating B: (1 - x) exp(x) = A/M = r,
/// that is x = 1 + W0(-r/e) with the principal Lambert W. The left side falls from 1 at x = 0, so
/// exactly one x > 0 exists when r < 1: x < 1 for A > 0, x = 1 for A = 0, x > 1 for A < 0. Then C =
/// x/u_m, B = C M exp(x). Needs u_m > 0 and κm > max(κ0, κ∞). (The branch W-1 has C < 0: no law.)
/// Type 2. κ'(0) = -C A, hence C = slope/(κ∞ - κ0) > 0. κ0 = κ∞ is accepted with slope 0: a
/// constant.
namespace adore::tribology {

/// kTracType and the four record fields -> curve.
/// @throws InputError saying which condition cannot be met: non-finite numbers, C < 0, κ < 0
/// somewhere (for two slopes: below kLargestSlip), κm not above κ0 and κ∞, a slope of the wrong
/// sign ...
[[nodiscard]] bearing::TractionCurve traction_curve(int type, const std::array<double, 4>& tc);

/// κ(|u|) for u >= 0, not rounded.
[[nodiscard]] double traction_coefficient(const bearing::TractionCurve& curve,
                                          double slip) noexcept;

/// dκ/du [s/m] for u >= 0; at the kink of the two-slope law the slope below it.
[[nodiscard]] double traction_slope(const bearing::TractionCurve& curve, double slip) noexcept;

/// Slip beyond which no rolling bearing goes [m/s]; a two-slope law may turn negative only above
/// it.
inline constexpr double kLargestSlip = 100.0;

/// Largest κ over 0 <= u <= kLargestSlip: the most that friction can carry, over the load.
[[nodiscard]] double max_traction_coefficient(const bearing::TractionCurve& curve) noexcept;

}  // namespace adore::tribology
