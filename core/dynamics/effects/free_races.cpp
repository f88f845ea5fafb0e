#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/free_body.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/effects/user_motion.hpp"
#include "dynamics/excitations.hpp"
#include "scene/ledger_terms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

/// Races that move under what acts on them and under their loads: Newton and Euler about the mass
/// center (free_body.hpp). A share of the radial load of a race that is free along y and z may turn
/// about x (record 9.3A): F(t) = F + share (turn(ω t) - 1) F_radial; the rest is constant.
/// Directions may be held: they keep the velocity of their start or follow the laws of records 9.3
/// and 9.4 (excitations.hpp), whose accelerations are prescribed there (rigid_body.hpp,
/// race_accelerations); what holds them does work like a load. A race whose rotations across its
/// axis are held turns about the axis that it has at the start. The contact kernel sees ω as spin
/// about the race's axis and the rest across it. Limit: the groove stays one of revolution about
/// the race's axis.
/// Routine ADRX1 of the user (user_motion.hpp) adds to loads, and gives the accelerations of the
/// held directions of races that it drives, in the place of those laws. Its load along held
/// directions is carried by what holds the race.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kWork{
    LedgerKind::Work,
    "load_work",
    "work of the loads on races that are free to move",
    {"work of the loads on the outer race", "work of the loads on the inner race"},
    "work of applied forces and of reactions of the supports, since the start"};
constexpr const LedgerTerm* kTerms[] = {&kWork};
constexpr LedgerTerm kImpulse{LedgerKind::Work, "", "", {"impulse of the loads on free races"}, ""};
constexpr LedgerTerm kAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse of the loads on free races"}, ""};

/// One free race with its load.
struct Loaded {
  FreeBody body;
  int race = 0;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< now, at the race's center [N, N m]
  Vec3 first_force = Vec3::Zero();                   ///< at t = 0 [N]
  double turning_share = 0.0, turning_speed = 0.0;   ///< of the radial load [-, rad/s]
  std::optional<RaceMotionLaws> laws;                ///< of the held directions
  Vec3 free_along = Vec3::Zero(), free_about = Vec3::Zero();   ///< 1 where the race is free
  Vec3 user_force = Vec3::Zero(), user_moment = Vec3::Zero();  ///< of ADRX1, now [N, N m]
  // Now, with what holds the held directions: power [W], about the base origin [N, N m].
  double power = 0.0;
  Vec3 outer_force = Vec3::Zero(), outer_moment = Vec3::Zero();
  int impulse = -1, angular_impulse = -1;  ///< in the state
};

class RaceKinematics final : public EffectBlock {
 public:
  explicit RaceKinematics(const Loaded& loaded) : loaded_(loaded) {}
  void apply(Evaluation& e) noexcept override {
    RaceBody& race = e.race[static_cast<std::size_t>(loaded_.race)];
    loaded_.body.read(e.y, race);
    race.speed = race.omega.dot(race.axis());
    race.tilt = race.omega - race.speed * race.axis();
    race.angle = loaded_.body.integrated_rotation(e.y);
    race.turn_beyond = 0.0;
  }

 private:
  const Loaded& loaded_;
};

class RaceLoad final : public EffectBlock {
 public:
  explicit RaceLoad(Loaded& loaded) : loaded_(loaded) {}
  void apply(Evaluation& e) noexcept override {
    if (loaded_.turning_share != 0.0) {
      const double turn = loaded_.turning_speed * e.t;
      const double c = std::cos(turn) - 1.0, s = std::sin(turn);
      const Vec3& F = loaded_.first_force;
      loaded_.force =
          F + loaded_.turning_share * Vec3(0.0, c * F[1] - s * F[2], s * F[1] + c * F[2]);
    }
    RaceBody& race = e.race[static_cast<std::size_t>(loaded_.race)];
    race.add_force(loaded_.force + loaded_.user_force, race.position);
    race.moment += loaded_.moment + loaded_.user_moment;
  }

 private:
  Loaded& loaded_;
};

class HeldDirections final : public EffectBlock {
 public:
  explicit HeldDirections(Loaded& loaded) : loaded_(loaded) {}
  void apply(Evaluation& e) noexcept override {
    loaded_.body.prescribe(loaded_.laws->place(loaded_.race, e.t).acceleration,
                           loaded_.laws->turn(loaded_.race, e.t).acceleration * Vec3::UnitX());
  }

 private:
  Loaded& loaded_;
};

