#pragma once

#include "statics/contact_laws.hpp"
#include "statics/friction_balance.hpp"

/// Balls of an equilibrium in balance of friction. SI.
///
/// Spin rules (kAngVel) fix the spin axis and let friction carry the gyroscopic moment, however
/// little friction there is. Here each ball has its four speeds, ω = (ω_x, ω_r, ω_θ) and its orbit
/// ω_m, from balance under the laws of motion, steady in the frame of its azimuth:
///   Σ M_x = 0,  Σ M_r = -J (ω_m + Ω_f) ω_θ,  Σ M_θ = J (ω_m + Ω_f) ω_r,  Σ F_θ = 0.
/// M and F: traction over both ellipses (tribology/ellipse_traction.hpp) at the slip of
///   u = (Ω_j - ω_m) r e_θ + (Ω_j e_x - ω) × p,
/// rolling resistance of the oil at the entrainment of that motion
/// (dynamics/effects/rolling_resistance.cpp) and drag of the medium (kChrn). Ω_f: speed of the base
/// frame of record 9.5. Newton steps on the flow dω/dτ = M/J whose pseudo time grows as the
/// residual falls. The tractions along the major axes replace the shares of the spin rule in the
/// equilibrium, ω_m the kinematic one in the centrifugal force. Both follow the contacts: with s =
/// (Q_o, Q_i, α_o, α_i, r) and v the four speeds, G(v, s) = 0 stays balanced while the ball moves
/// [derived]:
///   t(s) = t(s0) + (t_s - t_v G_v⁻¹ G_s)(s - s0),   t = (f_o, f_i, ω_m).
/// The equilibrium is solved with t(s), its slopes are in its stiffness, and s0 moves to the new
/// contacts until the tractions stay: Newton's method on places and speeds together. Where no
/// equilibrium is found so, without slopes.
///
/// Places, loads, speeds, spin axes and spin to roll ratios of the solution are those of the
/// balance, StaticBall::friction is |F_c|/Q, and starts of motion begin with them;
/// dynamics/friction_start.hpp then does the same with all effects of the run. A ball without a
/// balance, without load at a race, or of a given spin axis (kAngVel = 2) keeps the spin rule;
/// FrictionBalance reports the first.
///
/// Alone, light balls of an angular contact bearing orbit up to twice as fast as loaded ones. With
/// a cage, speeds ω_c + λ (ω_k - mean) replace Σ F_θ = 0 where the angles of the balls would vary
/// by more than their pockets let them: λ = clearance/variation, ω_k the orbits alone, and ω_c from
/// Σ F_θ r = 0 over all balls [derived: rigid cage without friction; a ball that crosses its pocket
/// and stays at its wall has λ of its variation].
///
/// Spin axes that turn along the orbit take the moment J ω_m dω/dθ. Where it is above 1 % of the
/// friction moment of a ball, all balls are balanced together with it (spin_lag.hpp).
///
/// Each equilibrium that is not found leaves the one before, and FrictionBalance::findings() names
/// it: without the turning moment, without the cage, by the spin rule.
/// Limits: land, pocket friction and weight of the cage, gravity and the tractions along e_θ on the
/// inner race are left out; races are not tilted here.
namespace adore::statics {

/// @param r radius of the ball's orbit
[[nodiscard]] tribology::EllipseKinematics contact_kinematics(const bearing::Bearing& bearing,
                                                              const BallContact& contact,
                                                              const BallMotion& motion, double r,
                                                              std::size_t race);

/// False: balls keep the spin rule (option, kAngVel = 2, races at rest, or nothing that resists).
[[nodiscard]] bool has_friction_balance(const bearing::Bearing& bearing,
                                        const BallStaticsOptions& options);

/// Changes places, loads, speeds and notes of the solution; nothing without a balance.
/// @param options those of the solution
[[nodiscard]] FrictionBalance solve_ball_friction_balance(const bearing::Bearing& bearing,
                                                          const BallStaticsOptions& options,
                                                          StaticSolution& solution);

}  // namespace adore::statics
