#pragma once

#include "dynamics/system.hpp"
#include "scene/scales.hpp"

#include <string>

/// Tolerance of the integration while films of race contacts are about to break down.
///
/// The tolerance bounds the error of velocities by tol × (element radius / √(m/k)), which is about
/// 1e-3 m/s at tol = 1e-6. In cold thick oil the rolling speed of an element that the oil brakes
/// can pass zero while the contact slides at several m/s. Its film then is thin in a band of u_c ~
/// 2e-4 m/s only, in which friction is 30 times larger. An element can be held in that band for
/// milliseconds. Steps that resolve 1e-3 m/s pass the band without seeing it, in any method, and
/// the energy balance still closes (heat of `ball` at 240 K: 8 % too small).
///
/// So contacts are checked every kCheckInterval counted steps. If one slides and rolls more slowly
/// than kSlowRolling × (radius / √(m/k)), the tolerance is reduced until velocities are resolved to
/// kResolvedShare of u_c, if the present one leaves more than kUnresolvedShare of it. It is
/// restored when no such contact remains.
namespace adore::runs {

class FilmTolerance {
 public:
  static constexpr long kCheckInterval = 4;  ///< counted steps
  /// An element changes its speed by less in kCheckInterval steps.
  static constexpr double kSlowRolling = 5e-4;
  static constexpr double kResolvedShare = 0.05;   ///< of u_c
  static constexpr double kUnresolvedShare = 0.3;  ///< of u_c
  static constexpr double kMinTolerance = 1e-9;

  /// @param tolerance of the deck
  FilmTolerance(double tolerance, const scene::Scales& scales)
      : deck_tolerance_(tolerance), velocity_scale_(scales.length / scales.time) {}
  /// The tolerance from here on. @param now in force
  [[nodiscard]] double wanted(const dynamics::System& system, double now) const;

 private:
  double deck_tolerance_;
  double velocity_scale_;  ///< scale of velocities [m/s]
};

/// A sentence on a run that had such a tolerance for some time. @param share of the time
[[nodiscard]] std::string film_tolerance_text(double tolerance, double tightest, double share);

}  // namespace adore::runs
