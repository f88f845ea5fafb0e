#pragma once

#include "validation/adapter.hpp"

/// Small scenarios of the dynamics reference families: each takes a case and returns what the
/// library computes for it.
namespace adore::validation {

std::optional<Json> evaluate_closed_form_case(const Json& the_case);    ///< F_dynamics
std::optional<Json> evaluate_impact_case(const Json& the_case);         ///< dynamics_impact
std::optional<Json> evaluate_plates_case(const Json& the_case);         ///< dynamics_plates
std::optional<Json> evaluate_pocket_motion_case(const Json& the_case);  ///< dynamics_pocket
std::optional<Json> evaluate_rigid_whirl_case(const Json& the_case);    ///< dynamics_rigid_whirl
std::optional<Json> evaluate_vibration_case(const Json& the_case);      ///< dynamics_ball_vibration
std::optional<Json> evaluate_thrust_case(const Json& the_case);         ///< dynamics_ball_thrust
std::optional<Json> evaluate_radial_case(const Json& the_case);         ///< dynamics_ball_radial
std::optional<Json> evaluate_roller_case(const Json& the_case);         ///< dynamics_roller

}  // namespace adore::validation
