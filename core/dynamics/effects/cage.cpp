#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/pockets.hpp"
#include "dynamics/rigid_body.hpp"
#include "dynamics/state_access.hpp"
#include "scene/ledger_terms.hpp"

#include <cmath>

/// The cage as a free rigid body: six degrees of freedom and its total rotation.
namespace adore::dynamics {
namespace {

/// Cage: mass centre from the base origin and its velocity in base axes, quaternion body -> base, ω
/// in body axes, ∫ω_x dt. Empty slices (count 0) without cage motion.
struct CageSlices {
  Slice position, velocity, orientation, omega, rotation;
};

class CageKinematics final : public EffectBlock {
 public:
  explicit CageKinematics(const CageSlices& slices) : s_(slices) {}
  void apply(Evaluation& e) noexcept override;

 private:
  CageSlices s_;
};

/// Newton and Euler for the cage: inertia diagonal in body axes.
class CageMotion final : public EffectBlock {
 public:
  CageMotion(const CageSlices& slices, const bearing::Inertia& inertia)
      : s_(slices), inertia_(inertia) {}
  void apply(Evaluation& e) noexcept override;

 private:
  CageSlices s_;
  bearing::Inertia inertia_;
};

void CageKinematics::apply(Evaluation& e) noexcept {
  CageState& c = e.cage;
  c.position = vector_at(e.y, s_.position);
  c.velocity = vector_at(e.y, s_.velocity);
  c.to_base = rotation_matrix(normalise(quaternion_at(e.y, s_.orientation)));
  c.omega_body = vector_at(e.y, s_.omega);
  c.omega = c.to_base * c.omega_body;
}

void CageMotion::apply(Evaluation& e) noexcept {
  const CageState& c = e.cage;
  const Vec3 omega_dot =
      euler_rate(inertia_.moments, c.omega_body, c.to_base.transpose() * c.moment);
  const Vec3 acceleration = c.force / inertia_.mass;
  store_at(e.dydt, s_.position, c.velocity);
  store_at(e.dydt, s_.velocity, acceleration);
  store_at(e.dydt, s_.orientation,
           quaternion_rate(quaternion_at(e.y, s_.orientation), c.omega_body));
  store_at(e.dydt, s_.omega, omega_dot);
  e.dydt[s_.rotation.first] = c.omega_body[0];
  e.valid = e.valid && std::isfinite(acceleration.sum() + omega_dot.sum() + c.velocity.sum());
}

class Cage final : public SceneEffect, public BorderBody {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.bearing.cage.has_value(), "the plan moves a cage that the bearing does not have");
    cage_ = *scene.bearing.cage;
    demand(cage_.inertia.mass > 0.0 && cage_.inertia.moments.minCoeff() > 0.0,
           "the cage needs a positive mass and positive moments of inertia");
    s_.position = scene.state("cage.position", "m", 3, ScaleKind::Length, kBorder);
    s_.velocity = scene.state("cage.velocity", "m/s", 3, ScaleKind::Velocity, kBorder);
    s_.orientation = scene.quaternion("cage.quaternion", kBorder);
    s_.omega = scene.state("cage.omega", "rad/s", 3, ScaleKind::Rate, kBorder);
    s_.rotation = scene.state("cage.rotation", "rad", 1, ScaleKind::Angle, kBorder);
    scene.border_body(*this);
    scene.block<CageKinematics>(Phase::Kinematics, kMotionCost, false, s_);
    scene.block<CageMotion>(Phase::Motion, kMotionCost, false, s_, cage_.inertia);
    const ScenePlan& plan = scene.plan;
    if ((plan.has(Effect::PocketTraction) || plan.has(Effect::LandTraction)) &&
        plan.has(Effect::WearIntegrals))
      scene.integral(load_slip_, "cage.load_slip", "J", &scene.e.cage.load_slip);
    double mean_x = 0.0;
    for (const statics::StaticBall& ball : scene.statics.balls)
      mean_x += ball.x / static_cast<double>(scene.statics.balls.size());
    start_ = cage_start(nominal_cage_speed(scene.bearing), cage_.speed_ratio, cage_.whirl_ratio,
                        {mean_x, 0.0, 0.0}, cage_.start_offset, cage_.start_angles);
  }

  void start(std::span<double> y) const override {
    store_at(y.data(), s_.position, start_.mass_centre);
    store_at(y.data(), s_.velocity, start_.mass_centre_velocity);
    store_at(y.data(), s_.orientation, start_.orientation);
    store_at(y.data(), s_.omega, start_.omega_body);
  }

  void store(const Evaluation& e, EnergyLedger& energy) const override {
    const Vec3& w = e.cage.omega_body;
    energy.accumulate(terms::kKinetic, 0.5 * cage_.inertia.mass * e.cage.velocity.squaredNorm() +
                                           0.5 * w.dot(cage_.inertia.moments.cwiseProduct(w)));
  }

  void carry(const Evaluation& e, Momenta& momenta) const override {
    const Vec3 p = cage_.inertia.mass * e.cage.velocity;
    momenta.add(p, e.cage.position.cross(p) +
                       e.cage.to_base * cage_.inertia.moments.cwiseProduct(e.cage.omega_body));
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    if (snapshot.cages.empty()) snapshot.cages.emplace_back();
    CageSnapshot& cage = snapshot.cages.front();
    double mean_x = 0.0;
    for (const ElementSnapshot& element : snapshot.elements)
      mean_x += element.x / static_cast<double>(snapshot.elements.size());
    cage.position = e.cage.position - Vec3(mean_x, 0.0, 0.0);
    cage.velocity = e.cage.velocity;
    cage.acceleration = vector_at(e.dydt, s_.velocity);
    cage.orientation = quaternion_at(e.y, s_.orientation);
    cage.omega = e.cage.omega;
    cage.total_rotation = e.y[s_.rotation.first];
    snapshot.power.qv_cage = integral_at(e, load_slip_);
  }

  /// Action = reaction: velocity by F/m, ω by I⁻¹ Rᵀ M.
  void add_share(const Evaluation& e, std::size_t i, const Vec3& force, const Vec3& moment,
                 int first, double* row) const noexcept override {
    const Vec3 on_cage = -((e.element_centre(i) - e.cage.position).cross(force) + moment);
    const Vec3 rates = (e.cage.to_base.transpose() * on_cage).cwiseQuotient(cage_.inertia.moments);
    for (int k = 0; k < 3; ++k) {
      row[s_.velocity.first - first + k] -= force[k] / cage_.inertia.mass;
      row[s_.omega.first - first + k] += rates[k];
    }
  }

 private:
  bearing::Cage cage_;
  CageSlices s_;
  CageStart start_;
  int load_slip_ = -1;  ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_cage(const ScenePlan& plan) {
  if (!plan.has(Effect::CageMotion)) return nullptr;
  return std::make_unique<Cage>();
}

}  // namespace adore::dynamics
