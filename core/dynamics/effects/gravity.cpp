#include "dynamics/effect_makers.hpp"
#include "scene/ledger_terms.hpp"

/// Weight of balls, cage and free races, and their energy in the field: -m g · position.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kEnergy{LedgerKind::Stored,        "gravity",    "energy in gravity",
                             {"energy in gravity now"}, "stored now", "N"};
constexpr const LedgerTerm* kTerms[] = {&kEnergy};

class BallGravity final : public EffectBlock {
 public:
  explicit BallGravity(const Vec3& weight) : weight_(weight) {}
  void apply(Evaluation& e) noexcept override;

 private:
  Vec3 weight_;  ///< of one ball [N]
};

/// On cage and free races.
class BodyGravity final : public EffectBlock {
 public:
  explicit BodyGravity(const Vec3& gravity) : gravity_(gravity) {}
  void apply(Evaluation& e) noexcept override {
    e.for_integrated([this](BodyState& body) {
      const Vec3 weight = body.inertia.mass * gravity_;
      body.force += weight;
      if (!body.mass_centre.isZero(0.0))
        body.moment += (body.to_base * body.mass_centre).cross(weight);
    });
  }

 private:
  Vec3 gravity_;  ///< [m/s²]
};

void BallGravity::apply(Evaluation& e) noexcept {
  for (std::size_t i = 0; i < e.elements.n; ++i) e.add_force(i, e.to_cylindrical(i, weight_));
}

class Gravity final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    gravity_ = scene.bearing.gravity;
    ball_mass_ = scene.bearing.element_inertia.mass;
    constexpr std::string_view kCost = "gravity";
    scene.block<BallGravity>(Phase::Force, kCost, {}, Vec3(ball_mass_ * gravity_));
    scene.block<BodyGravity>(Phase::Force, kCost, {}, gravity_);
  }

  void store(const Evaluation& e, EnergyLedger& energy) const override {
    double stored = 0.0;
    for (std::size_t i = 0; i < e.elements.n; ++i)
      stored -= ball_mass_ * gravity_.dot(e.element_centre(i));
    e.for_integrated([&](const BodyState& body) {
      stored -= body.inertia.mass * gravity_.dot(body.centre_of_mass());
    });
    energy.accumulate(kEnergy, stored);
  }

 private:
  Vec3 gravity_ = Vec3::Zero();  ///< [m/s²]
  double ball_mass_ = 0.0;       ///< [kg]
};

}  // namespace

std::unique_ptr<SceneEffect> make_gravity(const ScenePlan& plan) {
  if (!plan.has(Effect::Gravity)) return nullptr;
  return std::make_unique<Gravity>();
}
std::span<const LedgerTerm* const> gravity_terms() { return kTerms; }

}  // namespace adore::dynamics
