#pragma once

#include "integrators/stepper.hpp"
#include "runs/prepare.hpp"

#include <vector>

/// Steps of a bearing that is at rest and stays there. SI.
///
/// Without speed, excitation, thermal steps, user routines and races under loads (free, or in
/// balance in mode 2) the right-hand side does not depend on time. Such a bearing is at rest
///   - at a rest position without velocities (dynamics/rest_equilibrium.hpp): forces are balanced
///     or held by sticking contacts;
///   - or where its present rates change no component by more than a tenth of the tolerance over
///     the whole remaining run.
/// Its state is then constant, and steps need no integration. Contact vibrations and stpMax do not
/// limit them: explicit methods would need two hundred thousand steps per second at rest.
namespace adore::runs {

/// Whether the right-hand side does not depend on time.
[[nodiscard]] bool is_time_independent(const Prepared& prepared);

/// Whether a run may start at its rest position: nothing moves, the contacts with the races have
/// traction, and the run option startAtRest is on.
[[nodiscard]] bool may_start_at_rest(const Prepared& prepared);

/// Moves the static solution y to the rest position. @returns false: none was found, y is unchanged
bool start_at_rest(const Prepared& prepared, dynamics::System& system, std::vector<double>& y);

class RestDetector {
 public:
  explicit RestDetector(const Prepared& prepared);

  /// Checks whether the start of a run is a rest position.
  void examine(dynamics::System& system, std::span<const double> y);

  /// Length of a step without integration from the present state; 0: the bearing moves.
  /// @param usual step with integration [s]
  /// @param most of steps without integration [s]
  /// @param end of the run [s]
  [[nodiscard]] double step(const integrators::Stepper& stepper, const integrators::OdeSystem& ode,
                            double tolerance, double usual, double most, double end) const;

 private:
  [[nodiscard]] bool is_rest_position(std::span<const double> y,
                                      std::span<const double> scales) const;

  bool is_time_independent_ = false, friction_holds_ = false;
  std::vector<double> rest_position_;   ///< controlled states; empty: none is known
  std::vector<double> position_scale_;  ///< of each velocity; 0: another component [m or rad]
};

}  // namespace adore::runs
