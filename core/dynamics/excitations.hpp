#pragma once

#include "base/rotation.hpp"
#include "bearing/race_motion.hpp"

#include <array>
#include <optional>

/// Prescribed motions of races and the base frame's own motion (records 9.3, 9.4), SI and rad, base
/// axes. One function gives position, velocity and acceleration together, so that they cannot
/// disagree; at t = 0 the velocity is that of the law, not 0. Laws without amplitude are at rest.
namespace adore::dynamics {

/// A race center and its time derivatives.
struct PrescribedMotion {
  Vec3 position, velocity, acceleration;  ///< [m, m/s, m/s²]
};

/// A race's turn about its axis and its time derivatives.
struct PrescribedRotation {
  double angle = 0.0, speed = 0.0, acceleration = 0.0;  ///< [rad, rad/s, rad/s²]
};

/// Load that turns (9.3A): of the static radial deflection, size δ at azimuth ψ, the share f of
/// each race turns at its speed ω and the rest stays. At t = 0 every race has its static position.
/// Inner center: s_i + f_i δ [e_r(ψ + ω_i t) - e_r(ψ)]; outer: s_o - f_o δ [e_r(ψ + ω_o t) -
/// e_r(ψ)]. Without radial deflection nothing moves.
class RotatingLoad {
 public:
  /// @param static_centre outer, inner race center of the static solution [m]
  /// @param fraction, speed of outer and inner race [-, rad/s]
  RotatingLoad(const std::array<Vec3, 2>& static_centre, const std::array<double, 2>& fraction,
               const std::array<double, 2>& speed) noexcept;
  /// @param race 0 outer, 1 inner
  [[nodiscard]] PrescribedMotion at(int race, double t) const noexcept;

 private:
  std::array<Vec3, 2> centre_;
  std::array<double, 2> radius_, speed_;  ///< signed f δ [m]
  double azimuth_;
};

/// Vibration (9.3B): s + A sin ωt, ω = 2π frequency. frequency in Hz.
[[nodiscard]] PrescribedMotion vibration(const Vec3& static_centre, const Vec3& amplitude,
                                         double frequency, double t) noexcept;

/// Speed ramp (9.4A): Ω0 + a (clamp(t, begin, end) - begin), a acts on [begin, end). An empty
/// window (end <= begin) has no ramp. Steppers must break their step at begin and end, where the
/// acceleration jumps.
struct SpeedRamp {
  double acceleration = 0.0;      ///< a [rad/s²]
  double begin = 0.0, end = 0.0;  ///< [s]
};
[[nodiscard]] PrescribedRotation ramped_rotation(double start_speed, const SpeedRamp& ramp,
                                                 double t) noexcept;

/// Speed variation (9.4B): Ω0 + A sin ωt, angle Ω0 t + (A/ω)(1 - cos ωt), ω = 2π frequency;
/// frequency 0: no variation. amplitude A in rad/s, frequency in Hz.
[[nodiscard]] PrescribedRotation varying_rotation(double start_speed, double amplitude,
                                                  double frequency, double t) noexcept;

/// All laws of both races together, in addition to static position and constant spin.
class RaceMotionLaws {
 public:
  RaceMotionLaws(const std::array<Vec3, 2>& static_centre, const bearing::RaceMotions& motions);
  [[nodiscard]] bool has_center_motion() const noexcept {
    return rotating_load_ || motions_.vibration[0] || motions_.vibration[1];
  }
  [[nodiscard]] bool turns() const noexcept {
    return motions_.ramp[0] || motions_.ramp[1] || motions_.variation[0] || motions_.variation[1];
  }
  /// Displacement from the static place, its velocity and acceleration. @param race 0 outer, 1
  /// inner
  [[nodiscard]] PrescribedMotion place(int race, double t) const noexcept;
  /// Turn beyond the constant spin.
  [[nodiscard]] PrescribedRotation turn(int race, double t) const noexcept;

 private:
  std::array<Vec3, 2> centre_;
  bearing::RaceMotions motions_;
  std::optional<RotatingLoad> rotating_load_;
};

}  // namespace adore::dynamics
