#pragma once

#include "dynamics/system.hpp"

#include <cstddef>
#include <vector>

/// Rest position of a bearing whose races do not move.
///
/// Without velocities the right-hand side contains normal contact forces and weights only. They
/// have a potential V (elastic energy and energy in gravity), and rest is a minimum of it: the
/// cage is supported by its guide or by elements, and elements without load by race and pocket.
/// Linearly implicit steps of the overdamped motion q' = a(q) lead there:
///   (1/τ - ∂a/∂w) Δw = a,   V(q + Δw) < V(q),
/// with the displacements w of all bodies (lengths and rotation vectors) and a pseudo time τ that
/// grows from step to step.
///
/// Friction holds what is left. A displaced inner race squeezes loaded elements toward the wider
/// gap: the two normal forces include an angle of 1e-4 to 1e-2, and the friction of the contacts
/// balances their resultant. Smoothed friction and traction laws with κ(0) = 0 do so at a slow
/// creep only (1e-7 to 1e-1 m/s). A contact at rest has no film and sticks: creep is not a motion.
/// A state is a rest position if
///   - no body can move without slip: with contact friction multiplied by 1e9, no body moves by
///     1e-6 of the length scale in 1 s (rolling, swinging and falling bodies need no slip), and
///   - the laws of the contacts reach the force that they hold: the creep is at most 0.1 m/s, and
///     at twice the creep no body gains more than 1e-8 W/kg.
/// Limit: the gain is small for displacements against a stiff contact, too. A cage at the turning
/// point of a swing of less than about 1 µm may count as held.
/// During the search, elements between two loaded contacts keep their azimuth, spin and skew as
/// long as the friction of their contacts at slips of up to 0.1 m/s exceeds their resultant.
namespace adore::dynamics {

struct RestSearchOptions {
  int most = 0;                ///< steps; 0: only checks whether the state is a rest position
  bool friction_holds = true;  ///< false: films or drag resist slow motions; forces must balance
};

struct RestEquilibrium {
  bool found = false;
  std::size_t sticking = 0;  ///< elements held by friction
  int steps = 0;
};

/// Moves y, a state without velocities, to its rest position. y is unchanged if none was found.
[[nodiscard]] RestEquilibrium find_rest(System& system, std::vector<double>& y,
                                        const RestSearchOptions& options);

}  // namespace adore::dynamics
