#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/rigid_body.hpp"

#include <optional>
#include <span>
#include <string>

/// A rigid body whose motion is integrated, a cage segment or a race: six degrees of freedom and
/// its total turn about its x axis. Mass centre from the base origin and its velocity in base axes,
/// quaternion body -> base, ω in body axes, ∫ω_x dt. Newton for the mass centre, Euler in principal
/// body axes: m v̇ = F, I ω̇ + ω × Iω = M about the mass centre.
namespace adore::dynamics {

class FreeBody final : public BorderBody {
 public:
  /// Names the states "<name>.position" ... and puts the body in the border of the arrow.
  void declare(SceneBuilder& scene, BodyId id, const std::string& name,
               const bearing::Inertia& inertia, const Vec3& mass_centre = Vec3::Zero());
  /// Accelerations of some directions are given instead (base axes); `holding` is what that takes.
  void constrain(const RaceConstraints& constraints) { constraints_ = constraints; }
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
  /// Motion, orientation and turn as they stand in y.
  void report(const Evaluation& e, BodySnapshot& snapshot) const;
  [[nodiscard]] double total_turn(const double* y) const noexcept { return y[s_.rotation.first]; }
  /// Force, and moment about the mass centre, that hold the constrained directions [N, N m].
  [[nodiscard]] const Vec3& holding_force() const noexcept { return holding_force_; }
  [[nodiscard]] const Vec3& holding_moment() const noexcept { return holding_moment_; }

  /// Action = reaction: velocity by F/m, ω by I⁻¹ Rᵀ M.
  void add_share(const Evaluation& e, std::size_t i, const Vec3& force, const Vec3& moment,
                 double* row) const noexcept override;

 private:
  struct Slices {
    Slice position, velocity, orientation, omega, rotation;
  };
  [[nodiscard]] Vec3 arm(const BodyState& body) const noexcept {
    return body.to_base * mass_centre_;
  }

  BodyId id_;
  Slices s_;
  bearing::Inertia inertia_;
  Vec3 mass_centre_ = Vec3::Zero();
  bool off_centre_ = false;
  std::optional<RaceConstraints> constraints_;
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
