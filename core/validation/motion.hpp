#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/given_action.hpp"
#include "dynamics/system.hpp"
#include "validation/trajectory.hpp"

#include <functional>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <vector>

/// The trajectories of the reference cases are motions of small bearings: a case puts together a
/// Bearing, the effects of its scene and the start, and the shipped steppers integrate
/// dynamics::System. Forces that no bearing has come from given actions, which evaluate the
/// shipped contact and traction laws.
namespace adore::validation {

class Motion;

struct SmallScene {
  bearing::Bearing bearing;
  scene::ScenePlan plan;
  statics::StaticSolution start;        ///< elements, and displacement of the inner race
  std::array<double, 2> hertz_angle{};  ///< angle of the frozen Hertz constants [rad]
  scene::SystemOptions options;
  std::vector<dynamics::EffectMaker> laws;

  SmallScene();
  void have(std::initializer_list<scene::Effect> effects);
};

void add(SmallScene& scene, dynamics::CustomSceneAction action);

/// A plane or cylinder of a body, pressed on an element along m (base axes) with overlap; friction
/// by `law`. Adds the shipped contact of ball and wall (dynamics/effects/pockets.hpp) to what acts
/// on the element; returns it.
dynamics::WallContact press(dynamics::Evaluation& e, std::size_t element,
                            const dynamics::BodyState& body, const Vec3& m, double radius,
                            const contact::CappedHertz& normal, double overlap,
                            const tribology::TractionLaw& law);
/// Linear spring Q = k δ as the tangent branch of the shipped pocket law.
[[nodiscard]] inline contact::CappedHertz linear_spring(double stiffness) {
  return {0.0, 0.0, stiffness, 0.0};
}

/// A cage that moves freely, far from element and races.
void add_cage(SmallScene& scene, double mass, const Vec3& moments);
/// @param omega on its own axes
void set_cage_start(Motion& motion, const Vec3& position, const Vec3& velocity,
                    const Quat& attitude, const Vec3& omega);

/// Poisson's ratio 0 and the modulus for which the Hertz constant of race j is K [N m^-1.5]; the
/// element is rigid.
void set_hertz_constant(SmallScene& scene, std::size_t race, double K);

/// A scene in motion, as the steppers see it.
class Motion final : public integrators::OdeSystem {
 public:
  explicit Motion(SmallScene scene);

  /// Calls System::rhs; what it leaves stays until the next evaluation. @throws SolverError when
  /// the state is not valid
  const dynamics::Evaluation& evaluate(double t, const double* y);
  [[nodiscard]] const State& rates() const noexcept { return rates_; }
  [[nodiscard]] const dynamics::RaceContactModel& race(std::size_t j) const noexcept {
    return (*view_.races)[j];
  }
  [[nodiscard]] const dynamics::SceneView& view() const noexcept { return view_; }
  [[nodiscard]] double mass() const noexcept { return system_.bearing().element_inertia.mass; }

  /// First component of a group of the state ("element.r").
  [[nodiscard]] int at(std::string_view group) const;
  void scale(std::string_view group, double size);
  /// Component `k` of a group of the start.
  double& start_of(std::string_view group, std::size_t k = 0) {
    return start[static_cast<std::size_t>(at(group)) + k];
  }
  /// Start of ball i; base axes.
  void place(std::size_t i, const Vec3& position, const Vec3& velocity, const Vec3& omega);
  State start;  ///< Motion at t = 0; initially that of the scene
  [[nodiscard]] Problem problem() { return {*this, start}; }
  /// Integrates from `start`. Keeps the work of the steppers for evidence().
  [[nodiscard]] Solution solve(const Problem& problem, std::span<const double> times);
  /// "evaluation" of the results: what was integrated, by which method, and its work.
  /// Adds to what is there.
  void add_evaluation_record(Json& result) const;

  [[nodiscard]] int size() const noexcept override { return system_.layout().size(); }
  [[nodiscard]] int controlled_size() const noexcept override {
    return system_.layout().controlled_size();
  }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  integrators::EvalStatus rhs(double t, const double* y, double* dydt) noexcept override;
  bool project(double t, double* y) noexcept override { return system_.project(t, y); }

 private:
  dynamics::SceneView view_;
  dynamics::System system_;
  std::vector<double> scales_;
  State rates_;
  long evaluations_ = 0;  ///< by steppers
  StepperWork stepper_work_;
  std::string stepper_name_;
};

}  // namespace adore::validation
