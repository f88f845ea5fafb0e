#pragma once

#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "contact/cage_inertia.hpp"
#include "contact/groove.hpp"
#include "contact/make_angle_law.hpp"
#include "dynamics/system.hpp"
#include "integrators/stepper.hpp"
#include "runs/system_ode.hpp"
#include "statics/ball_statics.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

/// An angular-contact ball bearing with an outer-guided cage, its plan and a run, for tests and
/// benchmarks.
namespace adore::fixture {

inline bearing::Material steel() {
  bearing::Material m;
  m.name = "bearing steel";
  m.density = 7800.0;
  m.elastic_modulus = 2.06e11;
  m.poisson_ratio = 0.3;
  return m;
}

inline bearing::Inertia ball_inertia(double diameter, double density) {
  bearing::Inertia result;
  result.mass = density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
  result.moments = bearing::Vec3::Constant(0.1 * result.mass * diameter * diameter);
  return result;
}

/// D 12.7 mm, d_m 95 mm, 25 degrees, 10000 rpm, 1500 N thrust and 500 N radial load.
inline bearing::Bearing angular_contact(int balls = 18, double pitch_diameter = 0.095) {
  bearing::Bearing b;
  b.run_id = "test";
  b.balls().count = balls;
  b.balls().diameter = 0.0127;
  b.balls().pitch_diameter = pitch_diameter;
  b.balls().contact_angle = 25.0 * std::numbers::pi / 180.0;
  b.balls().groove_factor = {0.523, 0.52};
  b.balls().clearance = 2.0 * 0.0127 * 0.043 * (1.0 - std::cos(b.balls().contact_angle));
  b.balls().shoulder_diameter = {0.1, 0.09};
  b.element_material = steel();
  b.race_material = {steel(), steel()};
  b.element_inertia = ball_inertia(b.balls().diameter, 7800.0);
  b.constraints.load = {1500.0, 0.0, 500.0, 0.0, 0.0};
  b.constraints.displacement_given = {false, false, false, true, true};
  b.speed = {0.0, 10000.0 * std::numbers::pi / 30.0};
  b.spin_rule = bearing::SpinRule::RaceControl;
  using Form = bearing::TractionCurve::Form;
  b.race_traction = {Form::TwoSlope, 0.0, 0.1, -0.002, 0.0, 0.5};
  b.pocket_traction = bearing::TractionCurve{Form::Exponential, -0.05, 0.0, 2.0, 0.05, 0.0};
  b.land_traction = bearing::TractionCurve{Form::Exponential, -0.06, 0.0, 1.0, 0.06, 0.0};

  bearing::Cage cage;
  cage.outer_diameter = pitch_diameter + 0.005;
  cage.inner_diameter = pitch_diameter - 0.004;
  cage.width = 0.02;
  cage.pocket_clearance_1 = cage.pocket_clearance_2 = 3e-4;
  using Guide = bearing::GuideLand::Guide;
  cage.lands = {{Guide::Outer, cage.outer_diameter, 0.003, 0.01, 4e-4, {}, {}},
                {Guide::Outer, cage.outer_diameter, 0.003, -0.01, 4e-4, {}, {}}};
  cage.material = steel();
  cage.inertia =
      contact::cage_inertia(cage, balls, b.balls().diameter, b.balls().pitch_diameter, 7800.0);
  b.cage = cage;
  return b;
}

inline scene::ScenePlan plan_with(std::initializer_list<scene::Effect> effects) {
  scene::ScenePlan plan;
  for (const scene::Effect effect : effects) plan.effects.push_back({effect, "", true, "test"});
  return plan;
}

inline scene::ScenePlan full_plan() {
  using enum scene::Effect;
  return plan_with({RaceContact, RaceTraction, PocketContact, PocketTraction, LandContact,
                    LandTraction, Gravity, CageMotion, WearIntegrals});
}

inline statics::StaticSolution statics_of(const bearing::Bearing& b, double fixed_angle,
                                          statics::Control control = statics::Control::FromBearing,
                                          double first_azimuth = 0.0) {
  statics::BallStaticsOptions options;
  options.curvature = statics::Curvature::Potential;
  options.fixed_angle = {fixed_angle, fixed_angle};
  options.control = control;
  options.first_azimuth = first_azimuth;
  return statics::solve_ball_statics(b, options);
}

/// Hertz constants over the contact angle, as the motion has them.
inline std::array<contact::HertzAngleLaw, 2> angle_laws(const bearing::Bearing& b) {
  std::array<contact::HertzAngleLaw, 2> laws;
  for (std::size_t j = 0; j < 2; ++j)
    laws[j] =
        contact::make_angle_law(b.balls(), static_cast<int>(j),
                                bearing::contact_modulus(b.element_material, b.race_material[j]));
  return laws;
}

inline dynamics::System make_system(const bearing::Bearing& b, const scene::ScenePlan& plan,
                                    const statics::StaticSolution& solution,
                                    const dynamics::SystemOptions& options = {}) {
  const double angle = b.balls().contact_angle;
  return {b, plan, solution, {angle, angle}, options};
}
inline dynamics::System make_system(const bearing::Bearing& b, const scene::ScenePlan& plan,
                                    const dynamics::SystemOptions& options = {}) {
  return make_system(b, plan, statics_of(b, b.balls().contact_angle), options);
}

/// The system as a stepper sees it.
using Adapter = runs::SystemOde;

struct RunResult {
  std::vector<double> y;
  integrators::Counters counters;
};

/// Integrates from y0 at t = 0 to `end`. The energy ledger starts at y0.
inline RunResult run(dynamics::System& system, std::vector<double> y0, double end, double tolerance,
                     const char* method = "rkf5") {
  Adapter adapter(system);
  system.set_start(0.0, y0);
  const auto stepper = integrators::make_stepper(method);
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y0, control);
  while (stepper->time() < end) stepper->step(end);
  const auto state = stepper->state();
  return {{state.begin(), state.end()}, stepper->counters()};
}

}  // namespace adore::fixture
