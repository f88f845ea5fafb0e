#pragma once

namespace adore::scene {

/// Error of the fixed ellipse rule of a run for the traction of balls in one state, against a
/// rule of twice as many nodes along both axes (where the rule converges, its error is that or a
/// little more). All 0 without traction and for rollers, whose slices have no rule.
struct QuadratureError {
  /// Largest difference of a contact's traction force, relative to its κ-weighted load κ̄ Q, κ̄ =
  /// ∫ κ p u dA / ∫ p u dA.
  double force = 0.0;
  double heat_of_rule = 0.0, heat_of_finer = 0.0;  ///< of all loaded contacts together [W]
};

}  // namespace adore::scene
