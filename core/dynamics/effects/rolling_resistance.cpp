#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/races.hpp"

#include <array>
#include <vector>

/// Rolling resistance of the oil in the inlets of elements and races (pressure moment of the
/// inlet): the force F of tribology/laws/rolling_resistance.hpp at the load, ellipse or line, speed
/// and slip of this instant, the same as in an equilibrium's friction. With t along the
/// entrainment, n into the race, r the element's radius and 1/R the curvature of both bodies
///   on the element  (2 R/r - 1) F t at its centre,  r n × (-F t) about it;
///   on the race     the opposite wrench, which is -F t at its surface and 2 F R/r_race t through
///                   its centre of curvature.
/// Both bodies are held back; the power, 2 F u where both surfaces move with u, is an item of its
/// own in the ledger and heats the race in thermal steps. Rollers: slice by slice with their line
/// force, by the kernel of their traction, whose films it needs (statics/film_on_slices.hpp). Not
/// here: roller ends on flanges (traction of record 10.2 alone, as in equilibria), pockets and
/// lands (films of their own).
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHeat{
    LedgerKind::Heat,
    "rolling_heat",
    "rolling resistance at the races",
    {"rolling resistance at the outer race", "rolling resistance at the inner race"},
    "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHeat};

class BallRolling final : public EffectBlock {
 public:
  /// @param second other half of a split race; null: not split
  BallRolling(const RaceContactModel& model, const RaceContactModel* second,
              const tribology::RollingResistance& law, std::size_t balls, double& heat)
      : model_(model), second_(second), law_(law), heat_(heat), scratch_(balls) {}
  void apply(Evaluation& e) noexcept override {
    RaceBody& race = e.race[static_cast<std::size_t>(model_.race)];
    const ElementForces out =
        element_force_targets(e.actions, scratch_.data(), scratch_.data(), nullptr);
    const RaceSums sums = evaluate_race_rolling(model_, law_, e.elements, race.motion(), out);
    race.force += sums.force;
    race.moment += sums.moment;
    heat_ = sums.heat;
    if (second_ == nullptr) return;
    const RaceSums more = evaluate_race_rolling(*second_, law_, e.elements, race.motion(), out);
    race.force += more.force;
    race.moment += more.moment;
    heat_ += more.heat;
  }

 private:
  const RaceContactModel& model_;
  const RaceContactModel* second_;
  const tribology::RollingResistance& law_;
  double& heat_;
  std::vector<double> scratch_;  ///< loads and heats of the kernel's last vector
};

class Rolling final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    Races& races = *scene.find<Races>();
    const auto elements = static_cast<std::size_t>(scene.bearing.element_count());
    constexpr std::array kNames{"outer race.rolling", "inner race.rolling"};
    for (std::size_t j = 0; j < 2; ++j) {
      const BodyId race{BodyId::Kind::Race, static_cast<int>(j)};
      constexpr std::string_view kCost = "rolling resistance";
      const double* heat = &heat_[j];
      if (races.roller_contacts() != nullptr) {
        heat = &races.account(j).rolling;
        if (!(*races.roller_contacts())[j]
                 .rolling_uses_traction_film())  // else in the kernel of the traction
          scene.block<RollerRaceRolling>(Phase::Force, kCost, race, (*races.roller_contacts())[j],
                                         elements, races.account(j));
      } else
        scene.block<BallRolling>(Phase::Force, kCost, race, races.contacts()[j],
                                 races.second()[j] ? &*races.second()[j] : nullptr,
                                 races.rolling()[j], elements, heat_[j]);
      scene.energy(kNames[j], kHeat, heat, static_cast<int>(j));
    }
  }

 private:
  std::array<double, 2> heat_{};  ///< now [W]
};

}  // namespace

std::unique_ptr<SceneEffect> make_rolling_resistance(const ScenePlan& plan) {
  if (!plan.has(Effect::RollingResistance)) return nullptr;
  return std::make_unique<Rolling>();
}
std::span<const LedgerTerm* const> rolling_resistance_terms() { return kTerms; }

}  // namespace adore::dynamics
