#include "dynamics/effect_makers.hpp"
#include "dynamics/element_masses.hpp"
#include "dynamics/moving_frame.hpp"
#include "scene/ledger_terms.hpp"

#include <cmath>

/// Base frame that turns about a fixed axis parallel to X (record 9.5): every position, velocity
/// and ω of the scene is relative to it. Each body feels the transport force, which has the
/// potential -½ m Ω² (distance of its mass center from the fixed axis)², and the Coriolis force,
/// which does no work (moving_frame.hpp). About its mass center a body of inertia I feels what
/// turns Euler's equations for ω + Ω into equations for ω, with Ω_b = Rᵀ Ω in body axes:
///   M = I(ω × Ω_b) - (ω + Ω_b) × I(ω + Ω_b) + ω × Iω,   power -ω·(Ω_b × I Ω_b), hence of the
/// potential -½ Ω_b·I Ω_b; of a ball, I equal: M = -I Ω × ω.
/// Races that are prescribed move as prescribed, relative to the frame; of free races the given
/// share of the force acts (record 9.5), the moment acts whole.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kEnergy{LedgerKind::Stored,
                             "frame",
                             "centrifugal potential energy in the rotating base frame",
                             {"energy in the turning base frame now"},
                             "stored now",
                             "N"};
constexpr const LedgerTerm* kTerms[] = {&kEnergy};
constexpr LedgerTerm kImpulse{LedgerKind::Work, "", "", {"impulse of the turning base frame"}, ""};
constexpr LedgerTerm kAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse of the turning base frame"}, ""};

class TurningFrame final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    const bearing::FrameMotion& motion = *scene.plan.race_motions.frame;
    frame_ = {motion.speed, motion.orbit_radius, motion.orbit_angle};
    load_share_ = motion.load_share;
    masses_ = ElementMasses(scene.bearing);
    scene.block<Fields>(Phase::Force, "turning base frame", {}, *this);
    if (!scene.plan.has(Effect::MomentumLedger)) return;
    using Momentum = SceneBuilder::Momentum;
    scene.momentum(impulse_, "frame.impulse", Momentum::Linear, kImpulse, force_.data());
    scene.momentum(angular_impulse_, "frame.angular_impulse", Momentum::Angular, kAngularImpulse,
                   moment_.data());
  }

  void store(const Evaluation& e, EnergyLedger& energy) const override {
    double stored = 0.0;
    for (std::size_t i = 0; i < e.elements.n; ++i)
      stored += potential(masses_[i].mass, mass_centre(e, i));
    for (std::size_t i = 0; i < e.attitude.size(); ++i)
      stored += of_turn(e.attitude[i], masses_[i].inertia);
    e.for_integrated_bodies([&](const BodyState& body) {
      stored += potential(share_of(e, body) * body.mass, body.centre_of_mass()) +
                of_turn(body.to_base, body.inertia);
    });
    energy.accumulate(kEnergy, stored);
  }

 private:
  class Fields final : public EffectBlock {
   public:
    explicit Fields(TurningFrame& of) : of_(of) {}
    void apply(Evaluation& e) noexcept override { of_.act(e); }

   private:
    TurningFrame& of_;
  };

  [[nodiscard]] Vec3 mass_centre(const Evaluation& e, std::size_t i) const noexcept {
    Vec3 out = e.element_centre(i);
    if (masses_[i].has_eccentric_mass) out += e.attitude[i] * masses_[i].arm;
    return out;
  }
  /// Zero in the base origin: on a wide orbit the energy of its radius would drown the rest.
  [[nodiscard]] double potential(double mass, const Vec3& centre) const noexcept {
    const Vec3 twice = 2.0 * frame_.orbit_radius * radial_direction(frame_.orbit_angle) + centre;
    return -0.5 * mass * frame_.speed * frame_.speed *
           (centre[1] * twice[1] + centre[2] * twice[2]);
  }

  /// M above, base axes, of a tensor I in the axes of `to_base`.
  [[nodiscard]] static Vec3 of_tensor(const Mat3& to_base, const Mat3& I, const Vec3& omega,
                                      const Vec3& frame) noexcept {
    const Vec3 w = to_base.transpose() * omega, turn = to_base.transpose() * frame;
    const Vec3 whole = w + turn;
    const Vec3 in_body = I * w.cross(turn) - whole.cross(Vec3(I * whole)) + w.cross(Vec3(I * w));
    return to_base * in_body;
  }
  /// -½ Ω_b·I Ω_b [J].
  [[nodiscard]] double of_turn(const Mat3& to_base, const Mat3& I) const noexcept {
    const Vec3 turn = to_base.transpose() * (frame_.speed * Vec3::UnitX());
    return -0.5 * turn.dot(I * turn);
  }
  /// Of the force on its mass; what is not its share is carried outside of the bearing.
  [[nodiscard]] double share_of(const Evaluation& e, const BodyState& body) const noexcept {
    for (std::size_t j = 0; j < 2; ++j)
      if (&body == &e.race[j]) return load_share_[j];
    return 1.0;
  }

  void book(const Vec3& force, const Vec3& moment, const Vec3& centre) noexcept {
    force_ += force;
    moment_ += moment + centre.cross(force);
  }

  void act(Evaluation& e) noexcept {
    force_.setZero();
    moment_.setZero();
    const Vec3 frame = frame_.speed * Vec3::UnitX();
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const ElementMass& body = masses_[i];
      const Vec3 centre = mass_centre(e, i), omega = e.element_omega(i);
      Vec3 velocity = e.element_velocity(i);
      const Vec3 arm = centre - e.element_centre(i);
      if (body.has_eccentric_mass) velocity += omega.cross(arm);
      const Vec3 force = frame_.inertial_force(body.mass, centre, velocity);
      const Vec3 moment = e.attitude.empty() ? Vec3(-body.inertia(0, 0) * frame.cross(omega))
                                             : of_tensor(e.attitude[i], body.inertia, omega, frame);
      e.add_force(i, e.to_cylindrical(i, force));
      e.add_moment(i, e.to_cylindrical(i, moment + arm.cross(force)));
      book(force, moment, centre);
    }
    e.for_integrated_bodies([&](BodyState& body) {
      const Vec3 centre = body.centre_of_mass();
      const Vec3 force =
          frame_.inertial_force(share_of(e, body) * body.mass, centre, body.velocity_at(centre));
      const Vec3 moment = of_tensor(body.to_base, body.inertia, body.omega, frame);
      body.add_force(force, centre);
      body.moment += moment;
      book(force, moment, centre);
    });
  }

  MovingFrame frame_;
  std::array<double, 2> load_share_{1.0, 1.0};
  ElementMasses masses_;
  Vec3 force_ = Vec3::Zero(), moment_ = Vec3::Zero();  ///< now, about the base origin [N, N m]
  int impulse_ = -1, angular_impulse_ = -1;            ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_turning_frame(const ScenePlan& plan) {
  if (!plan.race_motions.frame) return nullptr;
  return std::make_unique<TurningFrame>();
}
std::span<const LedgerTerm* const> rotating_frame_ledger_terms() { return kTerms; }

}  // namespace adore::dynamics
