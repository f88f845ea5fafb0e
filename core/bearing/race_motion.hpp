#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <optional>

/// Motion of the races beyond their constant spin: free under loads, or by laws of time (records
/// 2.2, 9.3, 9.4), and motion of the base frame (9.5). Plain values, SI and rad, base axes.
namespace adore::bearing {

/// A race that moves under what acts on it; its inertia is Bearing::race_inertia.
struct FreeRace {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< applied at the race's center, constant [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< applied, constant [N m]
  /// Directions that keep the velocity of their start, or follow the laws below (false: free).
  /// Translations along base axes, rotations about the axes of the race at the start.
  std::array<bool, 3> translation_held{}, rotation_held{};
};

/// Load that turns (9.3A), see dynamics/excitations.hpp. Outer, inner race.
struct RotatingLoadParameters {
  std::array<double, 2> fraction{};  ///< of the static deflection that turns [-]
  std::array<double, 2> speed{};     ///< [rad/s]
};

/// Vibration of one race (9.3B).
struct Vibration {
  Eigen::Vector3d amplitude = Eigen::Vector3d::Zero();  ///< [m]
  double frequency = 0.0;                               ///< [Hz]
};

/// Speed ramp of one race (9.4A).
struct SpeedRampParameters {
  double acceleration = 0.0;      ///< [rad/s²]
  double begin = 0.0, end = 0.0;  ///< [s]
};

/// Sinusoidal variation of one race's speed (9.4B).
struct SpeedVariation {
  double amplitude = 0.0;  ///< [rad/s]
  double frequency = 0.0;  ///< [Hz]
};

/// Base frame that turns about a fixed axis parallel to X (9.5).
struct FrameMotion {
  double speed = 0.0;         ///< about the fixed axis, along +X [rad/s]
  double orbit_radius = 0.0;  ///< fixed axis -> base origin [m]
  double orbit_angle = 0.0;   ///< azimuth of the base origin seen from the fixed axis [rad]
  /// Share of the inertial force of outer and inner race that loads the bearing; free races feel
  /// that share of it.
  std::array<double, 2> load_share{1.0, 1.0};
  /// Acceleration that a body at rest at the base origin feels in the frame: Ω² R outwards [m/s²].
  [[nodiscard]] Eigen::Vector3d field() const {
    return speed * speed * orbit_radius *
           Eigen::Vector3d(0.0, -std::sin(orbit_angle), std::cos(orbit_angle));
  }
};

struct RaceMotions {
  std::array<std::optional<FreeRace>, 2> free;
  std::optional<RotatingLoadParameters> rotating_load_parameters;
  std::array<std::optional<Vibration>, 2> vibration;
  std::array<std::optional<SpeedRampParameters>, 2> ramp;
  std::array<std::optional<SpeedVariation>, 2> variation;
  std::optional<FrameMotion> frame;

  /// Does race j (0 outer, 1 inner) move by a law of time in addition to its constant spin?
  [[nodiscard]] bool has_excitation(int j) const noexcept {
    const auto k = static_cast<std::size_t>(j);
    return rotating_load_parameters || vibration[k] || ramp[k] || variation[k];
  }
  [[nodiscard]] bool has_excitation() const noexcept {
    return has_excitation(0) || has_excitation(1);
  }
  [[nodiscard]] bool has_free_motion() const noexcept { return free[0] || free[1]; }
};

}  // namespace adore::bearing
