#include "dynamics/effects/thermal_steps.hpp"

#include "dynamics/effect_makers.hpp"

namespace adore::dynamics {
namespace {

constexpr LedgerTerm kEnergy{LedgerKind::Switch,
                             "thermal_steps",
                             "energy change by thermal steps",
                             {"changes of geometry and material by thermal steps"},
                             "stored energy after each change of geometry or material minus the "
                             "energy before it, total since the start"};
constexpr LedgerTerm kMomentum{
    LedgerKind::Switch, "", "", {"linear momentum brought by thermal steps"}, ""};
constexpr LedgerTerm kAngularMomentum{
    LedgerKind::Switch, "", "", {"angular momentum brought by thermal steps"}, ""};
constexpr const LedgerTerm* kTerms[] = {&kEnergy};

}  // namespace

void ThermalSteps::declare(SceneBuilder& scene) {
  scene.energy(energy_index_, "thermal.jump", kEnergy, nullptr);
  if (!scene.plan.has(Effect::MomentumLedger)) return;
  using Momentum = SceneBuilder::Momentum;
  scene.momentum(impulse_index_, "thermal.impulse", Momentum::Linear, kMomentum, nullptr);
  scene.momentum(angular_impulse_index_, "thermal.angular_impulse", Momentum::Angular,
                 kAngularMomentum, nullptr);
}

std::unique_ptr<SceneEffect> make_thermal_steps(const ScenePlan& plan) {
  const bearing::RaceMotions& motions = plan.race_motions;  // rings grow with their speed
  const bool grows =
      motions.ramp[0] || motions.ramp[1] || motions.variation[0] || motions.variation[1];
  if (!grows && !plan.has(Effect::ThermalSteps)) return nullptr;
  return std::make_unique<ThermalSteps>();
}
std::span<const LedgerTerm* const> thermal_step_terms() { return kTerms; }

}  // namespace adore::dynamics
