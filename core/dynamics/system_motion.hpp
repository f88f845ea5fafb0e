#pragma once

#include "dynamics/system_effects.hpp"

#include <vector>

/// Kinematics, race contacts, gravity and the equations of motion: the blocks that are no cage
/// contact. Ball equations in (x, r, θ) and the azimuth components of ω:
/// tests/reference/dynamics_README.md, "Ball equations".
namespace adore::dynamics {

struct OrientedElement {
  std::size_t element = 0;  ///< 0-based
  Slice orientation;        ///< quaternion, body -> base
  Slice rotation;           ///< ∫ ω·(body x axis) dt
};

/// Views of the ball states; sines and cosines of the azimuths. Not valid when a ball is on the
/// axis.
class BallKinematics final : public EffectBlock {
 public:
  explicit BallKinematics(const BallSlices& slices) : s_(slices) {}
  void apply(Evaluation& e) noexcept override;

 private:
  BallSlices s_;
};

class CageKinematics final : public EffectBlock {
 public:
  explicit CageKinematics(const CageSlices& slices) : s_(slices) {}
  void apply(Evaluation& e) noexcept override;

 private:
  CageSlices s_;
};

/// Effects "race contact" and "race traction" of one race. `model` must outlive the block. Not
/// valid when a ball is pressed into a race by more than its radius.
class RaceBlock final : public EffectBlock {
 public:
  /// @param load_slip the wear integrals are wanted
  RaceBlock(const RaceContactModel& model, bool load_slip);
  void apply(Evaluation& e) noexcept override;

 private:
  const RaceContactModel& model_;
  bool load_slip_;
  double load_limit_;
};

class BallGravity final : public EffectBlock {
 public:
  explicit BallGravity(const Vec3& weight) : weight_(weight) {}
  void apply(Evaluation& e) noexcept override;

 private:
  Vec3 weight_;  ///< of one ball [N]
};

class CageGravity final : public EffectBlock {
 public:
  explicit CageGravity(const Vec3& weight) : weight_(weight) {}
  void apply(Evaluation& e) noexcept override { e.cage.force += weight_; }

 private:
  Vec3 weight_;
};

class BallMotion final : public EffectBlock {
 public:
  BallMotion(const BallSlices& slices, double mass, double inertia)
      : s_(slices), mass_(mass), inertia_(inertia) {}
  void apply(Evaluation& e) noexcept override;

 private:
  BallSlices s_;
  double mass_, inertia_;
};

/// Newton and Euler for the cage: inertia diagonal in body axes.
class CageMotion final : public EffectBlock {
 public:
  CageMotion(const CageSlices& slices, const bearing::Inertia& inertia)
      : s_(slices), inertia_(inertia) {}
  void apply(Evaluation& e) noexcept override;

 private:
  CageSlices s_;
  bearing::Inertia inertia_;
};

/// Orientation of the balls that something reads.
class OrientationMotion final : public EffectBlock {
 public:
  explicit OrientationMotion(std::vector<OrientedElement> elements)
      : elements_(std::move(elements)) {}
  void apply(Evaluation& e) noexcept override;

 private:
  std::vector<OrientedElement> elements_;
};

/// What acts from outside on balls and cage together: the reactions of the prescribed races and
/// gravity, as force and as moment about the base origin. The race sums are formed apart from the
/// forces on the balls, so the momentum residual sees a force without its reaction.
class ExternalActions final : public EffectBlock {
 public:
  ExternalActions(const Vec3& gravity, double ball_mass, double cage_mass)
      : gravity_(gravity),
        ball_mass_(ball_mass),
        cage_mass_(cage_mass),
        has_gravity_(!gravity.isZero(0.0)) {}
  void apply(Evaluation& e) noexcept override;

 private:
  Vec3 gravity_;
  double ball_mass_, cage_mass_;
  bool has_gravity_;
};

/// Time integrals: rate of state component `index` is *rate, a member of the Evaluation.
class Quadratures final : public EffectBlock {
 public:
  struct Entry {
    int index;
    const double* rate;
  };
  explicit Quadratures(std::vector<Entry> entries) : entries_(std::move(entries)) {}
  void apply(Evaluation& e) noexcept override;

 private:
  std::vector<Entry> entries_;
};

}  // namespace adore::dynamics
