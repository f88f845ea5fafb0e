#include "dynamics/effects/user_motion.hpp"

#include "base/errors.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/state_access.hpp"
#include "scene/ledger_terms.hpp"

#include <algorithm>
#include <limits>

namespace adore::dynamics {
namespace {

constexpr std::string_view kCost = "user routine ADRX1";
constexpr LedgerTerm kFrameWork{
    LedgerKind::Work,
    "frame_work",
    "work of the base frame moved by user routine ADRX1",
    {"work of the moving base frame"},
    "work of the inertia forces of the moving frame on all bodies, since the start"};
constexpr LedgerTerm kHeldWork{
    LedgerKind::Work,
    "user_load_work",
    "work of the loads of user routine ADRX1 along prescribed motions of races",
    {"work of user loads on held races"},
    "work of the loads of user routine ADRX1 that the supports of the races carry, since the "
    "start"};
constexpr const LedgerTerm* kTerms[] = {&kFrameWork, &kHeldWork};
constexpr LedgerTerm kFrameImpulse{
    LedgerKind::Work, "", "", {"impulse of the moving base frame"}, ""};
constexpr LedgerTerm kFrameAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse of the moving base frame"}, ""};
constexpr LedgerTerm kHeldImpulse{
    LedgerKind::Work, "", "", {"impulse of user loads on held races"}, ""};
constexpr LedgerTerm kHeldAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse of user loads on held races"}, ""};

/// -I Ω̇ and what turns Euler's equations for ω + Ω into equations for ω; I in base axes.
Vec3 frame_moment(const Mat3& I, const Vec3& omega, const Vec3& frame, const Vec3& turn) noexcept {
  const Vec3 whole = omega + frame;
  return I * (omega.cross(frame) - turn) - whole.cross(Vec3(I * whole)) +
         omega.cross(Vec3(I * omega));
}

}  // namespace

class UserMotion::CallRoutine final : public EffectBlock {
 public:
  explicit CallRoutine(UserMotion& of) : of_(of) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation& e) noexcept override {
    std::array<scene::UserMotion::Race, 2> races;
    for (std::size_t j = 0; j < 2; ++j)
      races[j] = {e.race[j].position - of_.unloaded_race_centers_[j], e.race[j].velocity,
                  e.race[j].omega, e.race[j].angle};
    e.valid = of_.routine_->evaluate(e.t, races, of_.actions_) && e.valid;
    if (!of_.has_balanced_race_) return;
    // The balance moves with its load: its rate by a difference, of a race that stays.
    constexpr double kStep = 1e-7;  // [s]
    scene::UserMotion::Actions later;
    e.valid = of_.routine_->evaluate(e.t + kStep, races, later) && e.valid;
    of_.load_rate_ = (later.force[1] - of_.actions_.force[1]) / kStep;
  }

 private:
  UserMotion& of_;
};

class UserMotion::FrameForces final : public EffectBlock {
 public:
  explicit FrameForces(UserMotion& of) : of_(of) {}
  void apply(Evaluation& e) noexcept override { of_.apply_frame_forces(e); }

 private:
  UserMotion& of_;
};

void UserMotion::apply_frame_forces(Evaluation& e) noexcept {
  frame_power_ = 0.0;
  frame_force_.setZero();
  frame_moment_.setZero();
  const Vec3 &A = actions_.frame, &Omega = actions_.frame_omega, &turn = actions_.frame_turn;
  const bool turns = !Omega.isZero(0.0) || !turn.isZero(0.0);
  const auto force_on = [&](double mass, const Vec3& centre, const Vec3& velocity) -> Vec3 {
    if (!turns) return -mass * A;
    return -mass * (A + turn.cross(centre) + Omega.cross(Omega.cross(centre)) +
                    2.0 * Omega.cross(velocity));
  };
  const auto book = [this](const Vec3& force, const Vec3& moment, const Vec3& centre,
                           const Vec3& velocity, const Vec3& omega) {
    frame_power_ += force.dot(velocity) + moment.dot(omega);
    frame_force_ += force;
    frame_moment_ += moment + centre.cross(force);
  };
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const ElementMass& body = masses_[i];
    Vec3 centre = e.element_centre(i), velocity = e.element_velocity(i);
    const Vec3 omega = e.element_omega(i);
    Vec3 arm = Vec3::Zero(), moment = Vec3::Zero();
    if (body.has_eccentric_mass) {
      arm = e.attitude[i] * body.arm;
      centre += arm;
      velocity += omega.cross(arm);
    }
    const Vec3 force = force_on(body.mass, centre, velocity);
    if (turns) {
      Mat3 I = body.inertia;
      if (!e.attitude.empty()) I = e.attitude[i] * I * e.attitude[i].transpose();
      moment = frame_moment(I, omega, Omega, turn);
    }
    e.add_force(i, e.to_cylindrical(i, force));
    if (turns || body.has_eccentric_mass)
      e.add_moment(i, e.to_cylindrical(i, Vec3(moment + arm.cross(force))));
    book(force, moment, centre, velocity, omega);
  }
  e.for_integrated_bodies([&](BodyState& body) {
    const Vec3 centre = body.centre_of_mass(), velocity = body.velocity_at(centre);
    const Vec3 force = force_on(body.mass, centre, velocity);
    Vec3 moment = Vec3::Zero();
    if (turns) {
      moment = frame_moment(body.to_base * body.inertia * body.to_base.transpose(), body.omega,
                            Omega, turn);
      body.moment += moment;
    }
    body.add_force(force, centre);
    book(force, moment, centre, velocity, body.omega);
  });
}

