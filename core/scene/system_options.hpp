#pragma once

#include "tribology/ellipse_traction.hpp"

#include <memory>

namespace adore::scene {

struct UserLaws;  // user_laws.hpp

/// Energy loss of normal contacts where the plan has that effect (contact/damping_law.hpp).
struct ContactDampingOptions {
  double impact_loss = 0.0;  ///< α of all pairs [s/m]; 0: that of the pair of materials
  bool impact_only = false;  ///< without the losses of materials and oil films, for closed forms
  double factor = 1.0;       ///< on all of them: uncertainty of the model
};

/// How finely contacts are integrated over their area.
struct SystemOptions {
  int ellipse_major = 15, ellipse_minor = 2;  ///< nodes of the run's split ellipse rule
  tribology::ContactSurface surface = tribology::ContactSurface::CurvedEdge;
  int land_slices = 3;
  /// Hertz constants of balls follow their contact angle (contact/angle_law.hpp); otherwise they
  /// are frozen at the mean angle of the static solution.
  bool moving_angle = true;
  bool single_films = false;  ///< films by floats (runs/film_precision.hpp)
  ContactDampingOptions damping;
  /// Laws of the user in the place of built-in ones; null: none.
  std::shared_ptr<UserLaws> user;
};

}  // namespace adore::scene
