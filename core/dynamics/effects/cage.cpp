#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/free_body.hpp"
#include "dynamics/effects/pockets.hpp"
#include "scene/ledger_terms.hpp"

#include <cmath>

/// The cage as free rigid bodies, one for each segment: six degrees of freedom and its total
/// rotation each. Pockets know which segment they are in (PocketSet::segment). Limit: one piece.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHolding{LedgerKind::Work,
                              "cage_holding",
                              "work of what suppresses motions of the cage",
                              {"work of suppressed motions of the cage"},
                              "done since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHolding};
constexpr LedgerTerm kImpulse{LedgerKind::Work, "", "", {"impulse on the held cage"}, ""};
constexpr LedgerTerm kAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse on the held cage"}, ""};

/// What suppresses motions of the cage, now.
struct Holding {
  double power = 0.0;                                ///< [W]
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< about the base origin [N, N m]
};

class HoldingAccount final : public EffectBlock {
 public:
  HoldingAccount(const FreeBody& body, Holding& sums) : body_(body), sums_(sums) {}
  void apply(Evaluation& e) noexcept override {
    const BodyState& cage = body_.state(e);
    sums_.force = body_.holding_force();
    sums_.power = sums_.force.dot(cage.velocity) + body_.holding_moment().dot(cage.omega);
    sums_.moment = body_.holding_moment() + cage.position.cross(sums_.force);
  }

 private:
  const FreeBody& body_;
  Holding& sums_;
};

class Cage final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.bearing.cage.has_value(), "the plan moves a cage that the bearing does not have");
    const bearing::Cage& cage = *scene.bearing.cage;
    scene.e.segments.resize(1);
    segments_.resize(scene.e.segments.size());
    for (std::size_t k = 0; k < segments_.size(); ++k)
      segments_[k].declare(scene, {BodyId::Kind::Segment, static_cast<int>(k)}, "cage",
                           cage.inertia);
    for (const FreeBody& segment : segments_)
      scene.block<BodyKinematics>(Phase::Kinematics, kMotionCost, {}, segment);
    for (FreeBody& segment : segments_)
      scene.block<BodyMotion>(Phase::Motion, kMotionCost, {}, segment);
    const ScenePlan& plan = scene.plan;
    if ((plan.has(Effect::PocketTraction) || plan.has(Effect::LandTraction)) &&
        plan.has(Effect::WearIntegrals))
      scene.integral(load_slip_, "cage.load_slip", "J", &scene.e.segments.front().load_slip);
    double mean_x = 0.0;
    for (const statics::StaticBall& ball : scene.statics.balls)
      mean_x += ball.x / static_cast<double>(scene.statics.balls.size());
    // Pockets sit at the middle of a roller, not at its mass centre.
    if (const bearing::RollerGeometry* rollers = scene.bearing.rollers())
      off_middle_ = scene.bearing.roller_mass_offset * std::cos(rollers->axis_angle);
    mean_x -= off_middle_;
    mass_centre_ = -cage.inertia.geometric_centre;
    start_ = cage_start(nominal_cage_speed(scene.bearing), cage.speed_ratio, cage.whirl_ratio,
                        {mean_x, 0.0, 0.0}, cage.start_offset, cage.start_angles);
    if (plan.suppressed.of_cage()) suppress(scene);
  }

  /// Record 9.6 places the geometric centre.
  void start(std::span<double> y) const override {
    const Mat3 R = rotation_matrix(start_.orientation);
    const Vec3 arm = R * mass_centre_;
    for (const FreeBody& segment : segments_)
      segment.start(y, start_.mass_centre + arm,
                    start_.mass_centre_velocity + (R * start_.omega_body).cross(arm),
                    start_.orientation, start_.omega_body);
  }

  void store(const Evaluation& e, EnergyLedger& energy) const override {
    for (const FreeBody& segment : segments_)
      energy.accumulate(terms::kKinetic, segment.kinetic_energy(segment.state(e)));
  }

  void carry(const Evaluation& e, Momenta& momenta) const override {
    for (const FreeBody& segment : segments_) segment.carry(segment.state(e), momenta);
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    snapshot.cages.resize(segments_.size());
    double mean_x = -off_middle_;
    for (const ElementSnapshot& element : snapshot.elements)
      mean_x += element.x / static_cast<double>(snapshot.elements.size());
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      CageSnapshot& cage = snapshot.cages[k];
      segments_[k].report(e, cage);
      cage.position -= Vec3(mean_x, 0.0, 0.0);
    }
    snapshot.power.qv_cage = integral_at(e, load_slip_);
  }

 private:
  /// kDOF 1 and 2 (reading N9). A cage that may not tilt keeps what its angular velocity has across
  /// the axis that it starts with.
  void suppress(SceneBuilder& scene) {
    const auto [axial, tilt] =
        std::pair{scene.plan.suppressed.cage_axial, scene.plan.suppressed.cage_tilt};
    FreeBody& body = segments_.front();
    body.constrain({{axial, false, false}, {false, tilt, tilt}},
                   rotation_matrix(start_.orientation));
    scene.block<HoldingAccount>(Phase::Account, kMotionCost, {}, body, holding_);
    scene.energy("held cage.work", kHolding, &holding_.power);
    if (!scene.plan.has(Effect::MomentumLedger)) return;
    using Momentum = SceneBuilder::Momentum;
    scene.momentum(impulse_, "held cage.impulse", Momentum::Linear, kImpulse,
                   holding_.force.data());
    scene.momentum(angular_impulse_, "held cage.angular_impulse", Momentum::Angular,
                   kAngularImpulse, holding_.moment.data());
  }

  Holding holding_;
  int impulse_ = -1, angular_impulse_ = -1;  ///< in the state
  std::vector<FreeBody> segments_;  ///< never moved once declared: blocks and border know them
  CageStart start_;
  double off_middle_ = 0.0;  ///< axial place of mass centres from the middles of the elements [m]
  Vec3 mass_centre_ = Vec3::Zero();  ///< from the geometric centre, axes of the cage [m]
  int load_slip_ = -1;               ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_cage(const ScenePlan& plan) {
  if (!plan.has(Effect::CageMotion)) return nullptr;
  return std::make_unique<Cage>();
}

std::span<const LedgerTerm* const> cage_terms() { return kTerms; }

}  // namespace adore::dynamics
