#include "dynamics/effect_makers.hpp"
#include "dynamics/element_masses.hpp"
#include "scene/ledger_terms.hpp"

/// External loads on balls, cage and free races together: the reactions of the prescribed
/// races and gravity, as force and as moment about the base origin. The race sums are formed
/// independently of the forces on the balls, so the momentum residual detects a force without its
/// reaction.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kImpulse{LedgerKind::Work, "", "", {"impulse from outside"}, ""};
constexpr LedgerTerm kAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse from outside"}, ""};

class ExternalActions final : public EffectBlock {
 public:
  ExternalActions(const Vec3& gravity, const ElementMasses& masses, Vec3& force, Vec3& moment)
      : gravity_(gravity),
        masses_(masses),
        has_gravity_(!gravity.isZero(0.0)),
        force_(force),
        moment_(moment) {}
  void apply(Evaluation& e) noexcept override;

 private:
  Vec3 gravity_;
  const ElementMasses& masses_;
  bool has_gravity_;
  Vec3 &force_, &moment_;
};

void ExternalActions::apply(Evaluation& e) noexcept {
  force_.setZero();
  moment_.setZero();
  for (const RaceBody& race : e.race) {
    if (race.moves == Moves::Integrated) continue;  // its reaction is within
    force_ -= race.force;
    moment_ -= race.moment + race.position.cross(race.force);
  }
  if (!has_gravity_) return;
  Vec3 first_moment = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const ElementMass& body = masses_[i];
    Vec3 centre = e.element_centre(i);
    if (body.has_eccentric_mass) centre += e.attitude[i] * body.arm;
    first_moment += body.mass * centre;
    mass += body.mass;
  }
  e.for_integrated_bodies([&](const BodyState& body) {
    first_moment += body.mass * body.centre_of_mass();
    mass += body.mass;
  });
  force_ += mass * gravity_;
  moment_ += first_moment.cross(gravity_);
}

class MomentumAccount final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    const ScenePlan& plan = scene.plan;
    const Vec3 gravity = plan.has(Effect::Gravity) ? scene.bearing.gravity : Vec3(Vec3::Zero());
    masses_ = ElementMasses(scene.bearing);
    scene.block<ExternalActions>(Phase::Account, "momentum ledger", {}, gravity, masses_, force_,
                                 moment_);
    using Momentum = SceneBuilder::Momentum;
    scene.momentum(impulse_, "external.impulse", Momentum::Linear, kImpulse, force_.data());
    scene.momentum(angular_impulse_, "external.angular_impulse", Momentum::Angular, kAngularImpulse,
                   moment_.data());
    scene.want_momentum_ledger();
  }

 private:
  Vec3 force_ = Vec3::Zero(), moment_ = Vec3::Zero();  ///< now [N, N m]
  int impulse_ = -1, angular_impulse_ = -1;
  ElementMasses masses_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_momentum_ledger(const ScenePlan& plan) {
  if (!plan.has(Effect::MomentumLedger)) return nullptr;
  return std::make_unique<MomentumAccount>();
}

}  // namespace adore::dynamics
