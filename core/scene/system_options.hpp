#pragma once

#include "tribology/ellipse_traction.hpp"

#include <memory>

namespace adore::scene {

struct UserLaws;  // user_laws.hpp

/// How finely contacts are integrated over their area.
struct SystemOptions {
  int ellipse_major = 15, ellipse_minor = 2;  ///< nodes of the run's split ellipse rule
  tribology::ContactSurface surface = tribology::ContactSurface::CurvedEdge;
  int land_slices = 3;
  /// Hertz constants of balls follow their contact angle (contact/angle_law.hpp); otherwise they
  /// are frozen at the mean angle of the static solution.
  bool moving_angle = true;
  bool single_films = false;     ///< films by floats (facade/film_precision.hpp)
  double contact_damping = 0.0;  ///< choices of dynamics/effects/contact_damping.cpp
  /// Laws of the user in the place of built-in ones; null: none.
  std::shared_ptr<UserLaws> user;
};

}  // namespace adore::scene
