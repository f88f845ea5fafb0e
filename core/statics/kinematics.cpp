#include "statics/kinematics.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace adore::statics {

EpicyclicSpeeds epicyclic_speeds(int count, double diameter, double pitch_diameter,
                                 double contact_angle, double outer_speed, double inner_speed) {
  if (count < 1) {
    throw InputError(
        fmt::format("bearing kinematics: {} rolling elements; there must be at least one", count));
  }
  if (!(std::isfinite(diameter) && diameter > 0.0)) {
    throw InputError(fmt::format(
        "bearing kinematics: the element diameter is {} m; it must be positive", diameter));
  }
  if (!(std::isfinite(contact_angle) && std::isfinite(pitch_diameter) &&
        pitch_diameter > diameter * std::abs(std::cos(contact_angle)))) {
    throw InputError(
        fmt::format("bearing kinematics: the pitch diameter is {} m; it must exceed D cos α = {} m "
                    "(D = {} m, α = {} rad)",
                    pitch_diameter, diameter * std::cos(contact_angle), diameter, contact_angle));
  }
  if (!(std::isfinite(outer_speed) && std::isfinite(inner_speed))) {
    throw InputError(fmt::format(
        "bearing kinematics: the race speeds are {} and {} rad/s; they must be finite numbers",
        outer_speed, inner_speed));
  }
  constexpr double kTurn = 2.0 * std::numbers::pi;
  EpicyclicSpeeds s;
  s.gamma = diameter / pitch_diameter * std::cos(contact_angle);
  s.cage_speed = epicyclic_speed(outer_speed, inner_speed, s.gamma);
  s.element_spin = std::abs(inner_speed - outer_speed) * pitch_diameter *
                   (1.0 - s.gamma * s.gamma) / (2.0 * diameter);
  // Differences of race and cage speed written without cancellation for co-rotating races.
  s.outer_pass = count * 0.5 * std::abs(inner_speed - outer_speed) * (1.0 - s.gamma) / kTurn;
  s.inner_pass = count * 0.5 * std::abs(inner_speed - outer_speed) * (1.0 + s.gamma) / kTurn;
  s.spin_frequency = s.element_spin / kTurn;
  s.cage_frequency = s.cage_speed / kTurn;
  return s;
}

}  // namespace adore::statics
