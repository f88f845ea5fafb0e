#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "listing/report.hpp"
#include "statics/ball_statics.hpp"

#include <optional>
#include <string>
#include <vector>

/// Warnings where a quasi-static solution of balls violates its own assumptions; values in deck
/// units.
namespace adore::listing {

/// Largest friction coefficient of lubricated contacts, where the deck has no traction law: 0.05 to
/// 0.08 at most [recalled].
inline constexpr double kLubricatedFriction = 0.06;

/// Not of balls in balance of friction: the spin rule has no ω_θ, they creep
/// (statics/ball_friction.hpp).
[[nodiscard]] inline bool follows_spin_rule(const statics::StaticBall& ball) {
  return ball.omega_theta == 0.0;
}

/// - The spin rule lets the races hold each ball against its gyroscopic moment by friction
///   (ball_forces.hpp): StaticBall::friction above `available`, or above kLubricatedFriction where
///   that is not known. Not of balls in balance of friction, which take the spin axis that friction
///   can hold.
/// - Contacts over the shoulder keep their whole Hertz ellipse: StaticBall::beyond.
/// - Hertz's theory takes bodies for half-spaces: half major axis above half the ball radius.
/// @param available largest coefficient of the deck's traction law; empty: it has none
/// @return statics.gyroscopic, statics.shoulder, statics.ellipse with the body
[[nodiscard]] std::vector<Finding> ball_warnings(const bearing::Bearing& bearing,
                                                 const statics::StaticSolution& solution,
                                                 std::optional<double> available, UnitSystem units);

}  // namespace adore::listing
