#pragma once

namespace adore::scene {

/// Scales of the dimensionless time, length and force (N7, N11).
struct Scales {
  double length = 0.0;  ///< rolling-element radius [m]
  double force = 0.0;   ///< largest applied load [N]
  double time = 0.0;  ///< sqrt(m/k) of the stiffest element/race contact at the static solution [s]
};

}  // namespace adore::scene
