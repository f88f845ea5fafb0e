#include "dynamics/effect_makers.hpp"
#include "dynamics/element_masses.hpp"
#include "scene/ledger_terms.hpp"

/// Weight of elements, cage and free races, and their energy in the field: -m g · position.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kEnergy{LedgerKind::Stored,        "gravity",    "potential energy of gravity",
                             {"energy in gravity now"}, "stored now", "N"};
constexpr const LedgerTerm* kTerms[] = {&kEnergy};

class ElementGravity final : public EffectBlock {
 public:
  ElementGravity(const Vec3& gravity, const ElementMasses& masses)
      : gravity_(gravity), masses_(masses) {}
  void apply(Evaluation& e) noexcept override;

 private:
  Vec3 gravity_;  ///< [m/s²]
  const ElementMasses& masses_;
};

/// On cage and free races.
class BodyGravity final : public EffectBlock {
 public:
  explicit BodyGravity(const Vec3& gravity) : gravity_(gravity) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation& e) noexcept override {
    e.for_integrated_bodies([this](BodyState& body) {
      const Vec3 weight = body.mass * gravity_;
      body.force += weight;
      if (!body.mass_centre.isZero(0.0))
        body.moment += (body.to_base * body.mass_centre).cross(weight);
    });
  }

 private:
  Vec3 gravity_;  ///< [m/s²]
};

void ElementGravity::apply(Evaluation& e) noexcept {
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const ElementMass& body = masses_[i];
    const Vec3 weight = body.mass * gravity_;
    e.add_force(i, e.to_cylindrical(i, weight));
    if (body.has_eccentric_mass)
      e.add_moment(i, e.to_cylindrical(i, Vec3(e.attitude[i] * body.arm).cross(weight)));
  }
}

class Gravity final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    gravity_ = scene.bearing.gravity;
    masses_ = ElementMasses(scene.bearing);
    constexpr std::string_view kCost = "gravity";
    scene.block<ElementGravity>(Phase::Force, kCost, {}, gravity_, masses_);
    scene.block<BodyGravity>(Phase::Force, kCost, {}, gravity_);
  }

  void store(const Evaluation& e, EnergyLedger& energy) const override {
    double stored = 0.0;
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      Vec3 centre = e.element_centre(i);
      if (masses_[i].has_eccentric_mass) centre += e.attitude[i] * masses_[i].arm;
      stored -= masses_[i].mass * gravity_.dot(centre);
    }
    e.for_integrated_bodies(
        [&](const BodyState& body) { stored -= body.mass * gravity_.dot(body.centre_of_mass()); });
    energy.accumulate(kEnergy, stored);
  }

 private:
  Vec3 gravity_ = Vec3::Zero();  ///< [m/s²]
  ElementMasses masses_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_gravity(const ScenePlan& plan) {
  if (!plan.has(Effect::Gravity)) return nullptr;
  return std::make_unique<Gravity>();
}
std::span<const LedgerTerm* const> gravity_terms() { return kTerms; }

}  // namespace adore::dynamics
