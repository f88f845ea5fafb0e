#pragma once

#include "integrators/stepper.hpp"
#include "runs/prepare.hpp"

/// Steps of a bearing that is at rest and stays there. SI.
///
/// Without speed, excitation, thermal steps, user routines and races under loads (free, or in
/// balance in mode 2) the right-hand side does not depend on time. Where its present rates would
/// change no component by more than a tenth of the tolerance over a time T, the state is constant
/// to that accuracy, and a step of T needs no integration. Contact vibrations and stpMax do not
/// limit it: explicit methods would need two hundred thousand steps per second at rest.
namespace adore::runs {

class RestDetector {
 public:
  explicit RestDetector(const Prepared& prepared);

  /// Length of a step without integration from the present state; 0: the bearing moves, or such a
  /// step is not longer than `usual`.
  /// @param most of such steps [s]
  [[nodiscard]] double step(const integrators::Stepper& stepper, const integrators::OdeSystem& ode,
                            double tolerance, double usual, double most) const;

 private:
  bool is_time_independent_ = false;
};

}  // namespace adore::runs
