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
    start_ = cage_start(nominal_cage_speed(scene.bearing), cage.speed_ratio, cage.whirl_ratio,
                        {mean_x, 0.0, 0.0}, cage.start_offset, cage.start_angles);
  }

  void start(std::span<double> y) const override {
    for (const FreeBody& segment : segments_)
      segment.start(y, start_.mass_centre, start_.mass_centre_velocity, start_.orientation,
                    start_.omega_body);
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
  std::vector<FreeBody> segments_;  ///< never moved once declared: blocks and border know them
  CageStart start_;
  double off_middle_ = 0.0;  ///< axial place of mass centres from the middles of the elements [m]
  int load_slip_ = -1;       ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_cage(const ScenePlan& plan) {
  if (!plan.has(Effect::CageMotion)) return nullptr;
  return std::make_unique<Cage>();
}

}  // namespace adore::dynamics
