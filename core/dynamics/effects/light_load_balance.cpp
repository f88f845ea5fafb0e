#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/balls.hpp"
#include "dynamics/effects/race_balance.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/effects/rigid_elements.hpp"
#include "dynamics/held_balls.hpp"
#include "dynamics/held_elements.hpp"
#include "dynamics/held_rollers.hpp"
#include "dynamics/roller_start.hpp"
#include "dynamics/state_access.hpp"
#include "scene/user_laws.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

/// Effects "light-load balance" (qFac) and "element balance" (modes 1 and 2, all): which
/// elements are held, changed between steps only, and the books of what held ones leave out. The
/// motion of a held element: held_elements.hpp.
namespace adore::dynamics {
namespace {

// The kinetic energy excludes ½m(ẋ² + ṙ²) of held elements.
constexpr LedgerTerm kSwitches{
    LedgerKind::Switch,
    "switches",
    "energy change when elements switch to or from quasi-static motion",
    {"switches of held elements"},
    "stored energy after each switch minus the energy before it, total since the start"};
/// ∫ G·(ẋ, ṙ) dt
constexpr LedgerTerm kBalance{LedgerKind::Taken,
                              "balance",
                              "energy removed when quasi-static elements move to equilibrium",
                              {"taken by held elements' way to balance"},
                              "energy removed since the start"};
constexpr LedgerTerm kLeftOut{
    LedgerKind::Note,
    "left_out",
    "kinetic energy of quasi-static elements that the energy balance excludes",
    {"kinetic energy left out of held elements now"},
    "for information only, not part of the energy balance"};
constexpr LedgerTerm kMomentum{
    LedgerKind::Taken, "", "", {"linear momentum taken by held elements"}, ""};
constexpr LedgerTerm kAngularMomentum{
    LedgerKind::Taken, "", "", {"angular momentum taken by held elements"}, ""};
constexpr const LedgerTerm* kTerms[] = {&kSwitches, &kBalance, &kLeftOut};

class HeldRates final : public EffectBlock {
 public:
  explicit HeldRates(QuasiStaticElements& held) : held_(held) {}
  void apply(Evaluation& e) noexcept override { held_.form_rates(e); }

 private:
  QuasiStaticElements& held_;
};

class HeldMotion final : public EffectBlock {
 public:
  explicit HeldMotion(QuasiStaticElements& held) : held_(held) {}
  void apply(Evaluation& e) noexcept override { held_.remove_inertia(e); }

 private:
  QuasiStaticElements& held_;
};

/// An element that becomes held: where it was and where its balance is.
struct Candidate {
  std::size_t element;
  double x, r, theta_dot;
  Vec2 residual;  ///< G at the old place [N]
};

class LightLoadBalance final : public SceneEffect, public QuasiStaticEffect {
 public:
  void declare(SceneBuilder& scene) override;
  void resume(std::span<const double> y) override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;
  /// An element is held when its largest contact load is at or below qFac times the force scale
  /// and, put in balance, below the release level; released above kReleaseRatio times that. The
  /// jumps of energy and momentum are booked in y.
  bool between_steps(double t, std::span<double> y, BetweenStepsAccess& scene) override;
  [[nodiscard]] bool is_quasi_static(std::size_t i) const noexcept override {
    return held_->is_quasi_static(i);
  }
  [[nodiscard]] bool is_x_quasi_static() const noexcept override { return axial_; }

 private:
  /// Turns a roller that becomes held into line, about the shortest way; its spin about its axis
  /// stays.
  void align(const Evaluation& e, std::size_t i, std::span<double> y) const;

