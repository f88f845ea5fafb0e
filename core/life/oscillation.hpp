#pragma once

/// Fatigue life of an oscillating bearing, from its life in rotation.
///
/// The swing theta is the angle between both end positions (twice the amplitude); one oscillation
/// is there and back, 2 theta. Above the critical swing each point of a race is passed by more than
/// one element, and the oscillation counts as 2 theta/360 deg revolutions:
///   N = L 180 deg/theta [oscillations].
/// Critical swing of a race: an element rolls one pitch along it,
///   theta_crit = 720 deg/(Z (1 -+ gamma)), minus: outer race (inner race rotates), plus: inner.
/// Below it, only Z separate arcs are stressed, each point twice per oscillation by one element.
/// With Lundberg-Palmgren (ln 1/S ~ N^e V) their volume share gives
///   N = L Z (1 -+ gamma)/4 (theta_crit/theta)^(1/e),
/// e = 10/9 (balls), 9/8 (rollers). Both agree at theta_crit. NREL/TP-500-42362 (Harris, Rumbarger,
/// Butterfield 2009) has the same exponents of theta and Z in its oscillation capacities; it omits
/// the factor ((1 -+ gamma)/4)^(1-1/e). Here the race with the shorter life decides.
/// Not included: a stationary load on a race that turns less than a load zone (Houpert 1999), and
/// false brinelling, which threatens below half the critical swing.
namespace adore::life {

struct OscillationInput {
  bool ball = true;
  int count = 0;       ///< Z
  double gamma = 0.0;  ///< D cos(angle)/dm
  double swing = 0.0;  ///< theta [rad]
};

struct Oscillation {
  double critical_outer = 0.0, critical_inner = 0.0;  ///< theta_crit [rad]
  double cycles_per_revolution = 0.0;  ///< oscillations that damage as one revolution
  bool below_critical = false;         ///< of a race
  bool false_brinelling = false;       ///< swing below half the smaller critical swing
};

/// @throws InputError for values outside their range
[[nodiscard]] Oscillation oscillation(const OscillationInput& input);

}  // namespace adore::life
