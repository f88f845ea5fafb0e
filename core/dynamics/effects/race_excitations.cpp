#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/excitations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// Races that move by laws of the time beside their spin (records 9.3 and 9.4, excitations.hpp):
/// each adds to the motion that the race has already, so that laws of several records act together.
/// Limit: of prescribed races.
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
  RacePlaces(const std::array<Vec3, 2>& centre, const bearing::RaceMotions& motions)
      : centre_(centre), vibration_(motions.vibration) {
    if (motions.turning_load)
      load_.emplace(centre, motions.turning_load->fraction, motions.turning_load->speed);
  }
  void apply(Evaluation& e) noexcept override {
    for (std::size_t j = 0; j < 2; ++j) {
      RaceBody& race = e.race[j];
      if (load_) add(race, load_->at(static_cast<int>(j), e.t), centre_[j]);
      if (vibration_[j])
        add(race, vibration(Vec3::Zero(), vibration_[j]->amplitude, vibration_[j]->frequency, e.t),
            Vec3::Zero());
    }
  }

 private:
  static void add(RaceBody& race, const PrescribedMotion& motion, const Vec3& at_rest) noexcept {
    race.position += motion.position - at_rest;
    race.velocity += motion.velocity;
    race.acceleration += motion.acceleration;
  }
  std::array<Vec3, 2> centre_;  ///< static [m]
  std::optional<RotatingLoad> load_;
  std::array<std::optional<bearing::Vibration>, 2> vibration_;
};

/// Speed ramp and variation (9.4A, 9.4B).
class RaceTurns final : public EffectBlock {
 public:
  explicit RaceTurns(const bearing::RaceMotions& motions) : motions_(motions) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t j = 0; j < 2; ++j) {
      RaceBody& race = e.race[j];
      if (const auto& ramp = motions_.ramp[j])
        add(race, ramped_turn(0.0, {ramp->acceleration, ramp->begin, ramp->end}, e.t));
      if (const auto& variation = motions_.variation[j])
        add(race, varying_turn(0.0, variation->amplitude, variation->frequency, e.t));
      race.settle();
    }
  }

 private:
  static void add(RaceBody& race, const PrescribedTurn& turn) noexcept {
    race.speed += turn.speed;
    race.angle += turn.angle;
    race.turn_beyond += turn.angle;
  }
  bearing::RaceMotions motions_;
};

class RaceExcitations final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    motions_ = scene.plan.race_motions;
    for (std::size_t j = 0; j < 2; ++j)
      demand(!motions_.free[j] || !motions_.excited(static_cast<int>(j)),
             "a race moves freely or by a law of the time, not both");
    const Races& races = *scene.find<Races>();
    constexpr std::string_view kCost = "prescribed motion of races";
    if (motions_.turning_load || motions_.vibration[0] || motions_.vibration[1])
      scene.block<RacePlaces>(
          Phase::Races, kCost, {},
          std::array<Vec3, 2>{races.at_rest()[0].position, races.at_rest()[1].position}, motions_);
    if (motions_.ramp[0] || motions_.ramp[1] || motions_.variation[0] || motions_.variation[1])
      scene.block<RaceTurns>(Phase::Races, kCost, {}, motions_);
  }
  [[nodiscard]] bool moves_races() const noexcept override { return true; }

  /// A part of the shortest period; never beyond the next kink of a ramp.
  [[nodiscard]] double longest_step(double t) const override {
    double longest = std::numeric_limits<double>::infinity();
    const auto at_most = [&longest](double step) { longest = std::min(longest, step); };
    for (std::size_t j = 0; j < 2; ++j) {
      if (motions_.vibration[j]) at_most(longest_step_of(motions_.vibration[j]->frequency));
      if (motions_.variation[j]) at_most(longest_step_of(motions_.variation[j]->frequency));
      if (motions_.turning_load)
        at_most(
            longest_step_of(std::abs(motions_.turning_load->speed[j]) / (2.0 * std::numbers::pi)));
      if (const auto& ramp = motions_.ramp[j]; ramp && ramp->end > ramp->begin)
        for (const double kink : {ramp->begin, ramp->end})
          if (kink > t) at_most(kink - t);
    }
    return longest;
  }

 private:
  bearing::RaceMotions motions_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_race_excitations(const ScenePlan& plan) {
  if (!plan.race_motions.excited()) return nullptr;
  return std::make_unique<RaceExcitations>();
}

}  // namespace adore::dynamics
