#include "base/errors.hpp"
#include "contact/cage_pieces.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/free_body.hpp"
#include "dynamics/effects/pockets.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "scene/ledger_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// The cage as free rigid bodies, one for each segment: six degrees of freedom and its total
/// rotation each. Pockets know which segment they are in (contact/cage_pieces.hpp). The reference
/// point of a segment is on the axis of the cage, far from its mass center; its attitude at the
/// start is that of record 9.6.k, turned to its place in the cage. Segments do not touch each other
/// (N106): how far apart their ends are is reported.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHolding{LedgerKind::Work,
                              "cage_holding",
                              "work of the constraints that suppress cage motions",
                              {"work of suppressed motions of the cage"},
                              "work done since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHolding};
constexpr LedgerTerm kImpulse{LedgerKind::Work, "", "", {"impulse on the held cage"}, ""};
constexpr LedgerTerm kAngularImpulse{
    LedgerKind::Work, "", "", {"angular impulse on the held cage"}, ""};

/// Present reactions of suppressed motions of the cage.
struct Holding {
  double power = 0.0;                                ///< [W]
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< about the base origin [N, N m]
};

class HoldingAccount final : public EffectBlock {
 public:
  HoldingAccount(const std::vector<FreeBody>& bodies, Holding& sums)
      : bodies_(bodies), sums_(sums) {}
  void apply(Evaluation& e) noexcept override {
    sums_ = {};
    for (const FreeBody& body : bodies_) {
      const BodyState& cage = body.state(e);
      const Vec3& force = body.holding_force();
      sums_.force += force;
      sums_.power += force.dot(cage.velocity) + body.holding_moment().dot(cage.omega);
      sums_.moment += body.holding_moment() + cage.position.cross(force);
    }
  }

 private:
  const std::vector<FreeBody>& bodies_;
  Holding& sums_;
};

/// Σ N u of all segments.
class SlipAccount final : public EffectBlock {
 public:
  explicit SlipAccount(double& sum) : sum_(sum) {}
  void apply(Evaluation& e) noexcept override {
    sum_ = 0.0;
    for (const BodyState& segment : e.segments) sum_ += segment.load_slip;
  }

 private:
  double& sum_;
};