  std::optional<QuasiStaticElements> held_;
  const RigidElements* rigid_ = nullptr;  ///< rollers
  ElementSlices element_;
  ElementMasses masses_;
  double load_ratio_ = 0.0;
  bool all_ = false;   ///< every element, from the start on
  bool axial_ = true;  ///< x is in balance, else r alone: then a held element stays where it is
  // In the state.
  int balance_ = -1, switches_ = -1;
  int impulse_ = -1, angular_impulse_ = -1;  ///< first of three
  int flags_ = -1;                           ///< first of one per element: 1 held, 0 free
};

void LightLoadBalance::declare(SceneBuilder& scene) {
  load_ratio_ = scene.plan.light_load_ratio;
  all_ = scene.plan.has(Effect::ElementBalance);
  demand(all_ || load_ratio_ > 0.0,
         "the effect \"light-load balance\" needs a load ratio (qFac) above 0");
  axial_ = !scene.plan.suppressed.element_axial;
  std::unique_ptr<QuasiStaticContacts> contacts;
  masses_ = ElementMasses(scene.bearing);
  rigid_ = scene.find<RigidElements>();
  if (rigid_ != nullptr)
    element_ = rigid_->slices();
  else
    element_ = scene.find<Balls>()->slices();
  if (scene.rollers != nullptr) {
    axial_ = axial_ && scene.bearing.type == bearing::Type::Tapered;
    contacts = std::make_unique<QuasiStaticRollers>(
        statics::make_roller_model(scene.bearing, scene.rollers->options),
        scene.bearing.imperfections, masses_,
        scene.options.user ? std::span(scene.options.user->out_of_round)
                           : std::span<const std::shared_ptr<const bearing::SurfaceSeries>>());
  } else {
    contacts = std::make_unique<QuasiStaticBalls>(
        scene.find<Races>()->contacts(), scene.find<Races>()->halves(), masses_,
        static_cast<std::size_t>(scene.bearing.element_count()));
  }
  RaceBalance* race = scene.find<RaceBalance>();
  const scene::SuppressedMotions& suppressed = scene.plan.suppressed;
  held_.emplace(
      QuasiStaticElements::Scene{
          masses_,
          axial_,
          race != nullptr ? &race->race() : nullptr,
          {.x = suppressed.element_axial, .tilt = suppressed.element_tilt},
          !all_ && scene.rollers != nullptr,
          scene.rollers != nullptr ? scene.bearing.rollers()->axis_angle : 0.0},
      element_, std::move(contacts), scene.force_pass(race == nullptr));
  constexpr std::string_view kCost = "light-load balance";
  scene.block<HeldRates>(Phase::Kinematics, kCost, {}, *held_);
  scene.block<HeldMotion>(Phase::Motion, kCost, {}, *held_);

  using Momentum = SceneBuilder::Momentum;
  const QuasiStaticElements::Account& account = held_->account();
  scene.energy(balance_, "held.balance_work", kBalance, &account.power);
  scene.energy(switches_, "held.switch_energy", kSwitches, nullptr);
  scene.momentum(impulse_, "held.impulse", Momentum::Linear, kMomentum, account.force.data());
  scene.momentum(angular_impulse_, "held.angular_impulse", Momentum::Angular, kAngularMomentum,
                 account.moment.data());
  scene.integral(flags_, "held.element", "-", nullptr, scene.bearing.element_count());
}

void LightLoadBalance::resume(std::span<const double> y) {
  for (int i = 0; i < element_[Quantity::X].count; ++i)
    held_->set(static_cast<std::size_t>(i), y[static_cast<std::size_t>(flags_ + i)] > 0.5);
}

void LightLoadBalance::report(const Evaluation&, Snapshot& snapshot) const {
  double left_out = 0.0;
  for (const std::size_t i : held_->quasi_static_indices()) {
    left_out += 0.5 * masses_[i].mass * held_->left_out(i).squaredNorm();
    snapshot.elements[i].held = true;
  }
  snapshot.energy.add(kLeftOut, left_out);
  snapshot.held_elements = static_cast<int>(held_->quasi_static_indices().size());
}

void LightLoadBalance::align(const Evaluation& e, std::size_t i, std::span<double> y) const {
  const Vec3 old = e.attitude[i].col(0), now = e.to_base(i, held_->aligned_axis());
  const Slice& slice = rigid_->attitude(i);
  const Quat q = normalize_quaternion(quaternion_at(y.data(), slice));
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond::FromTwoVectors(old, now) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  store_at(y.data(), slice, Quat{turned.w(), turned.x(), turned.y(), turned.z()});
  const double theta_dot = component(y, element_[Quantity::ThetaDot], i);
  const Vec3 about(component(y, element_[Quantity::OmegaX], i) - theta_dot,
                   component(y, element_[Quantity::OmegaR], i),
                   component(y, element_[Quantity::OmegaTheta], i));
  const Vec3 omega =
      theta_dot * Vec3::UnitX() + about.dot(e.to_cylindrical(i, old)) * held_->aligned_axis();
  component(y, element_[Quantity::OmegaX], i) = omega[0];
  component(y, element_[Quantity::OmegaR], i) = omega[1];
  component(y, element_[Quantity::OmegaTheta], i) = omega[2];
}

bool LightLoadBalance::between_steps(double t, std::span<double> y, BetweenStepsAccess& scene) {
  QuasiStaticElements& held = *held_;
  const Evaluation& e = scene.evaluate(t, y);
  const double threshold = load_ratio_ * scene.run_scales().force;
  const auto at = [&y](const Slice& slice, std::size_t i) -> double& {
    return y[static_cast<std::size_t>(slice.first) + i];
  };
  const auto rate_of = [&e](const Slice& slice, std::size_t i) {
    return e.dydt[slice.first + static_cast<int>(i)];
  };
  const auto load_of = [&e](std::size_t i) { return std::max(e.load[0][i], e.load[1][i]); };

  struct Release {
    std::size_t element;
    Vec2 rate;
  };
  std::vector<Release> released;
  std::vector<Candidate> taken;
  std::vector<QuasiStaticPosition> places;
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const bool was = held.is_quasi_static(i);
    if ((all_ || is_quasi_static_next(was, load_of(i), threshold)) == was) continue;
    if (was) {
      released.push_back({i, held.rate(i)});
      continue;
    }
    // All forces but the normal ones of the races stay as they are while the place is sought.
    const double mass = masses_[i].mass;
    const double centrifugal =
        mass * e.elements.r[i] * e.elements.theta_dot[i] * e.elements.theta_dot[i];
    const Vec2 residual = mass * Vec2(axial_ ? rate_of(element_[Quantity::XDot], i) : 0.0,
                                      rate_of(element_[Quantity::RDot], i));
    const Vec2 other = residual - Vec2(0.0, centrifugal) - held.normal_force(e, i);
    QuasiStaticPosition place = held.balanced(e, i, other);
    if (!all_ && (!place.solved || place.load > kReleaseRatio * threshold))
      continue;  // passing through
    if (!place.solved || !axial_) {
      place.x = e.elements.x[i];
      place.r = e.elements.r[i];
      place.speed = e.elements.theta_dot[i];
    }
    taken.push_back({i, e.elements.x[i], e.elements.r[i], e.elements.theta_dot[i], residual});
    places.push_back(place);
  }
  if (released.empty() && taken.empty()) return false;

