#include "contact/cage_pieces.hpp"
#include "dynamics/effect_makers.hpp"
#include "tribology/bearing_drag.hpp"

#include <cmath>
#include <numbers>
#include <optional>

/// Drag and churning of the medium in the cavity on elements and cage: two effects, formulas of
/// tribology/bearing_drag.hpp. The medium turns with the outer race, which takes the reaction, so
/// that heat = -(force · velocity + moment · angular velocity) relative to it is all that the
/// medium takes. Of elements in force balance (qFac, modes 1 and 2) it takes orbit and spin only:
/// their way along x and r has no inertia, and no drag either.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kElementHeat{LedgerKind::Heat,
                                  "element_drag",
                                  "drag and churning of elements",
                                  {"drag of elements in the medium"},
                                  "dissipated since the start"};
constexpr LedgerTerm kCageHeat{LedgerKind::Heat,
                               "cage_drag",
                               "drag and churning of the cage",
                               {"drag of the cage in the medium"},
                               "dissipated since the start"};
constexpr const LedgerTerm* kElementTerms[] = {&kElementHeat};
constexpr const LedgerTerm* kCageTerms[] = {&kCageHeat};

/// Share of a heat in the loss now.
double share(double heat, const Snapshot& snapshot) {
  return snapshot.power.total_loss > 0.0 ? heat / snapshot.power.total_loss : 0.0;
}

template <bool Rollers, bool Balanced>
class ElementBlock final : public EffectBlock {
 public:
  ElementBlock(const tribology::BearingDrag& drag, double& heat) : drag_(drag), heat_(heat) {}
  void apply(Evaluation& e) noexcept override;

 private:
  const tribology::BearingDrag& drag_;
  double& heat_;
};

template <bool Rollers, bool Balanced>
void ElementBlock<Rollers, Balanced>::apply(Evaluation& e) noexcept {
  heat_ = 0.0;
  RaceBody& medium = e.race[0];
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const Vec3 centre = e.element_centre(i);
    const Vec3 V = e.element_velocity(i) - medium.velocity_at(centre);
    Vec3 force;
    if constexpr (Balanced) {
      const Vec3 along = e.to_base(i, 0.0, 0.0, 1.0);
      const double v = V.dot(along);
      force = -drag_.element_force_per_speed(std::abs(v)) * v * along;
    } else {
      force = -drag_.element_force_per_speed(V.norm()) * V;
    }
    const Vec3 spin = e.element_omega(i) - medium.omega;
    Vec3 moment;
    if constexpr (Rollers) {
      const Vec3 axis = e.attitude[i].col(0);
      const double w = spin.dot(axis);
      moment = -drag_.element_spin(std::abs(w)) * w * axis;
    } else {
      moment = -drag_.element_spin(spin.norm()) * spin;
    }
    e.add_force(i, e.to_cylindrical(i, force));
    e.add_moment(i, e.to_cylindrical(i, moment));
    medium.add_force(-force, centre);
    medium.moment -= moment;
    heat_ -= force.dot(V) + moment.dot(spin);
  }
}

class ElementDrag final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    drag_.emplace(scene.bearing);
    const bool balanced =
        scene.plan.has(Effect::LightLoadBalance) || scene.plan.has(Effect::ElementBalance);
    const auto add = [&]<bool Rollers, bool Balanced>() {
      scene.block<ElementBlock<Rollers, Balanced>>(Phase::Force, "drag in the medium",
                                                   BodyId{BodyId::Kind::Race, 0}, *drag_, heat_);
    };
    if (scene.plan.rollers)
      balanced ? add.operator()<true, true>() : add.operator()<true, false>();
    else
      balanced ? add.operator()<false, true>() : add.operator()<false, false>();
    scene.energy("elements.drag", kElementHeat, &heat_);
  }
  void report(const Evaluation&, Snapshot& snapshot) const override {
    snapshot.power.churning_fraction += share(heat_, snapshot);
  }

 private:
  std::optional<tribology::BearingDrag> drag_;
  double heat_ = 0.0;  ///< now [W]
};

/// A segment has its part of the moments of a whole cage, and the force that opposite parts do not
/// cancel.
class CageBlock final : public EffectBlock {
 public:
  CageBlock(const tribology::BearingDrag& drag, double half_angle, double& heat)
      : drag_(drag),
        moment_share_(half_angle / std::numbers::pi),
        force_share_(std::sin(half_angle) / std::numbers::pi),
        heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    heat_ = 0.0;
    for (BodyState& cage : e.segments) {
      for (const tribology::CageSurface& surface : drag_.surfaces())
        act(e.race[static_cast<std::size_t>(surface.race)], cage, surface.radius,
            [&](double w) { return drag_.surface_moment_per_speed(surface, w); });
      act(e.race[0], cage, drag_.mean_face_radius(),
          [&](double w) { return drag_.face_moment_per_speed(w); });
    }
  }

 private:
  template <class Moment>
  void act(RaceBody& race, BodyState& cage, double radius, const Moment& moment_of) noexcept {
    const Vec3 axis = cage.to_base.col(0);
    const Vec3 relative = cage.omega - race.omega;
    const double w = relative.dot(axis), torque = -moment_of(std::abs(w)) * w;
    const Vec3 moment = (moment_share_ * torque) * axis;
    cage.moment += moment;
    race.moment -= moment;
    heat_ -= moment.dot(relative);
    if (is_whole()) return;
    const Vec3 force = (force_share_ * torque / radius) * axis.cross(Vec3(cage.to_base.col(2)));
    cage.force += force;
    race.add_force(-force, cage.position);
    heat_ -= force.dot(cage.velocity - race.velocity_at(cage.position));
  }
  [[nodiscard]] bool is_whole() const noexcept { return moment_share_ == 1.0; }

  const tribology::BearingDrag& drag_;
  double moment_share_, force_share_;  ///< 1, 0: a whole cage
  double& heat_;
};

class CageDrag final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    drag_.emplace(scene.bearing);
    const bearing::Segmentation& cut = scene.bearing.cage->segments;
    const double half =
        cut.several() ? std::numbers::pi / cut.count - 0.5 * cut.cut_angle : std::numbers::pi;
    scene.block<CageBlock>(Phase::Force, "drag in the medium", {}, *drag_, half, heat_);
    scene.energy("cage.drag", kCageHeat, &heat_);
  }
  void report(const Evaluation&, Snapshot& snapshot) const override {
    snapshot.power.churning_fraction += share(heat_, snapshot);
  }

 private:
  std::optional<tribology::BearingDrag> drag_;
  double heat_ = 0.0;  ///< now [W]
};

}  // namespace

std::unique_ptr<SceneEffect> make_element_drag(const ScenePlan& plan) {
  if (!plan.has(Effect::ElementDrag)) return nullptr;
  return std::make_unique<ElementDrag>();
}
std::span<const LedgerTerm* const> element_drag_terms() { return kElementTerms; }

std::unique_ptr<SceneEffect> make_cage_drag(const ScenePlan& plan) {
  if (!plan.has(Effect::CageDrag)) return nullptr;
  return std::make_unique<CageDrag>();
}
std::span<const LedgerTerm* const> cage_drag_terms() { return kCageTerms; }

}  // namespace adore::dynamics