class LoadAccount final : public EffectBlock {
 public:
  LoadAccount(Loaded& loaded, RaceContactTotals& account) : loaded_(loaded), account_(account) {}
  void apply(Evaluation& e) noexcept override {
    const RaceBody& race = e.race[static_cast<std::size_t>(loaded_.race)];
    const Vec3 force = loaded_.force + loaded_.user_force + loaded_.body.holding_force();
    const Vec3 moment = loaded_.moment + loaded_.user_moment + loaded_.body.holding_moment();
    loaded_.power = force.dot(race.velocity) + moment.dot(race.omega);
    account_.keep(force, moment);
    loaded_.outer_force = force;
    loaded_.outer_moment = moment + race.position.cross(force);
  }

 private:
  Loaded& loaded_;
  RaceContactTotals& account_;
};

/// Takes what ADRX1 says of races that are integrated.
class TakeUser final : public EffectBlock {
 public:
  TakeUser(const UserMotion& user, std::vector<Loaded>& loaded) : user_(user), loaded_(loaded) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation&) noexcept override {
    const scene::UserMotion::Actions& actions = user_.actions();
    for (Loaded& one : loaded_) {
      const auto j = static_cast<std::size_t>(one.race);
      one.user_force = actions.force[j];
      one.user_moment = actions.moment[j];
      if (user_.motion_declaration().drives[j])
        one.body.prescribe(actions.acceleration[j], actions.angular_acceleration[j]);
    }
  }

 private:
  const UserMotion& user_;
  std::vector<Loaded>& loaded_;
};

/// Held directions take the difference of what was and what is prescribed there.
void shift_held(const Loaded& one, const RaceBody& start, const PrescribedRace& before,
                const PrescribedRace& now, std::span<double> y) {
  constexpr double kRounding = 1e-12;
  const auto part = [&](const Vec3& was, const Vec3& is, const Vec3& free, double scale) {
    Vec3 out = (is - was).cwiseProduct(Vec3::Ones() - free);
    for (int k = 0; k < 3; ++k)
      if (std::abs(out[k]) <= kRounding * scale) out[k] = 0.0;
    return out;
  };
  const Vec3 along = part(before.position, now.position, one.free_along, 1.0);
  const Vec3 velocity = part(before.velocity, now.velocity, one.free_along,
                             before.velocity.norm() + now.velocity.norm());
  const double speed = part(Vec3(before.speed, 0.0, 0.0), Vec3(now.speed, 0.0, 0.0), one.free_about,
                            std::abs(before.speed) + std::abs(now.speed))[0];
  const Quat turn = multiply(now.attitude, {before.attitude[0], -before.attitude[1],
                                            -before.attitude[2], -before.attitude[3]});
  const Vec3 tilt = part(Vec3::Zero(), {0.0, turn[2], turn[3]}, one.free_about, 1.0);
  if (along.isZero(0.0) && velocity.isZero(0.0) && speed == 0.0 && tilt.isZero(0.0)) return;
  RaceBody race = start;
  one.body.read(y.data(), race);
  const Quat tilted{std::sqrt(1.0 - tilt.squaredNorm()), 0.0, tilt[1], tilt[2]};
  race.position += along;
  race.velocity += velocity;
  race.omega = rotation_matrix(tilted) * race.omega + speed * start.axis();
  race.set_attitude(multiply(tilted, race.attitude));
  one.body.start(y, race.centre_of_mass(), race.velocity_at(race.centre_of_mass()), race.attitude,
                 race.to_base.transpose() * race.omega);
}

