#pragma once

namespace adore::dynamics {

/// Sums over all elements of one race at this evaluation.
struct RaceAccount {
  double power = 0.0;      ///< that the race exerts on elements and cage [W]
  double heat = 0.0;       ///< [W]
  double rolling = 0.0;    ///< rolling resistance of rollers, of the films of their traction [W]
  double load_slip = 0.0;  ///< ∫ p u dA [W]
  double load_slip_element1 = 0.0;
};

}  // namespace adore::dynamics
