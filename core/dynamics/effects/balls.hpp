#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/element_masses.hpp"

/// The balls as bodies: states, equations of motion (ball_motion.hpp), energy and momentum.
namespace adore::dynamics {

/// Views of the element states; sines and cosines of the azimuths. Not valid when an element is on
/// the axis.
class ElementKinematics final : public EffectBlock {
 public:
  explicit ElementKinematics(const ElementSlices& slices) : s_(slices) {}
  void apply(Evaluation& e) noexcept override;

 private:
  ElementSlices s_;
};

class BallMotion final : public EffectBlock {
 public:
  BallMotion(const ElementSlices& slices, double mass, double inertia)
      : s_(slices), mass_(mass), inertia_(inertia) {}
  void apply(Evaluation& e) noexcept override;

 private:
  ElementSlices s_;
  double mass_, inertia_;
};

/// Of balls that differ.
class UnequalBallMotion final : public EffectBlock {
 public:
  UnequalBallMotion(const ElementSlices& slices, const ElementMasses& masses);
  void apply(Evaluation& e) noexcept override;

 private:
  ElementSlices s_;
  std::vector<double> inverse_mass_, inverse_inertia_;  ///< by ball [1/kg, 1/(kg m²)]
};

class Balls final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  void start(std::span<double> y) const override;
  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override;
  void store(const Evaluation& e, EnergyLedger& energy) const override;
  void carry(const Evaluation& e, Momenta& momenta) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;

  [[nodiscard]] const ElementSlices& slices() const noexcept { return s_; }

 private:
  ElementSlices s_;
  ElementMasses masses_;
  std::vector<statics::StaticBall> start_;
};

}  // namespace adore::dynamics
