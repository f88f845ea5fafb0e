#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/element_masses.hpp"

/// Rolling elements as rigid bodies with any inertia: rollers, and balls of unequal moments or
/// eccentric mass (record 6.1). Reference point P in (x, r, θ) as for balls (balls.hpp), attitude
/// as a quaternion body -> base, ω absolute on the azimuth axes. The mass center G is at the arm c
/// from P (element_masses.hpp). Euler about G with the tensor I of the body, B = body -> azimuth
/// axes, F and M about P what acts on the element:
///   ω̇ = B I⁻¹ (Bᵀ M - c × Bᵀ F - ω_b × I ω_b),  ω_b = Bᵀ ω;   rates of the components on e_x, e_r,
///   e_θ: ω̇ - θ̇ e_x × ω
///   a_P = F/m - B (ω̇_b × c + ω_b × (ω_b × c))
/// The whole is free, so that neither needs a system of equations.
/// Blocks and effects read the attitudes from Evaluation::attitude. Not valid when an element is on
/// the axis, or a roller is across the bearing.
namespace adore::dynamics {

/// Start position of an element.
struct ElementStartState {
  double azimuth = 0.0, x = 0.0, r = 0.0;  ///< of the reference point [rad, m, m]
  double theta_dot = 0.0;                  ///< [rad/s]
  Vec3 omega = Vec3::Zero();               ///< on e_x, e_r, e_θ [rad/s]
  Quat attitude{1, 0, 0, 0};               ///< body -> base
};

class RigidElements final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  void start(std::span<double> y) const override;
  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override;
  void store(const Evaluation& e, EnergyLedger& energy) const override;
  void carry(const Evaluation& e, Momenta& momenta) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;

  [[nodiscard]] const ElementSlices& slices() const noexcept { return s_; }
  /// Quaternion of an element in the state.
  [[nodiscard]] const Slice& attitude(std::size_t element) const noexcept {
    return attitude_[element];
  }

 private:
  class Kinematics;
  class Motion;
  struct Rotation {
    std::size_t element = 0;
    Slice turn;  ///< ∫ ω·(body x axis) dt
  };
  [[nodiscard]] Vec3 velocity_from_state(const Evaluation& e, std::size_t i) const noexcept;
  /// About the mass center.
  [[nodiscard]] Vec3 angular_momentum(const Evaluation& e, std::size_t i) const noexcept;
  /// From the reference point to the mass center, base axes.
  [[nodiscard]] Vec3 arm(const Evaluation& e, std::size_t i) const noexcept {
    return e.attitude[i] * masses_[i].arm;
  }

  ElementSlices s_;
  std::vector<Slice> attitude_;     ///< by element
  std::vector<Rotation> rotation_;  ///< of the elements that files show
  ElementMasses masses_;
  bool rollers_ = false;
  std::vector<ElementStartState> start_;
};

}  // namespace adore::dynamics
