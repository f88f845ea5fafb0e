#include "base/errors.hpp"
#include "dynamics/constrained_element.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/balls.hpp"
#include "dynamics/effects/rigid_elements.hpp"
#include "dynamics/held_elements.hpp"

/// Suppressed accelerations of elements (kDOF, reading N9): after the equations of motion they are
/// set to zero, so that the velocity keeps the value of the start; components of ω are those of the
/// azimuth frame. The reaction of an element follows from its acceleration without the constraint,
///   H = -m (ẍ, r̈, r θ̈) and -I (ω̇_x, ω̇_r, ω̇_θ) of the suppressed components, I the tensor in the
///   axes now,
/// acts from outside, and does the work H · velocity, which the ledgers book. Elements whose mass
/// center is off their reference point: constrained_element.hpp. Of the cage: cage.cpp.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kWork{LedgerKind::Work,
                           "element_holding",
                           "work of the constraints that suppress element motions",
                           {"work of suppressed motions of elements"},
                           "work done since the start"};
constexpr const LedgerTerm* kTerms[] = {&kWork};
constexpr LedgerTerm kImpulse{LedgerKind::Work, "", "", {"impulse on held elements"}, ""};
constexpr LedgerTerm kAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse on held elements"}, ""};

class SuppressedElements final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    const scene::SuppressedMotions& given = scene.plan.suppressed;
    const bool all = given.element_all;
    axial_ = given.element_axial || all;
    tilt_ = given.element_tilt || all;
    rest_ = all;
    if (const Balls* balls = scene.find<Balls>())
      slices_ = balls->slices();
    else
      slices_ = scene.find<RigidElements>()->slices();
    masses_ = ElementMasses(scene.bearing);
    others_ = scene.find<QuasiStaticEffect>();
    scene.block<Hold>(Phase::Motion, "suppressed motions", {}, *this);
    scene.energy("held elements.work", kWork, &power_);
    if (!scene.plan.has(Effect::MomentumLedger)) return;
    using Momentum = SceneBuilder::Momentum;
    scene.momentum(impulse_, "held elements.impulse", Momentum::Linear, kImpulse, force_.data());
    scene.momentum(angular_impulse_, "held elements.angular_impulse", Momentum::Angular,
                   kAngularImpulse, moment_.data());
  }

 private:
  class Hold final : public EffectBlock {
   public:
    explicit Hold(SuppressedElements& of) : of_(of) {}
    void apply(Evaluation& e) noexcept override { of_.hold(e); }

   private:
    SuppressedElements& of_;
  };

  void hold(Evaluation& e) noexcept {
    power_ = 0.0;
    force_.setZero();
    moment_.setZero();
    for (std::size_t i = 0; i < slices_.elements(); ++i) {
      if (masses_[i].has_eccentric_mass) {
        hold_off_centre(e, i);
        continue;
      }
      const auto taken = [&](Quantity q) {
        double& rate = e.dydt[slices_.at(q, i)];
        const double value = rate;
        rate = 0.0;
        return value;
      };
      const ElementViews& b = e.elements;
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // (x, r, θ)
      const double mass = masses_[i].mass;
      if (axial_) force[0] = -mass * taken(Quantity::XDot);
      if (rest_) {
        force[1] = -mass * taken(Quantity::RDot);
        force[2] = -mass * b.r[i] * taken(Quantity::ThetaDot);
        moment[0] = -taken(Quantity::OmegaX);
      }
      if (tilt_) {
        moment[1] = -taken(Quantity::OmegaR);
        moment[2] = -taken(Quantity::OmegaTheta);
      }
      book(e, i, force, inertia_times(e, i, moment));
    }
  }

  /// All rates anew: what is held changes the others too.
  void hold_off_centre(Evaluation& e, std::size_t i) noexcept {
    using enum Quantity;
    ElementConstraints hold{axial_, rest_, rest_, rest_, tilt_};
    const bool held = others_ != nullptr && others_->is_quasi_static(i);
    if (held) {  // reactions of a balance belong to it (held_elements.hpp), with the same rates
      hold.r = true;
      hold.x = hold.x || others_->is_x_quasi_static();
    }
    ElementRates found = constrained_element(e, i, masses_[i], hold);
    if (held) found.force[1] = 0.0;
    const auto rate = [&](Quantity q) -> double& { return e.dydt[slices_.at(q, i)]; };
    rate(XDot) = found.x_ddot;
    rate(RDot) = found.r_ddot;
    rate(ThetaDot) = found.theta_ddot;
    rate(OmegaX) = found.omega[0];
    rate(OmegaR) = found.omega[1];
    rate(OmegaTheta) = found.omega[2];
    book(e, i, found.force, found.moment);
  }

  /// @param force, moment what holds element i, (x, r, θ)
  void book(const Evaluation& e, std::size_t i, const Vec3& force, const Vec3& moment) noexcept {
    const ElementViews& b = e.elements;
    power_ += force.dot(Vec3(b.x_dot[i], b.r_dot[i], b.r[i] * b.theta_dot[i])) +
              moment.dot(Vec3(b.omega_x[i], b.omega_r[i], b.omega_theta[i]));
    const Vec3 in_base = e.to_base(i, force);
    force_ += in_base;
    moment_ += e.to_base(i, moment) + e.element_centre(i).cross(in_base);
  }

  /// I ω̇, both (x, r, θ) components.
  [[nodiscard]] Vec3 inertia_times(const Evaluation& e, std::size_t i,
                                   const Vec3& rate) const noexcept {
    const Mat3& inertia = masses_[i].inertia;
    if (e.attitude.empty()) return inertia(0, 0) * rate;  // a ball
    const Mat3& to_base = e.attitude[i];
    const Vec3 in_body = inertia * (to_base.transpose() * e.to_base(i, rate));
    return e.to_cylindrical(i, to_base * in_body);
  }

  ElementSlices slices_;
  bool axial_ = false, tilt_ = false, rest_ = false;
  ElementMasses masses_;
  const QuasiStaticEffect* others_ = nullptr;          ///< an effect that holds elements, too
  double power_ = 0.0;                                 ///< now [W]
  Vec3 force_ = Vec3::Zero(), moment_ = Vec3::Zero();  ///< now, about the base origin [N, N m]
  int impulse_ = -1, angular_impulse_ = -1;            ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_suppressed_accelerations(const ScenePlan& plan) {
  if (!plan.suppressed.of_elements()) return nullptr;
  return std::make_unique<SuppressedElements>();
}
std::span<const LedgerTerm* const> suppressed_acceleration_terms() { return kTerms; }

}  // namespace adore::dynamics