  const double energy = scene.stored_energy();
  const Momenta momenta = scene.momenta();
  for (const Release& release : released) {
    held.set(release.element, false);
    at(element_[Quantity::XDot], release.element) = release.rate[0];
    at(element_[Quantity::RDot], release.element) = release.rate[1];
  }
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const std::size_t i = taken[k].element;
    held.set(i, true);
    if (axial_) at(element_[Quantity::XDot], i) = 0.0;
    at(element_[Quantity::RDot], i) = 0.0;
    at(element_[Quantity::X], i) = places[k].x;
    at(element_[Quantity::R], i) = places[k].r;
    at(element_[Quantity::ThetaDot], i) = places[k].speed;  // L is kept
  }
  for (const Candidate& c : taken)
    if (rigid_ != nullptr && held.aligns(c.element)) align(e, c.element, y);
  // A pocket wall in the way can make the new place worse than the old one: then the element stays
  // and its motion as a held element brings it to balance.
  const bool valid = scene.is_valid(t, y);
  for (const Candidate& c : taken) {
    if (valid && held.residual(c.element).norm() <= c.residual.norm()) continue;
    at(element_[Quantity::X], c.element) = c.x;
    at(element_[Quantity::R], c.element) = c.r;
    at(element_[Quantity::ThetaDot], c.element) = c.theta_dot;
    if (rigid_ != nullptr && held.aligns(c.element)) align(e, c.element, y);
  }
  scene.evaluate(t, y);

  const auto integral = [&y](int index) -> double& { return y[static_cast<std::size_t>(index)]; };
  integral(switches_) += scene.stored_energy() - energy;
  const Momenta after = scene.momenta();
  for (int k = 0; k < 3; ++k) {
    integral(impulse_ + k) -= after.linear[k] - momenta.linear[k];
    integral(angular_impulse_ + k) -= after.angular[k] - momenta.angular[k];
  }
  for (std::size_t i = 0; i < e.elements.n; ++i)
    integral(flags_ + static_cast<int>(i)) = held.is_quasi_static(i) ? 1.0 : 0.0;
  return true;
}

}  // namespace

std::unique_ptr<SceneEffect> make_light_load_balance(const ScenePlan& plan) {
  if (!plan.has(Effect::LightLoadBalance) && !plan.has(Effect::ElementBalance)) return nullptr;
  return std::make_unique<LightLoadBalance>();
}
std::span<const LedgerTerm* const> light_load_terms() { return kTerms; }

}  // namespace adore::dynamics
