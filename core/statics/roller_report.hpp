#pragma once

#include "base/finding.hpp"
#include "statics/roller_equilibrium.hpp"

#include <string>
#include <vector>

/// From the solved roller bearing to what the outputs read.
namespace adore::statics {

/// Everything about one roller at its equilibrium.
[[nodiscard]] StaticRoller report_roller(const RollerModel& model, const Vec5& q,
                                         const RollerState& roller);

/// Largest load, stiffness and deflection of the rollers.
void fill_summary(RollerSolution& solution);

/// Notes about the whole solution: rollers without load, contacts that reach the ends or the lands'
/// edges, flange contacts on lips and corners, contacts too short for the slices.
[[nodiscard]] std::vector<Finding> roller_notes(const RollerModel& model,
                                                const std::vector<StaticRoller>& rollers);

/// Where rollers stand that no load puts in place (decision 124), in a sentence.
[[nodiscard]] std::string unloaded_position_rule(const RollerModel& model);

}  // namespace adore::statics
