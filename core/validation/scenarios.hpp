#pragma once

#include "validation/adapter.hpp"

/// Small scenarios of the dynamics reference families: each takes a case and returns what the
/// library computes for it.
namespace adore::validation {

std::optional<Json> closed_form_case(const Json& the_case);    ///< F_dynamics
std::optional<Json> impact_case(const Json& the_case);         ///< dynamics_impact
std::optional<Json> plates_case(const Json& the_case);         ///< dynamics_plates
std::optional<Json> pocket_motion_case(const Json& the_case);  ///< dynamics_pocket
std::optional<Json> rigid_whirl_case(const Json& the_case);    ///< dynamics_rigid_whirl
std::optional<Json> vibration_case(const Json& the_case);      ///< dynamics_ball_vibration
std::optional<Json> thrust_case(const Json& the_case);         ///< dynamics_ball_thrust
std::optional<Json> radial_case(const Json& the_case);         ///< dynamics_ball_radial
std::optional<Json> roller_case(const Json& the_case);         ///< dynamics_roller

}  // namespace adore::validation
