#include "dynamics/effects/contact_damping.hpp"

#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/effects/scene_pieces.hpp"

#include <algorithm>
#include <array>

/// Material damping of elastic contacts [huntcrossley1975]: of elements and races, in pockets, at
/// guide lands and flanges:
///   F = Q (1 + d δ̇),  d = 3/2 α,  never below 0
/// with the elastic load Q (K δ^1.5 of balls, K_s δ^(10/9) of each slice of a roller), δ̇ the rate
/// of approach and the user's α [s/m] (run option contactDamping). Heat Q d δ̇² (Q |δ̇| where the
/// bracket is held at 0) is an item of its own in the ledger. It acts along the gradient of δ, on
/// the element and, opposite, on the race.
/// From m v dv/dδ = -Q (1 + d v), whatever Q(δ): an element that meets a wall at v leaves it at e
/// v,
///   d v (1 + e) = ln((1 + d v)/(1 - d e v)),   e = 1 - α v for small v      [derived, test]
/// A vibration δ0 + ε e^(iωt) under a steady load Q decays at rate Q d/(2 m) per contact: 1.5 α in
/// front of loads, so that a heavily loaded contact is damped as an impact that reaches its load.
/// α of steel, bronze and ivory is 0.08 to 0.32 s/m [huntcrossley1975].
/// Pockets, lands and flanges have it where a routine of the user could make their forces
/// (user_forces.hpp): friction and stored forces go with the damped force there, and what damping
/// takes of them all is one item of the ledger. -d(gap)/dt is δ̇.
/// Limits: one relation for impacts below yield; oil films damp more and otherwise. On races
/// traction, pressures, life and stored loads are of the elastic load. Elements in balance (modes
/// 1, 2 and qFac) have no rate of approach and are refused with it. Elastic stay: neighbours in a
/// bearing without cage, lands with shape errors, and contacts whose force is the user's.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHeat{LedgerKind::Heat,
                           "contact_damping",
                           "damping of the race contacts",
                           {"damping at the outer race", "damping at the inner race"},
                           "dissipated since the start"};
constexpr LedgerTerm kHeatBeside{LedgerKind::Heat,
                                 "damping_beside",
                                 "damping in pockets, at guide lands and flanges",
                                 {"damping in pockets, at lands and flanges"},
                                 "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHeat, &kHeatBeside};
constexpr std::string_view kCostBeside = "damping beside the races";

class BallDamping final : public EffectBlock {
 public:
  BallDamping(const RaceContactModel& model, double damping, double& heat)
      : model_(model), damping_(damping), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    const auto j = static_cast<std::size_t>(model_.race);
    RaceBody& race = e.race[j];
    const RaceMotion motion = race.motion();
    heat_ = 0.0;
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const double load = e.load[j][i];
      if (!(load > 0.0)) continue;
      const Vec3 gradient = approach_gradient(model_.of(i), e.elements, i, motion);
      const Vec3 centre = e.element_centre(i);
      const double rate = gradient.dot(e.element_velocity(i) - race.velocity_at(centre));
      const double more = load * std::max(damping_ * rate, -1.0);
      const Vec3 on_race = more * gradient;
      e.add_force(i, e.to_cylindrical(i, -on_race));
      race.add_force(on_race, centre);
      heat_ += more * rate;
    }
  }

 private:
  const RaceContactModel& model_;
  double damping_;  ///< d [s/m]
  double& heat_;
};

constexpr std::string_view kCost = "damping of the race contacts";

}  // namespace

void ContactDamping::declare(SceneBuilder& scene) {
  const Races& races = *scene.find<Races>();
  const double d = 1.5 * scene.options.contact_damping;
  constexpr std::array kNames{"outer race.damping", "inner race.damping"};
  for (std::size_t j = 0; j < 2; ++j) {
    const BodyId race{BodyId::Kind::Race, static_cast<int>(j)};
    if (races.roller_contacts() != nullptr)
      scene.block<RollerRaceDamping>(Phase::Force, kCost, race, (*races.roller_contacts())[j],
                                     static_cast<std::size_t>(scene.bearing.element_count()), d,
                                     heat_[j]);
    else
      scene.block<BallDamping>(Phase::Force, kCost, race, races.contacts()[j], d, heat_[j]);
    scene.energy(kNames[j], kHeat, &heat_[j], static_cast<int>(j));
  }
  law_.set(d);
  const bearing::RollerGeometry* rollers = scene.bearing.rollers();
  const bool flanges = rollers != nullptr && (rollers->has_flange(0) || rollers->has_flange(1));
  if (!scene.bearing.cage && !flanges) return;  // nothing beside the races
  scene.block<NoHeatYet>(Phase::Force, kCostBeside, {}, heat_beside_races_);
  scene.energy("contacts beside the races.damping", kHeatBeside, &heat_beside_races_);
}

OtherForce other_force(const SceneBuilder& scene, scene::UserForce* user, std::string_view cost) {
  if (user != nullptr) return {user, nullptr, true, cost};
  if (ContactDamping* damping = scene.find<ContactDamping>())
    return {&damping->law(), &damping->heat_beside_races(), false, kCostBeside};
  return {};
}

std::unique_ptr<SceneEffect> make_contact_damping(const ScenePlan& plan) {
  if (!plan.has(Effect::ContactDamping)) return nullptr;
  return std::make_unique<ContactDamping>();
}
std::span<const LedgerTerm* const> contact_damping_terms() { return kTerms; }

}  // namespace adore::dynamics
