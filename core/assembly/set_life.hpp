#pragma once

#include <optional>
#include <span>

/// Life of a set from the lives of its rows.
namespace adore::assembly {

/// Slope e of the Weibull distribution in ISO 281: 10/9 of balls, 9/8 of rollers (G. Lundberg,
/// A. Palmgren, Dynamic capacity of rolling bearings, Acta Polytechnica, Mech. Eng. Ser. 1, No. 3
/// (1947) and 2, No. 4 (1952)).
inline constexpr double kBallSlope = 10.0 / 9.0, kRollerSlope = 9.0 / 8.0;

/// The set survives while all rows survive, independently of each other: S = Π S_k with
/// ln(1/S_k) ~ (L/L_k)^e gives (ibid.)
///   L = (Σ L_k^(-e))^(-1/e)
/// at the same survival probability for rows and set. Lives may be infinite; all of one unit.
/// Empty: no rows, or a life that is not a number above 0.
[[nodiscard]] std::optional<double> life_of_set(std::span<const double> rows, double slope);

}  // namespace adore::assembly
