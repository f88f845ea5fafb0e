#pragma once

#include "dynamics/effect.hpp"

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

class Balls final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  void start(std::span<double> y) const override;
  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override;
  void store(const Evaluation& e, EnergyLedger& energy) const override;
  void carry(const Evaluation& e, Momenta& momenta) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;

  [[nodiscard]] const ElementSlices& slices() const noexcept { return s_; }
  [[nodiscard]] double mass() const noexcept { return mass_; }

 private:
  ElementSlices s_;
  double mass_ = 0.0, inertia_ = 0.0;  ///< [kg, kg m²]
  std::vector<statics::StaticBall> start_;
};

}  // namespace adore::dynamics
