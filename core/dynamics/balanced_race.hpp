#pragma once

#include "base/rotation.hpp"

#include <array>

/// Center of an inner race without inertia (mode 2): in the directions whose load is given it
/// is where R = load + force of the elements = 0. Its position c is state; it moves by
///   ċ = K⁻¹ D + (K/λ + C)⁻¹ R,   K = -dR/dc with elements that follow the race, D = ∂R/∂t at fixed
/// c, C = friction force over slip speed, summed over the contacts with the race,
/// so that it follows its balance and a difference R decays at the rate λ = ½ √(tr K / 3 M), M the
/// mass of all elements: the pace at which the elements themselves settle (held_elements.hpp), or
/// more slowly where friction is stronger. Without C the race overshoots its slip where C > √(K m)
/// and oscillates without end: with the creep v of elements of mass m, m v' = C (ċ - v), the
/// polynomial s² + s (λ + C/m - λ C²/(m K)) + λ C/m loses its damping [derived]. D needs no
/// friction, R has all of it. Directions without stiffness do not move. A fraction of the radial
/// load may turn about x (record 9.3A): load(t) = load + share (turn(ω t) - 1) radial load, whose
/// rate is part of D. [SI, base axes]
namespace adore::dynamics {

class BalancedRace {
 public:
  /// @param free directions whose load is given
  BalancedRace(const Vec3& load, const std::array<bool, 3>& free) : load_(load), free_axes_(free) {}

  /// The radial load must be given along y and z.
  void set_rotating_load(double share, double speed) noexcept {
    rotating_load_fraction_ = share;
    rotating_load_speed_ = speed;
  }
  /// Load of routine ADRX1 of the user and its rate at this time [N, N/s].
  void add_load(const Vec3& load, const Vec3& rate) noexcept {
    user_load_ = load;
    user_load_rate_ = rate;
  }
  /// Sets the load of this time.
  void set_time(double t) noexcept;
  /// Takes K and D at a steady load [N/m, N/s]; velocity() is then K⁻¹ D, the load's rate in D.
  void estimate_velocity(const Mat3& stiffness, const Vec3& drift, double element_mass) noexcept;
  [[nodiscard]] const Vec3& velocity() const noexcept { return velocity_; }
  /// Takes C [N s/m]. After estimate_velocity(), which sets it to zero.
  void resist(const Mat3& friction) noexcept;
  /// (K/λ + C)⁻¹ R from the force of the elements on the race [N].
  [[nodiscard]] Vec3 pull(const Vec3& of_elements) const noexcept;
  /// R in the free directions [N].
  [[nodiscard]] Vec3 residual(const Vec3& of_elements) const noexcept;
  [[nodiscard]] Vec3 load() const noexcept { return load_ + user_load_; }
  [[nodiscard]] const std::array<bool, 3>& free() const noexcept { return free_axes_; }

 private:
  Vec3 load_, load_at_start_ = load_, load_rate_ = Vec3::Zero();
  Vec3 user_load_ = Vec3::Zero(), user_load_rate_ = Vec3::Zero();
  double rotating_load_fraction_ = 0.0,
         rotating_load_speed_ = 0.0;  ///< of the load that turns [rad/s]
  std::array<bool, 3> free_axes_;
  Mat3 stiffness_ = Mat3::Zero();         ///< K in the free directions
  Mat3 stiff_projection_ = Mat3::Zero();  ///< projection on the directions in which K has stiffness
  Mat3 mobility_ = Mat3::Zero();          ///< (K/λ + C)⁻¹ in those
  Vec3 velocity_ = Vec3::Zero();
  double rate_ = 0.0;  ///< λ [1/s]
};

}  // namespace adore::dynamics
