#pragma once

#include "runs/deck_request.hpp"

#include <string>

/// A bearing in motion by what a run stores: friction torque by where it arises, speeds of cage and
/// elements, and lines in the spectrum of the forces on the inner race. What an equilibrium cannot
/// know is in it: the cage, and the slip of elements that find their own speed. All of it from the
/// second half of the run, when the start has passed. SI.
namespace adore::validation {

/// Heat of the energy ledger over the angle that the races turn against each other [N m]. What the
/// damping of contacts turns into heat counts where they are.
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

struct MotionRunResults {
  MotionFriction friction;
  double cage_ratio = 0.0;  ///< angle of the cage over that of the shaft; 0: no cage
  /// Amplitudes of the force on the inner race along x, and across it (root of the sum of squares
  /// of y and z), at the frequency Z times the cage's, by Fourier sums over whole periods [N].
  double axial_line = 0.0, radial_line = 0.0;
};

/// @param moving a deck of motion that stores several steps @param until as `adore run --until`
/// @throws InputError, SolverError when the run does not come to its end
[[nodiscard]] MotionRunResults evaluate_motion_run(const runs::DeckRequest& moving,
                                                   const std::string& until);

}  // namespace adore::validation