Vec3 UserMotion::supported_force(const Evaluation& e, std::size_t j) const noexcept {
  if (e.race[j].moves == Moves::Integrated) return Vec3::Zero();
  if (!has_balanced_race_ || j == 0) return actions_.force[j];
  return actions_.force[j].cwiseProduct(Vec3::Ones() - balanced_directions_);
}
Vec3 UserMotion::supported_moment(const Evaluation& e, std::size_t j) const noexcept {
  return e.race[j].moves == Moves::Integrated ? Vec3(Vec3::Zero()) : actions_.moment[j];
}

/// Loads that supports carry act on the race, too: what holds it is the opposite of all.
class UserMotion::SupportedLoads final : public EffectBlock {
 public:
  explicit SupportedLoads(UserMotion& of) : of_(of) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation& e) noexcept override {
    of_.supported_force_.setZero();
    of_.supported_moment_.setZero();
    for (std::size_t j = 0; j < 2; ++j) {
      const Vec3 force = of_.supported_force(e, j), moment = of_.supported_moment(e, j);
      e.race[j].force += force;
      e.race[j].moment += moment;
      of_.supported_force_ += force;
      of_.supported_moment_ += moment + e.race[j].position.cross(force);
    }
  }

 private:
  UserMotion& of_;
};

class UserMotion::SupportedLoadWork final : public EffectBlock {
 public:
  explicit SupportedLoadWork(UserMotion& of) : of_(of) {}
  void apply(Evaluation& e) noexcept override {
    of_.supported_load_power_ = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const RaceBody& race = e.race[j];
      const Vec3 moment = of_.supported_moment(e, j);
      of_.supported_load_power_ += of_.supported_force(e, j).dot(race.velocity) +
                                   race.speed * moment.dot(race.axis()) + moment.dot(race.tilt);
    }
  }

 private:
  UserMotion& of_;
};

/// An inner race that its load places and ADRX1 drives.
class UserMotion::DrivenRaceMotion final : public EffectBlock {
 public:
  explicit DrivenRaceMotion(const UserMotion& of) : of_(of) {}
  void apply(Evaluation& e) noexcept override {
    RaceBody& race = e.race[1];
    race.position += vector_at(e.y, of_.place_);
    race.velocity += vector_at(e.y, of_.velocity_);
    race.speed += e.y[of_.spin_.first];
    race.angle += e.y[of_.spin_.first + 1];
    race.turn_beyond += e.y[of_.spin_.first + 1];
    race.settle();
  }

 private:
  const UserMotion& of_;
};
class UserMotion::DrivenRaceRates final : public EffectBlock {
 public:
  explicit DrivenRaceRates(const UserMotion& of) : of_(of) {}
  void apply(Evaluation& e) noexcept override {
    const Vec3 held = Vec3::Ones() - of_.balanced_directions_;
    store_at(e.dydt, of_.place_, vector_at(e.y, of_.velocity_));
    store_at(e.dydt, of_.velocity_, Vec3(of_.actions_.acceleration[1].cwiseProduct(held)));
    e.dydt[of_.spin_.first] = of_.actions_.angular_acceleration[1][0];
    e.dydt[of_.spin_.first + 1] = e.y[of_.spin_.first];
  }

 private:
  const UserMotion& of_;
};