class FreeRaces final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    user_ = scene.find<UserMotion>();
    Races& races = *scene.find<Races>();
    const auto& free = scene.plan.race_motions.free;
    loaded_.reserve(free.size());  // blocks and border know them by address
    if (user_ != nullptr)
      scene.block<TakeUser>(Phase::Force, "user routine ADRX1", {}, *user_, loaded_);
    for (std::size_t j = 0; j < free.size(); ++j) {
      if (!free[j]) continue;
      Loaded& one = loaded_.emplace_back();
      const std::string name = j == 0 ? "outer race" : "inner race";
      one.race = static_cast<int>(j);
      one.force = one.first_force = free[j]->force;
      if (const auto& turning = scene.plan.race_motions.rotating_load_parameters;
          turning && !free[j]->translation_held[1] && !free[j]->translation_held[2]) {
        one.turning_share = turning->fraction[j];
        one.turning_speed = turning->speed[j];
      }
      one.moment = free[j]->moment;
      one.body.declare(scene, {BodyId::Kind::Race, one.race}, name, scene.bearing.race_inertia[j]);
      RaceBody& start = start_.emplace_back(races.initial_races()[j]);
      start.mass_centre = -scene.bearing.race_inertia[j].geometric_centre;
      const auto& [translation, rotation] =
          std::tie(free[j]->translation_held, free[j]->rotation_held);
      const auto held = [](const std::array<bool, 3>& flags) {
        return flags[0] || flags[1] || flags[2];
      };
      for (int k = 0; k < 3; ++k) {
        one.free_along[k] = translation[static_cast<std::size_t>(k)] ? 0.0 : 1.0;
        one.free_about[k] = rotation[static_cast<std::size_t>(k)] ? 0.0 : 1.0;
      }
      const bool driven = user_ != nullptr && user_->motion_declaration().drives[j];
      if (driven) {
        one.body.constrain({translation, rotation}, start.to_base);
        start.velocity += user_->motion_declaration().start_velocity[j];
        start.speed += user_->motion_declaration().start_spin[j];
        start.settle();
      } else if (held(translation) || held(rotation)) {
        one.body.constrain({translation, rotation}, start.to_base);
        if (scene.plan.race_motions.has_excitation(one.race)) {
          one.laws.emplace(std::array<Vec3, 2>{races.initial_races()[0].position,
                                               races.initial_races()[1].position},
                           scene.plan.race_motions);
          const Vec3 velocity = one.laws->place(one.race, 0.0).velocity;
          for (std::size_t k = 0; k < 3; ++k)
            if (translation[k]) start.velocity[static_cast<int>(k)] = velocity[static_cast<int>(k)];
          scene.block<HeldDirections>(Phase::Motion, kMotionCost, {}, one);
        }
      }
      scene.block<RaceKinematics>(Phase::Races, kMotionCost, {}, one);
      scene.block<RaceLoad>(Phase::Force, kMotionCost, {}, one);
      scene.block<BodyMotion>(Phase::Motion, kMotionCost, {}, one.body);
      scene.block<LoadAccount>(Phase::Account, kMotionCost, {}, one, races.account(j));
      scene.energy(name + ".load_work", kWork, &one.power, one.race);
      if (!scene.plan.has(Effect::MomentumLedger)) continue;
      using Momentum = SceneBuilder::Momentum;
      scene.momentum(one.impulse, name + ".impulse", Momentum::Linear, kImpulse,
                     one.outer_force.data());
      scene.momentum(one.angular_impulse, name + ".angular_impulse", Momentum::Angular,
                     kAngularImpulse, one.outer_moment.data());
    }
  }

  void start(std::span<double> y) const override {
    for (std::size_t k = 0; k < loaded_.size(); ++k) {
      const RaceBody& race = start_[k];
      const Vec3 centre = race.centre_of_mass();
      loaded_[k].body.start(y, centre, race.velocity_at(centre), race.attitude,
                            race.to_base.transpose() * race.omega);
    }
  }

  void go_on(const PrescribedRaces& before, const PrescribedRaces& now,
             std::span<double> y) override {
    for (Loaded& one : loaded_) {
      const auto j = static_cast<std::size_t>(one.race);
      if (user_ == nullptr || !user_->motion_declaration().drives[j])
        shift_held(one, start_[static_cast<std::size_t>(&one - loaded_.data())], before[j], now[j],
                   y);
    }
  }

  void store(const Evaluation& e, EnergyLedger& energy) const override {
    for (const Loaded& one : loaded_)
      energy.accumulate(terms::kKinetic, one.body.kinetic_energy(one.body.state(e)));
  }

  void carry(const Evaluation& e, Momenta& momenta) const override {
    for (const Loaded& one : loaded_) one.body.carry(one.body.state(e), momenta);
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (const Loaded& one : loaded_) {
      RaceSnapshot& race = snapshot.races[static_cast<std::size_t>(one.race)];
      const Vec3 displacement = race.position;  // from its free position, not from the base origin
      one.body.report(e, race);
      race.position = displacement;
      race.applied_force =
          one.force + one.user_force.cwiseProduct(one.free_along) + one.body.holding_force();
      race.applied_moment =
          one.moment + one.user_moment.cwiseProduct(one.free_about) + one.body.holding_moment();
      // The sum on the race has its load in it, too; its own weight stays out of what is carried.
      race.carried_force = one.force + one.user_force - one.body.state(e).force;
    }
  }

 private:
  const UserMotion* user_ = nullptr;  ///< ADRX1; null: none
  std::vector<Loaded> loaded_;
  std::vector<RaceBody> start_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_free_races(const ScenePlan& plan) {
  const auto& free = plan.race_motions.free;
  if (!free[0] && !free[1]) return nullptr;
  return std::make_unique<FreeRaces>();
}
std::span<const LedgerTerm* const> free_race_terms() { return kTerms; }

}  // namespace adore::dynamics
