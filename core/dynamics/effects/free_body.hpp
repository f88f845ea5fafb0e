#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/rigid_body.hpp"

#include <optional>
#include <span>
#include <string>

/// A rigid body whose motion is integrated, a cage segment or a race: six degrees of freedom and
/// its total rotation about its x axis. Mass center from the base origin and its velocity in base
/// axes, quaternion body -> base, ω in body axes, ∫ω_x dt. Newton for the mass center, Euler in
/// body axes: m v̇ = F, I ω̇ + ω × Iω = M about the mass center. Body axes are the geometric ones;
/// the mass center may be off the geometric center and the principal axes may be rotated.
namespace adore::dynamics {

class FreeBody final : public BorderBody {
 public:
  /// Names the states "<name>.position" ... and puts the body in the border of the arrow.
  void declare(SceneBuilder& scene, BodyId id, const std::string& name,
               const bearing::Inertia& inertia);
  /// Accelerations of some directions are given instead: translations of its geometric center in
  /// base axes, rotations about the columns of `axes`; `holding` is what that takes.
  void constrain(const RaceConstraints& constraints, const Mat3& axes) {
    constraints_ = constraints;
    constraint_axes_ = axes;
  }
  /// The given accelerations at this evaluation.
  void prescribe(const Vec3& acceleration, const Vec3& angular_acceleration) noexcept {
    constraints_->acceleration = acceleration;
    constraints_->angular_acceleration = angular_acceleration;
  }
  void start(std::span<double> y, const Vec3& mass_centre, const Vec3& velocity,
             const Quat& orientation, const Vec3& omega_body) const;

  /// Pose and motion from the state.
  void read(const double* y, BodyState& body) const noexcept;
  /// Rates of its states from what acts on it; false when they are not finite.
  bool write_rates(const BodyState& body, const double* y, double* dydt) noexcept;

  [[nodiscard]] BodyId id() const noexcept { return id_; }
  [[nodiscard]] const BodyState& state(const Evaluation& e) const noexcept;
  [[nodiscard]] double kinetic_energy(const BodyState& body) const noexcept;
  void carry(const BodyState& body, Momenta& momenta) const;
  /// Motion, orientation and rotation in y.
  void report(const Evaluation& e, BodySnapshot& snapshot) const;
  [[nodiscard]] double integrated_rotation(const double* y) const noexcept {
    return y[s_.rotation.first];
  }
  /// Force, and moment about `position`, that hold the constrained directions [N, N m].
  [[nodiscard]] const Vec3& holding_force() const noexcept { return holding_force_; }
  [[nodiscard]] const Vec3& holding_moment() const noexcept { return holding_moment_; }

  /// Action = reaction: velocity by F/m, ω by I⁻¹ Rᵀ M.
  void add_rate_contribution(const Evaluation& e, std::size_t i, const Vec3& force,
                             const Vec3& moment, double* row) const noexcept override;

 private:
  struct Slices {
    Slice position, velocity, orientation, omega, rotation;
  };
  [[nodiscard]] Vec3 arm(const BodyState& body) const noexcept {
    return body.to_base * mass_centre_;
  }
  [[nodiscard]] Vec3 angular_momentum(const Vec3& omega_body) const noexcept {
    return principal_axes_aligned_ ? Vec3(principal_inertia_.cwiseProduct(omega_body))
                                   : Vec3(inertia_ * omega_body);
  }
  /// ω̇ in body axes from a moment in base axes, `omega` in body axes.
  [[nodiscard]] Vec3 free_angular_acceleration(const BodyState& body, const Vec3& omega,
                                               const Vec3& moment) const noexcept;
  /// The body with its constraints, for any prescribed values.
  [[nodiscard]] ConstrainedBody held(const BodyState& body) const noexcept {
    return {mass_, body.to_base * inertia_ * body.to_base.transpose(), arm(body), constraint_axes_};
  }

  BodyId id_;
  Slices s_;
  double mass_ = 0.0;
  Vec3 principal_inertia_ = Vec3::Zero();  ///< principal
  Mat3 inertia_ = Mat3::Zero(), inverse_inertia_ = Mat3::Zero();
  Vec3 mass_centre_ = Vec3::Zero();
  bool has_eccentric_mass_ = false,
       principal_axes_aligned_ = true;  ///< straight: principal axes along the body's
  std::optional<RaceConstraints> constraints_;
  Mat3 constraint_axes_ = Mat3::Identity();
  Vec3 holding_force_ = Vec3::Zero(), holding_moment_ = Vec3::Zero();
};

/// Blocks of a free body.
class BodyKinematics final : public EffectBlock {
 public:
  explicit BodyKinematics(const FreeBody& body) : body_(body) {}
  void apply(Evaluation& e) noexcept override { body_.read(e.y, e.body(body_.id())); }

 private:
  const FreeBody& body_;
};
class BodyMotion final : public EffectBlock {
 public:
  explicit BodyMotion(FreeBody& body) : body_(body) {}
  void apply(Evaluation& e) noexcept override {
    e.valid = body_.write_rates(e.body(body_.id()), e.y, e.dydt) && e.valid;
  }

 private:
  FreeBody& body_;
};

}  // namespace adore::dynamics
