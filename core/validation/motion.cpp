#include "validation/motion.hpp"

#include "base/errors.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::validation {

using dynamics::Evaluation;

SmallScene::SmallScene() {
  bearing::BallGeometry& balls = bearing.balls();
  balls.count = 1;
  balls.diameter = 0.01;
  balls.pitch_diameter = 0.06;
  balls.clearance = 1e-3;  // out of reach of both races
  balls.groove_factor = {0.52, 0.52};
  balls.groove_plane = {0.0, 0.0};
  bearing.element_inertia.mass = 1.0;
  bearing.element_inertia.moments = Vec3::Ones();
  for (bearing::Material* material :
       {&bearing.element_material, &bearing.race_material[0], &bearing.race_material[1]}) {
    material->elastic_modulus = 2e11;
    material->poisson_ratio = 0.3;
    material->density = 7800.0;
  }
  start.max_stiffness = 1.0;  // scales are those of the case
  start.balls.resize(1);
  start.balls[0].r = 0.5 * balls.pitch_diameter;
  options.moving_angle = false;
}

void SmallScene::have(std::initializer_list<scene::Effect> effects) {
  for (const scene::Effect effect : effects) plan.effects.push_back({effect, "", true, ""});
}

void add(SmallScene& scene, dynamics::CustomSceneAction action) {
  scene.laws.push_back(dynamics::make_action_effect(std::move(action)));
}

dynamics::WallContact press(Evaluation& e, std::size_t element, const dynamics::BodyState& body,
                            const Vec3& m, double radius, const contact::CappedHertz& normal,
                            double overlap, const tribology::TractionLaw& law) {
  const dynamics::WallContact contact =
      dynamics::wall_contact(e, element, body, m, radius, normal, overlap, law);
  dynamics::apply(e, element, contact);
  return contact;
}

void add_cage(SmallScene& scene, double mass, const Vec3& moments) {
  bearing::Cage& cage = scene.bearing.cage.emplace();
  const double pitch = scene.bearing.balls().pitch_diameter;
  cage.outer_diameter = 4.0 * pitch;  // pockets without an end
  cage.inner_diameter = 1e-3 * pitch;
  cage.width = 0.02;
  cage.pocket_clearance_1 = cage.pocket_clearance_2 = 1e-3;
  cage.material = scene.bearing.race_material[0];
  cage.inertia.mass = mass;
  cage.inertia.moments = moments;
  scene.have({scene::Effect::CageMotion});
}

void set_cage_start(Motion& motion, const Vec3& position, const Vec3& velocity,
                    const Quat& attitude, const Vec3& omega) {
  for (int k = 0; k < 3; ++k) {
    const auto n = static_cast<std::size_t>(k);
    motion.start_of("cage.position", n) = position[k];
    motion.start_of("cage.velocity", n) = velocity[k];
    motion.start_of("cage.omega", n) = omega[k];
  }
  for (std::size_t k = 0; k < 4; ++k) motion.start_of("cage.quaternion", k) = attitude[k];
  motion.scale("cage.omega", omega.norm());
  motion.scale("cage.rotation", 1e6);  // ∫ω_x follows from ω
}

void set_hertz_constant(SmallScene& scene, std::size_t race, double K) {
  bearing::Material &element = scene.bearing.element_material,
                    &own = scene.bearing.race_material[race];
  const auto curvature = contact::race_curvature(scene.bearing.balls(), static_cast<int>(race),
                                                 scene.hertz_angle[race]);
  element.poisson_ratio = own.poisson_ratio = 0.0;
  element.elastic_modulus = 1e40;
  own.elastic_modulus = K / contact::hertz_constants(curvature, 1.0).K;
}

Motion::Motion(SmallScene scene)
    : system_([&] {
        scene.laws.push_back(dynamics::make_view_effect(view_));
        return dynamics::System(scene.bearing, scene.plan, scene.start, scene.hertz_angle,
                                scene.options, scene.laws);
      }()) {
  start = system_.initial_state();
  const auto scales = system_.layout().scales();
  scales_.assign(scales.begin(), scales.begin() + controlled_size());
  rates_.resize(start.size());
}

const Evaluation& Motion::evaluate(double t, const double* y) {
  if (system_.rhs(t, y, rates_.data()) != dynamics::RhsStatus::Ok) system_.check_state(t, y);
  return *view_.e;
}

int Motion::at(std::string_view group) const {
  for (const auto& one : system_.layout().groups())
    if (one.name == group) return one.slice.first;
  throw InternalError("the state has no " + std::string(group));
}

void Motion::scale(std::string_view group, double size) {
  for (const auto& one : system_.layout().groups())
    if (one.name == group)
      std::fill_n(scales_.begin() + one.slice.first, one.slice.count,
                  size == 0.0 ? 1.0 : std::abs(size));
}

void Motion::place(std::size_t i, const Vec3& position, const Vec3& velocity, const Vec3& omega) {
  const double theta = azimuth(position);
  const Vec3 e_r = radial_direction(theta), e_t = circumferential_direction(theta);
  const double r = position.dot(e_r);
  start_of("element.x", i) = position[0];
  start_of("element.r", i) = r;
  start_of("element.theta", i) = theta;
  start_of("element.x_dot", i) = velocity[0];
  start_of("element.r_dot", i) = velocity.dot(e_r);
  start_of("element.theta_dot", i) = velocity.dot(e_t) / r;
  start_of("element.omega_x", i) = omega[0];
  start_of("element.omega_r", i) = omega.dot(e_r);
  start_of("element.omega_theta", i) = omega.dot(e_t);
}

integrators::EvalStatus Motion::rhs(double t, const double* y, double* dydt) noexcept {
  ++evaluations_;
  switch (system_.rhs(t, y, dydt)) {
    case dynamics::RhsStatus::Ok:
      return integrators::EvalStatus::Ok;
    case dynamics::RhsStatus::Retry:
      return integrators::EvalStatus::Retry;
    case dynamics::RhsStatus::Fail:
      break;
  }
  return integrators::EvalStatus::Fail;
}

Solution Motion::solve(const Problem& problem, std::span<const double> times) {
  Solution solution = validation::solve(problem, times);
  stepper_name_ = problem.stepper;
  stepper_work_.add(solution.work);
  return solution;
}

void Motion::add_evaluation_record(Json& result) const {
  Json& evidence = result["evaluation"];
  evidence["entry"] = "adore::dynamics::System::rhs";
  if (!stepper_name_.empty()) evidence["stepper"] = stepper_name_;
  const auto count = [&](const char* key, long value) {
    evidence[key] = evidence.value(key, 0L) + value;
  };
  count("system_evaluations", evaluations_);
  count("start_evaluations", stepper_work_.start_evaluations);
  count("steps", stepper_work_.steps);
  count("repeated_steps", stepper_work_.repeated_steps);
}

}  // namespace adore::validation