class Cage final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.bearing.cage.has_value(),
           "the motion of a cage is to be computed, but the bearing has no cage");
    const bearing::Cage& cage = *scene.bearing.cage;
    pieces_ = pieces_of(scene);
    scene.e.segments.resize(pieces_.middle.size());
    segments_.resize(scene.e.segments.size());
    for (std::size_t k = 0; k < segments_.size(); ++k)
      segments_[k].declare(scene, {BodyId::Kind::Segment, static_cast<int>(k)},
                           segments_.size() == 1 ? "cage" : fmt::format("cage{}", k + 1),
                           cage.inertia);
    for (const FreeBody& segment : segments_)
      scene.block<BodyKinematics>(Phase::Kinematics, kMotionCost, {}, segment);
    for (FreeBody& segment : segments_)
      scene.block<BodyMotion>(Phase::Motion, kMotionCost, {}, segment);
    const ScenePlan& plan = scene.plan;
    if ((plan.has(Effect::PocketTraction) || plan.has(Effect::LandTraction)) &&
        plan.has(Effect::WearIntegrals)) {
      const double* slip = &scene.e.segments.front().load_slip;
      if (segments_.size() > 1) {
        scene.block<SlipAccount>(Phase::Account, kMotionCost, {}, slip_);
        slip = &slip_;
      }
      scene.integral(load_slip_, "cage.load_slip", "J", slip);
    }
    double mean_x = 0.0;
    for (const statics::StaticBall& ball : scene.statics.balls)
      mean_x += ball.x / static_cast<double>(scene.statics.balls.size());
    // Pockets sit at the middle of a roller, not at its mass center.
    if (const bearing::RollerGeometry* rollers = scene.bearing.rollers())
      mean_x -= scene.bearing.roller_mass_offset * std::cos(rollers->axis_angle);
    mass_centre_ = -cage.inertia.geometric_centre;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const bearing::CageStartState& one = cage.start_of(k);
      CageStart start =
          cage_start(nominal_cage_speed(scene.bearing), one.speed_ratio, one.whirl_ratio,
                     {mean_x, 0.0, 0.0}, one.start_offset, one.start_angles);
      if (segments_.size() > 1) {
        const Quat to_place = quaternion_about(Vec3::UnitX(), pieces_.middle[k]);
        start.orientation = multiply(start.orientation, to_place);
        start.omega_body = rotation_matrix(to_place).transpose() * start.omega_body;
      }
      start_.push_back(start);
    }
    corners_ = {0.5 * cage.outer_diameter, 0.5 * cage.inner_diameter, 0.5 * cage.width};
    if (plan.suppressed.of_cage()) suppress(scene);
  }

  /// Record 9.6 places the geometric center.
  void start(std::span<double> y) const override {
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const CageStart& start = start_[k];
      const Mat3 R = rotation_matrix(start.orientation);
      const Vec3 arm = R * mass_centre_;
      segments_[k].start(y, start.mass_centre + arm,
                         start.mass_centre_velocity + (R * start.omega_body).cross(arm),
                         start.orientation, start.omega_body);
    }
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
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      CageSnapshot& cage = snapshot.cages[k];
      segments_[k].report(e, cage);
      if (segments_.size() == 1) continue;
      cage.mass_centre = e.segments[k].centre_of_mass();
      cage.to_next = between_ends(e.segments[k], e.segments[(k + 1) % segments_.size()]);
    }
    snapshot.power.qv_cage = integral_at(e, load_slip_);
  }

 private:
  /// kDOF 1 and 2 (reading N9). A cage that may not tilt keeps what its angular velocity has across
  /// the axis that it starts with.
  void suppress(SceneBuilder& scene) {
    const auto [axial, tilt] =
        std::pair{scene.plan.suppressed.cage_axial, scene.plan.suppressed.cage_tilt};
    for (std::size_t k = 0; k < segments_.size(); ++k)
      segments_[k].constrain({{axial, false, false}, {false, tilt, tilt}},
                             rotation_matrix(start_[k].orientation));
    scene.block<HoldingAccount>(Phase::Account, kMotionCost, {}, segments_, holding_);
    scene.energy("held cage.work", kHolding, &holding_.power);
    if (!scene.plan.has(Effect::MomentumLedger)) return;
    using Momentum = SceneBuilder::Momentum;
    scene.momentum(impulse_, "held cage.impulse", Momentum::Linear, kImpulse,
                   holding_.force.data());
    scene.momentum(angular_impulse_, "held cage.angular_impulse", Momentum::Angular,
                   kAngularImpulse, holding_.moment.data());
  }

  /// CageSnapshot::to_next, from the corners of the ends of two segments.
  [[nodiscard]] double between_ends(const BodyState& one, const BodyState& next) const {
    const auto corner = [&](const BodyState& body, double radius, double x, double side) -> Vec3 {
      return body.position + body.to_base * (x * Vec3::UnitX() +
                                             radius * radial_direction(side * pieces_.half_angle));
    };
    double least = std::numeric_limits<double>::infinity();
    for (const double radius : {corners_[0], corners_[1]})
      for (const double x : {corners_[2], -corners_[2]}) {
        const Vec3 from = corner(one, radius, x, 1.0), to = corner(next, radius, x, -1.0);
        // Along θ where they are.
        const Vec3 along = circumferential_direction(azimuth(0.5 * (from + to)));
        least = std::min(least, along.dot(to - from));
      }
    return least;
  }

  Holding holding_;
  int impulse_ = -1, angular_impulse_ = -1;  ///< in the state
  std::vector<FreeBody> segments_;  ///< never moved once declared: blocks and border know them
  contact::CagePieces pieces_;
  Vec3 corners_ = Vec3::Zero();      ///< outer and inner radius, half width [m]
  std::vector<CageStart> start_;     ///< of each segment
  double slip_ = 0.0;                ///< Σ N u of all segments now [W]
  Vec3 mass_centre_ = Vec3::Zero();  ///< from the geometric center, axes of the cage [m]
  int load_slip_ = -1;               ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_cage(const ScenePlan& plan) {
  if (!plan.has(Effect::CageMotion)) return nullptr;
  return std::make_unique<Cage>();
}

std::span<const LedgerTerm* const> cage_terms() { return kTerms; }

}  // namespace adore::dynamics
