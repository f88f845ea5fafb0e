#pragma once

#include "dynamics/system.hpp"

#include <array>
#include <cstddef>
#include <vector>

/// Balance of friction at the start of rollers that lean on a rib.
///
/// With rollerFriction=balance the start (roller_start.hpp) is the friction equilibrium of statics
/// (statics/roller_friction.hpp). Statics have neither gravity nor a cage, and no friction
/// equilibrium of rollers that touch one race only. Here each roller finds
///   u = (x, r, tilt φ, skew ψ, spin ω_s)   with   ẍ = r̈ = 0,  ω̇ = 0 on the azimuth axes,
/// at its azimuth and orbital speed: it stands in the turning frame, its axis
///   a = (cos φ cos ψ, sin φ cos ψ, -sin ψ) on e_x, e_r, e_θ,   ω = θ̇ e_x + ω_s a.
/// The rates are those of the whole right-hand side (friction, drag, gravity, gyroscopic moments);
/// races and cage stand at their start, so that rollers do not meet and one set of differences
/// serves all. Steps: statics/friction_flow.hpp. A roller keeps its old start where that ends
/// nowhere, in more than kLargestSkew, or where skew would run away from the balance: ∂ω̇_skew/∂ψ >
/// 0 with the other four following. What a rib drags around the bearing (θ̈) stays for the motion.
///
/// Balls without attitude find u = (x, r, ω) with ẍ = r̈ = 0 and ω̇ = 0 by the same steps: the slip
/// whose friction carries the gyroscopic moment, which the start of pure rolling does not have. It
/// moves the axial balance by M_g/D in each ball.
///
/// balance_race() does the same for an inner race that moves under its load (mode 2, free race):
/// Newton steps on its place with the stiffness of the statics, the elements in balance at each.
namespace adore::dynamics {

struct FrictionBalanceResult {
  std::size_t balanced = 0, rollers = 0;
  double largest_skew = 0.0;  ///< of the balanced ones [rad]
};

/// Changes places, attitudes and spins of y. Its system must be at the start of a run
/// (System::set_start is called after it).
FrictionBalanceResult balance_friction(System& system, std::vector<double>& y);

/// @param stiffness d load/d displacement of the inner race, from its statics
/// @param free directions in which the race moves under its load
/// @returns the residual force after the last step over the force scale; 0 without such directions
double balance_race(System& system, std::vector<double>& y, const Mat3& stiffness,
                    const std::array<bool, 3>& free);

}  // namespace adore::dynamics
