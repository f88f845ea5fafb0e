#pragma once

#include "tribology/ellipse_traction.hpp"

namespace adore::scene {

/// How finely contacts are integrated over their area.
struct SystemOptions {
  int ellipse_major = 15, ellipse_minor = 2;  ///< nodes of the run's split ellipse rule
  tribology::ContactSurface surface = tribology::ContactSurface::CurvedEdge;
  int land_slices = 3;
  /// Hertz constants of balls follow their contact angle (contact/angle_law.hpp); otherwise they
  /// are frozen at the mean angle of the static solution.
  bool moving_angle = true;
};

}  // namespace adore::scene
