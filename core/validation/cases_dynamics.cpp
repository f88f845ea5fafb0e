#include "validation/cases_dynamics.hpp"

#include "validation/scenarios.hpp"

namespace adore::validation {

std::vector<Adapter> dynamics_adapters() {
  return {{"F_dynamics", evaluate_closed_form_case},
          {"dynamics_impact", evaluate_impact_case},
          {"dynamics_plates", evaluate_plates_case},
          {"dynamics_pocket", evaluate_pocket_motion_case},
          {"dynamics_rigid_whirl", evaluate_rigid_whirl_case},
          {"dynamics_ball_vibration", evaluate_vibration_case},
          {"dynamics_ball_thrust", evaluate_thrust_case},
          {"dynamics_ball_radial", evaluate_radial_case},
          {"dynamics_roller", evaluate_roller_case}};
}

}  // namespace adore::validation
