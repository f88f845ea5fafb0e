#include "dynamics/effects/race_balance.hpp"

#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/effects/user_motion.hpp"
#include "dynamics/state_access.hpp"

namespace adore::dynamics {

class RaceBalance::Place final : public EffectBlock {
 public:
  Place(const Slice& centre, BalancedRace& race) : centre_(centre), race_(race) {}
  void apply(Evaluation& e) noexcept override {
    race_.set_time(e.t);
    const Vec3 centre = vector_at(e.y, centre_);
    for (int k = 0; k < 3; ++k)
      if (race_.free()[static_cast<std::size_t>(k)]) e.race[1].position[k] = centre[k];
  }

 private:
  const Slice& centre_;
  BalancedRace& race_;
};

class RaceBalance::Motion final : public EffectBlock {
 public:
  Motion(const Slice& centre, const BalancedRace& race) : centre_(centre), race_(race) {}
  void apply(Evaluation& e) noexcept override {
    Vec3 rate = e.race[1].velocity;
    for (int k = 0; k < 3; ++k)
      if (!race_.free()[static_cast<std::size_t>(k)]) rate[k] = 0.0;
    store_at(e.dydt, centre_, rate);
    e.balance = {race_.load(), race_.load() - race_.residual(e.race[1].force)};
  }

 private:
  const Slice& centre_;
  const BalancedRace& race_;
};

/// The load of ADRX1 is part of the balance.
class RaceBalance::UserLoad final : public EffectBlock {
 public:
  UserLoad(const UserMotion& user, BalancedRace& race) : user_(user), race_(race) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation&) noexcept override {
    Vec3 load = user_.actions().force[1], rate = user_.load_rate();
    for (int k = 0; k < 3; ++k)
      if (!race_.free()[static_cast<std::size_t>(k)]) load[k] = rate[k] = 0.0;
    race_.add_load(load, rate);
  }

 private:
  const UserMotion& user_;
  BalancedRace& race_;
};

void RaceBalance::declare(SceneBuilder& scene) {
  const bearing::StaticConstraints& given = scene.bearing.constraints;
  Vec3 load = Vec3::Zero();
  std::array<bool, 3> free{};
  for (std::size_t k = 0; k < 3; ++k) {
    free[k] = !given.displacement_given[k];
    if (free[k]) load[static_cast<int>(k)] = given.load[k];
  }
  race_.emplace(load, free);
  if (const auto& turning = scene.plan.race_motions.rotating_load_parameters)
    race_->set_rotating_load(turning->fraction[1], turning->speed[1]);
  start_ = scene.find<Races>()->initial_races()[1].position;
  centre_ = scene.state("inner race.centre", "m", 3, ScaleKind::Length, kBorder);
  scene.add_border_body({BodyId::Kind::Race, 1}, *this, centre_);
  scene.block<Place>(Phase::Races, kMotionCost, {}, centre_, *race_);
  if (const UserMotion* user = scene.find<UserMotion>())
    scene.block<UserLoad>(Phase::Kinematics, kMotionCost, {}, *user, *race_);
  scene.block<Motion>(Phase::Motion, kMotionCost, {}, centre_, *race_);
}

void RaceBalance::start(std::span<double> y) const { store_at(y.data(), centre_, start_); }

void RaceBalance::add_rate_contribution(const Evaluation&, std::size_t, const Vec3& force,
                                        const Vec3&, double* row) const noexcept {
  const Vec3 rate = race_->pull(-force - race_->load());
  for (int k = 0; k < 3; ++k) row[k] += rate[k];
}

std::unique_ptr<SceneEffect> make_race_balance(const ScenePlan& plan) {
  if (!plan.has(Effect::RaceBalance)) return nullptr;
  return std::make_unique<RaceBalance>();
}

}  // namespace adore::dynamics
