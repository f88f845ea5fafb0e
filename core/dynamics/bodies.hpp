#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"
#include "dynamics/race_contacts.hpp"

/// Rigid bodies of a scene except its elements: cage segments and races. SI, base axes unless
/// stated otherwise.
namespace adore::dynamics {

/// Determines the motion of a body.
enum class Moves : unsigned char {
  Prescribed,  ///< a law of the time; what acts on it changes nothing
  Integrated   ///< Newton and Euler: it has inertia and separate states
};

/// Pose and motion of a body at this evaluation, and what acts on it.
struct BodyState {
  Moves moves = Moves::Prescribed;
  double mass = 0.0;                 ///< of integrated bodies [kg]
  Mat3 inertia = Mat3::Zero();       ///< the same, about the mass center, body axes [kg m²]
  Vec3 mass_centre = Vec3::Zero();   ///< from `position`, body axes [m]
  Vec3 position = Vec3::Zero();      ///< of its reference point: of a cage segment the mass center,
                                     ///< of a race the center of the groove circle P_j [m]
  Vec3 velocity = Vec3::Zero();      ///< of that point [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< of that point, where it is prescribed; reports only
  Quat attitude{1, 0, 0, 0};         ///< body -> base
  Mat3 to_base = Mat3::Identity();   ///< the same
  Vec3 omega = Vec3::Zero(), omega_body = Vec3::Zero();  ///< [rad/s]; omega_body where integrated
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();      ///< about `position` [N, N m]
  double load_slip = 0.0;                                ///< Σ N u of all its contacts [W]

  /// Velocity of the body point that is at `point` of the base frame now.
  [[nodiscard]] Vec3 velocity_at(const Vec3& point) const noexcept {
    return velocity + omega.cross(point - position);
  }
  void add_force(const Vec3& f, const Vec3& point) noexcept {
    force += f;
    moment += (point - position).cross(f);
  }
  /// Position of its mass center [m].
  [[nodiscard]] Vec3 centre_of_mass() const noexcept { return position + to_base * mass_centre; }
  void clear_actions() noexcept {
    force.setZero();
    moment.setZero();
    load_slip = 0.0;
  }
};

/// A race: a body whose contacts know it as a body of revolution, ω = Ω k + tilt with its axis k.
/// Whoever changes its motion ends with settle().
struct RaceBody : BodyState {
  double speed = 0.0;        ///< Ω about its axis [rad/s]
  Vec3 tilt = Vec3::Zero();  ///< part of ω across the axis: dk/dt = tilt × k [rad/s]
  double angle = 0.0;        ///< turned about its axis since the start [rad]
  double turn_beyond = 0.0;  ///< part of `angle` that `attitude` leaves out [rad]

  [[nodiscard]] Vec3 axis() const noexcept { return to_base.col(0); }
  /// Input of the contact kernel.
  [[nodiscard]] RaceMotion motion() const noexcept {
    return {position, axis(), speed, velocity, tilt, to_base.col(2), turn_beyond};
  }
  [[nodiscard]] Quat orientation() const noexcept {
    return multiply(attitude, quaternion_about(Vec3::UnitX(), turn_beyond));
  }
  void set_attitude(const Quat& q) noexcept {
    attitude = q;
    to_base = rotation_matrix(q);
  }
  /// ω from speed, axis and tilt.
  void settle() noexcept {
    omega = speed * axis();
    if (!tilt.isZero(0.0)) omega += tilt;  // else zeros keep their signs
  }
};

/// Which body of a scene: what effects name a partner by before all bodies are declared.
struct BodyId {
  enum class Kind : unsigned char { Segment, Race, Other };
  Kind kind = Kind::Segment;
  int index = 0;
  friend bool operator==(const BodyId&, const BodyId&) = default;
};

}  // namespace adore::dynamics
