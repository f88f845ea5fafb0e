#pragma once

#include "bearing/bearing.hpp"
#include "statics/friction_balance.hpp"
#include "tribology/bearing_drag.hpp"

#include <array>
#include <string>
#include <vector>

/// Friction of a quasi-static solution: what its speeds and loads dissipate, an estimate without
/// that of the cage. SI.
///
/// Element and race: balls and rollers in balance of friction have the slip and heat of that
/// balance (ball_friction.hpp, roller_friction.hpp; rollers at flanges, too), others the speeds of
/// the solution (balls: no slip at the contact centres, spin by kAngVel; rollers: pure rolling).
/// Over each contact the slip of the spin and of the curved surface (Heathcote),
///   u_t = u + W_n ξ - W_c h(ξ),   u_c = W_t h(ξ) - W_n η,
/// acts with the deck's traction law; u is the creep for which the contact carries no force along
/// the rolling direction, ∫ τ_t dA = 0, as a freely rolling element does. Heat = ∫ τ u dA. Its part
/// `spin` is that of W_n alone (curvature left out), the rest `sliding`.
/// Oil in the inlet resists rolling and takes 2 F u (tribology/laws/rolling_resistance.hpp: the law
/// of motion, too).
/// Films have the law and the limiting stress of motion (tribology/film_law.hpp).
/// Flanges: Q κ(u) u [W] at the slip u = |W r_X - σ ω ρ| [m/s], κ of record 10.2: W the race's
/// speed against the row [rad/s], r_X = r + s sin θ + σ ρ cos θ the contact from the bearing axis,
/// r and θ middle and tilt of the roller, s = ±L/2 its end, ρ the contact from the roller's axis
/// [m], ω its spin, σ = 1 at the outer race and -1 at the inner one [derived]. Limits: no skew; the
/// depth of a domed end is left out (half a per cent of u). Lands and pockets: without the motion
/// of the cage their loads are not known, and nothing is booked; the drag of the medium (kChrn) on
/// elements and cage is, at the epicyclic speeds. Elastic hysteresis is left out. Decision 301.
namespace adore::statics {

struct StaticSolution;
struct RollerSolution;

struct FrictionOfContact {
  double spin = 0.0, sliding = 0.0, rolling = 0.0;  ///< [W]
  double load_slip = 0.0;                           ///< ∫ p u dA of spin and sliding [W]
  bool of_oil = false;  ///< the friction coefficient is that of an oil film, without metal contact
  [[nodiscard]] double total() const noexcept { return spin + sliding + rolling; }
};

struct FrictionEstimate {
  std::array<std::vector<FrictionOfContact>, 2> race;  ///< by race and element
  std::array<double, 2> flange{};                      ///< by race [W]
  double element_drag = 0.0, cage_drag = 0.0;          ///< [W]
  std::string medium, medium_provenance;               ///< of the drag; empty: none
  std::string law;                                     ///< of the traction, in words
  std::vector<std::string> notes;
  double speed = 0.0;   ///< |Ω_i - Ω_o| [rad/s]
  bool oil = false;     ///< films in the contacts, which resist rolling, too
  bool resists = true;  ///< a curve that is not 0 or a medium; films resist by themselves

  [[nodiscard]] FrictionOfContact of_race(int race) const noexcept;
  [[nodiscard]] double drag() const noexcept { return element_drag + cage_drag; }
  [[nodiscard]] double power() const noexcept;
  /// Why there are no figures: the races do not turn against each other, or nothing in the deck
  /// resists. Empty: there are.
  [[nodiscard]] std::string why_none() const;
  /// Power over the relative speed of the races; 0 at rest [N m].
  [[nodiscard]] double torque() const noexcept { return speed > 0.0 ? power() / speed : 0.0; }
};

/// @param balance of the balls (ball_friction.hpp); balls without one roll freely, as above
[[nodiscard]] FrictionEstimate friction_estimate(const bearing::Bearing& bearing,
                                                 const StaticSolution& solution,
                                                 const FrictionBalance& balance = {});
/// Rolling resistance of all balls by the law of points over that of strips with the law of lines,
/// which knows the pressure coefficient of the oil (laws/rolling_resistance.hpp); 0: neither rolls
/// in oil.
[[nodiscard]] double rolling_point_strip_ratio(const bearing::Bearing& bearing,
                                               const StaticSolution& solution);
/// What the law of points has over a numerical solution of the contact, of that ratio: at most
/// ratio^0.35 in six contacts up to a ratio of 2.5 (exponents 0.1 to 0.30, and 0.32 with what a
/// finer grid changes; theory/tribology.md 2a); beyond, it is extrapolated.
[[nodiscard]] double rolling_resistance_excess(double over_strips);
/// Outputs doubt the law of points beyond the range "rolling.strips" (base/validity.hpp): it is 1.1
/// to 1.3 where it agrees with measured torques.
[[nodiscard]] FrictionEstimate friction_estimate(const bearing::Bearing& bearing,
                                                 const RollerSolution& solution);

}  // namespace adore::statics
