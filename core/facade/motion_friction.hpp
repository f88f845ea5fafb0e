#pragma once

#include "facade/deck_request.hpp"

#include <string>

/// Friction torque of a bearing in motion by where it arises, from the energy ledger of a run:
/// heat over the angle that the races turn against each other. What an equilibrium cannot know is
/// in it: the cage, and the slip of elements that find their own speed.
namespace adore::facade {

/// Torques of the second half of the run, when the start has passed [N m]. What the damping of
/// contacts turns into heat counts where they are.
struct MotionFriction {
  double rolling = 0.0;  ///< oil in the inlets of the races' contacts
  double races = 0.0;    ///< sliding, spin and damping there
  double ribs = 0.0;
  double cage = 0.0;  ///< pockets and guide lands, dry and through films; no drag
  double drag = 0.0;  ///< of the medium on elements and cage
  double other = 0.0;
  double energy_residual = 0.0;  ///< of the whole run, over the energy that moved
  [[nodiscard]] double total() const noexcept {
    return rolling + races + ribs + cage + drag + other;
  }
};

/// @param moving a deck of motion that stores several steps @param until as `adore run --until`
/// @throws InputError, SolverError when the run does not come to its end
[[nodiscard]] MotionFriction motion_friction(const DeckRequest& moving, const std::string& until);

}  // namespace adore::facade
