#pragma once

#include "base/rotation.hpp"

#include <array>

/// Centre of an inner race without inertia (mode 2): in the directions whose load is given it
/// stands where R = load + force of the elements = 0. Its place c is state; it moves by
///   ċ = K⁻¹ (D + λ R),   K = -dR/dc with elements that follow the race, D = ∂R/∂t at fixed c,
/// so that it goes with its balance and a departure R decays at the rate λ = ½ √(tr K / 3 M), M the
/// mass of all elements: the pace at which the elements themselves settle (held_elements.hpp). D
/// needs no friction, R has all of it. Directions without stiffness stay where they are. [SI, base
/// axes]
namespace adore::dynamics {

class BalancedRace {
 public:
  /// @param free directions whose load is given
  BalancedRace(const Vec3& load, const std::array<bool, 3>& free) : load_(load), free_(free) {}

  /// Takes K and D [N/m, N/s]; velocity() is then K⁻¹ D.
  void estimate(const Mat3& stiffness, const Vec3& drift, double element_mass) noexcept;
  [[nodiscard]] const Vec3& velocity() const noexcept { return velocity_; }
  /// λ K⁻¹ R from the force of the elements on the race [N].
  [[nodiscard]] Vec3 pull(const Vec3& of_elements) const noexcept;
  /// R in the free directions [N].
  [[nodiscard]] Vec3 residual(const Vec3& of_elements) const noexcept;
  [[nodiscard]] const Vec3& load() const noexcept { return load_; }
  [[nodiscard]] const std::array<bool, 3>& free() const noexcept { return free_; }

 private:
  Vec3 load_;
  std::array<bool, 3> free_;
  Mat3 inverse_ = Mat3::Zero();  ///< of K where it has stiffness
  Vec3 velocity_ = Vec3::Zero();
  double rate_ = 0.0;  ///< λ [1/s]
};

}  // namespace adore::dynamics