void UserMotion::declare(SceneBuilder& scene) {
  demand(scene.options.user != nullptr && scene.options.user->motion != nullptr,
         "the simulation uses user routine ADRX1, but no user routine is loaded");
  routine_ = scene.options.user->motion;
  const ScenePlan& plan = scene.plan;
  const Races& races = *scene.find<Races>();
  unloaded_race_centers_ = races.unloaded_race_centers();
  has_balanced_race_ = plan.has(Effect::RaceBalance);
  if (has_balanced_race_)
    for (std::size_t k = 0; k < 3; ++k)
      balanced_directions_[static_cast<int>(k)] =
          scene.bearing.constraints.displacement_given[k] ? 0.0 : 1.0;
  if (has_balanced_race_ && motion_declaration().drives[1]) {
    place_ = scene.state("inner race.driven_place", "m", 3, ScaleKind::Length, kBorder);
    velocity_ = scene.state("inner race.driven_velocity", "m/s", 3, ScaleKind::Velocity, kBorder);
    spin_ = scene.state("inner race.driven_speed", "rad/s", 1, ScaleKind::Rate, kBorder);
    (void)scene.state("inner race.driven_turn", "rad", 1, ScaleKind::Angle, kBorder);
    // No block has this partner: the elements act on the center of the race (race_balance.hpp).
    scene.add_border_body({BodyId::Kind::Race, 2}, no_element_coupling_, {place_.first, 8});
    scene.block<DrivenRaceMotion>(Phase::Races, kMotionCost, {}, *this);
    scene.block<DrivenRaceRates>(Phase::Motion, kMotionCost, {}, *this);
  }
  scene.block<CallRoutine>(Phase::Kinematics, kCost, {}, *this);
  using Momentum = SceneBuilder::Momentum;
  const bool momentum = plan.has(Effect::MomentumLedger);
  if (motion_declaration().moves_frame) {
    masses_ = ElementMasses(scene.bearing);
    scene.block<FrameForces>(Phase::Force, kCost, {}, *this);
    scene.energy("frame.work", kFrameWork, &frame_power_);
    if (momentum) {
      scene.momentum(frame_impulse_index_, "frame.impulse", Momentum::Linear, kFrameImpulse,
                     frame_force_.data());
      scene.momentum(frame_angular_impulse_index_, "frame.angular_impulse", Momentum::Angular,
                     kFrameAngularImpulse, frame_moment_.data());
    }
  }
  if (plan.race_motions.free[0] && plan.race_motions.free[1]) return;
  scene.block<SupportedLoads>(Phase::Force, kCost, {}, *this);
  scene.block<SupportedLoadWork>(Phase::Account, kCost, {}, *this);
  scene.energy("user loads.work", kHeldWork, &supported_load_power_);
  if (!momentum) return;
  scene.momentum(supported_impulse_index_, "user loads.impulse", Momentum::Linear, kHeldImpulse,
                 supported_force_.data());
  scene.momentum(supported_angular_impulse_index_, "user loads.angular_impulse", Momentum::Angular,
                 kHeldAngularImpulse, supported_moment_.data());
}

void UserMotion::start(std::span<double> y) const {
  if (place_.count == 0) return;
  store_at(y.data(), velocity_,
           Vec3(motion_declaration().start_velocity[1].cwiseProduct(Vec3::Ones() -
                                                                    balanced_directions_)));
  y[static_cast<std::size_t>(spin_.first)] = motion_declaration().start_spin[1];
}

bool UserMotion::moves_races() const noexcept { return place_.count > 0; }

void UserMotion::report(const Evaluation& e, Snapshot& snapshot) const {
  for (std::size_t j = 0; j < 2; ++j) {
    RaceSnapshot& race = snapshot.races[j];
    race.carried_force += supported_force(e, j);
  }
  if (place_.count > 0)
    snapshot.races[1].acceleration +=
        actions_.acceleration[1].cwiseProduct(Vec3::Ones() - balanced_directions_);
}

double UserMotion::longest_step(double t) const {
  double longest = std::numeric_limits<double>::infinity();
  if (motion_declaration().longest_step > 0.0) longest = motion_declaration().longest_step;
  for (const double kink : motion_declaration().kinks)
    if (kink > t) longest = std::min(longest, kink - t);
  return longest;
}

bool has_user_motion(const ScenePlan& plan) {
  return std::any_of(plan.effects.begin(), plan.effects.end(),
                     [](const scene::EffectEntry& one) { return one.name == kCost; });
}
std::unique_ptr<SceneEffect> make_user_motion(const ScenePlan& plan) {
  if (!has_user_motion(plan)) return nullptr;
  return std::make_unique<UserMotion>();
}
std::span<const LedgerTerm* const> user_motion_terms() { return kTerms; }

}  // namespace adore::dynamics
