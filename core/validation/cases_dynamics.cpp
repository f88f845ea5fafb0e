#include "validation/cases_dynamics.hpp"

#include "validation/scenarios.hpp"

namespace adore::validation {

std::vector<Adapter> dynamics_adapters() {
  return {{"F_dynamics", closed_form_case},
          {"dynamics_impact", impact_case},
          {"dynamics_plates", plates_case},
          {"dynamics_pocket", pocket_motion_case},
          {"dynamics_rigid_whirl", rigid_whirl_case},
          {"dynamics_ball_vibration", vibration_case},
          {"dynamics_ball_thrust", thrust_case},
          {"dynamics_ball_radial", radial_case},
          {"dynamics_roller", roller_case}};
}

}  // namespace adore::validation
