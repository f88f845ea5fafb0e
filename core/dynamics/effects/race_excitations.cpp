#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/excitations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// Races that move by laws of time in addition to their spin (records 9.3 and 9.4,
/// excitations.hpp): each adds to the present motion of the race, so that laws of several records
/// act together. Held directions of a free race follow the same laws by their accelerations
/// (free_races.cpp).
namespace adore::dynamics {
namespace {

/// Steps per period that resolve a law whose error the method may not see.
constexpr double kStepsPerPeriod = 20.0;

double longest_step_of(double frequency) {
  return frequency > 0.0 ? 1.0 / (kStepsPerPeriod * frequency)
                         : std::numeric_limits<double>::infinity();
}

/// Rotating load and vibration (9.3A, 9.3B).
class RacePlaces final : public EffectBlock {
 public:
  explicit RacePlaces(const RaceMotionLaws& laws) : laws_(laws) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t j = 0; j < 2; ++j) {
      RaceBody& race = e.race[j];
      if (race.moves == Moves::Integrated) continue;
      const PrescribedMotion motion = laws_.place(static_cast<int>(j), e.t);
      race.position += motion.position;
      race.velocity += motion.velocity;
      race.acceleration += motion.acceleration;
    }
  }

 private:
  const RaceMotionLaws& laws_;
};

/// Speed ramp and variation (9.4A, 9.4B).
class RaceTurns final : public EffectBlock {
 public:
  explicit RaceTurns(const RaceMotionLaws& laws) : laws_(laws) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t j = 0; j < 2; ++j) {
      RaceBody& race = e.race[j];
      if (race.moves == Moves::Integrated) continue;
      const PrescribedRotation turn = laws_.turn(static_cast<int>(j), e.t);
      race.speed += turn.speed;
      race.angle += turn.angle;
      race.turn_beyond += turn.angle;
      race.settle();
    }
  }

 private:
  const RaceMotionLaws& laws_;
};

class RaceExcitations final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    motions_ = scene.plan.race_motions;
    if (motions_.rotating_load_parameters && scene.plan.has(Effect::RaceBalance))
      motions_.rotating_load_parameters->fraction[1] =
          0.0;                           // the load itself turns (race_balance.hpp)
    for (std::size_t j = 0; j < 2; ++j)  // and so does that of a free race (free_races.cpp)
      if (const auto& free = motions_.free[j]; motions_.rotating_load_parameters && free &&
                                               !free->translation_held[1] &&
                                               !free->translation_held[2])
        motions_.rotating_load_parameters->fraction[j] = 0.0;
    const Races& races = *scene.find<Races>();
    laws_.emplace(
        std::array<Vec3, 2>{races.initial_races()[0].position, races.initial_races()[1].position},
        motions_);
    constexpr std::string_view kCost = "prescribed motion of races";
    if (laws_->has_center_motion()) scene.block<RacePlaces>(Phase::Races, kCost, {}, *laws_);
    if (laws_->turns()) scene.block<RaceTurns>(Phase::Races, kCost, {}, *laws_);
  }
  [[nodiscard]] bool moves_races() const noexcept override { return true; }
  void prescribe(double t, PrescribedRaces& races) const override {
    for (int j = 0; j < 2; ++j) {
      PrescribedRace& race = races[static_cast<std::size_t>(j)];
      const PrescribedMotion place = laws_->place(j, t);
      race.position += place.position;
      race.velocity += place.velocity;
      race.speed += laws_->turn(j, t).speed;
    }
  }

  /// A part of the shortest period; never beyond the next kink of a ramp.
  [[nodiscard]] double longest_step(double t) const override {
    double longest = std::numeric_limits<double>::infinity();
    const auto at_most = [&longest](double step) { longest = std::min(longest, step); };
    for (std::size_t j = 0; j < 2; ++j) {
      if (motions_.vibration[j]) at_most(longest_step_of(motions_.vibration[j]->frequency));
      if (motions_.variation[j]) at_most(longest_step_of(motions_.variation[j]->frequency));
      if (motions_.rotating_load_parameters)
        at_most(longest_step_of(std::abs(motions_.rotating_load_parameters->speed[j]) /
                                (2.0 * std::numbers::pi)));
      if (const auto& ramp = motions_.ramp[j]; ramp && ramp->end > ramp->begin)
        for (const double kink : {ramp->begin, ramp->end})
          if (kink > t) at_most(kink - t);
    }
    return longest;
  }

 private:
  bearing::RaceMotions motions_;
  std::optional<RaceMotionLaws> laws_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_race_excitations(const ScenePlan& plan) {
  if (!plan.race_motions.has_excitation()) return nullptr;
  return std::make_unique<RaceExcitations>();
}

}  // namespace adore::dynamics
