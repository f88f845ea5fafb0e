#pragma once

#include "../statics/roller_bearings.hpp"
#include "dynamics/roller_start.hpp"
#include "system_fixture.hpp"

#include <cmath>
#include <memory>
#include <utility>

/// Roller bearings in motion: those of the statics tests, with a cage and laws of traction.
namespace roller_scene {

using namespace adore;
using bearing::Bearing;

/// Windows of 0.25 mm play, guided by the outer race.
inline void add_cage(Bearing& b) {
  const double pitch = b.pitch_diameter(), D = b.element_diameter();
  bearing::Cage cage;
  cage.outer_diameter = pitch + 0.5 * D;
  cage.inner_diameter = pitch - 0.2 * D;
  cage.width = b.rollers()->length + 0.004;
  cage.pocket = bearing::PocketShape::Rectangular;
  cage.pocket_clearance_1 = 2.5e-4;
  cage.cone_angle = b.rollers()->axis_angle;
  using Guide = bearing::GuideLand::Guide;
  cage.lands = {{Guide::Outer, cage.outer_diameter, 0.002, -0.5 * cage.width, 3e-4, {}, {}},
                {Guide::Outer, cage.outer_diameter, 0.002, 0.5 * cage.width, 3e-4, {}, {}}};
  cage.material = fixture::steel();
  b.cage = cage;
  b.cage->inertia = contact::cage_inertia(b);
}

inline void add_friction(Bearing& b) {
  using Form = bearing::TractionCurve::Form;
  b.race_traction = {Form::TwoSlope, 0.0, 0.1, -0.002, 0.0, 0.5};
  const bearing::TractionCurve sliding{Form::Exponential, -0.05, 0.0, 2.0, 0.05, 0.0};
  b.pocket_traction = b.land_traction = b.flange_traction = sliding;
}

inline scene::ScenePlan plan_of(std::initializer_list<scene::Effect> effects) {
  scene::ScenePlan plan = fixture::plan_with(effects);
  plan.rollers = true;
  return plan;
}
inline scene::ScenePlan with_friction() {
  using enum scene::Effect;
  return plan_of({RaceContact, RaceTraction, FlangeContact, FlangeTraction, PocketContact,
                  PocketTraction, LandContact, LandTraction, CageMotion, WearIntegrals,
                  MomentumLedger});
}
inline scene::ScenePlan frictionless() {
  using enum scene::Effect;
  return plan_of(
      {RaceContact, FlangeContact, PocketContact, LandContact, CageMotion, MomentumLedger});
}
inline scene::ScenePlan races_only() {
  using enum scene::Effect;
  return plan_of({RaceContact, FlangeContact, MomentumLedger});
}

/// A solved bearing, ready to move.
struct Scene {
  Bearing bearing;
  std::shared_ptr<const dynamics::RollerStaticResult> rollers;
  dynamics::System system;
};

inline Scene scene_of(Bearing b, scene::ScenePlan plan, int slices = 15, double first_azimuth = 0.0,
                      const dynamics::SystemOptions& of_system = {}, bool guide = true) {
  if (!b.rollers()->has_flange(0) && !b.rollers()->has_flange(1))
    for (auto& effect : plan.effects)
      if (effect.effect == scene::Effect::FlangeContact ||
          effect.effect == scene::Effect::FlangeTraction)
        effect.on = false;
  auto rollers = std::make_shared<dynamics::RollerStaticResult>();
  rollers->options.slices = slices;
  rollers->options.first_azimuth = first_azimuth;
  rollers->options.guide = guide;
  rollers->solution = statics::solve_roller_statics(b, rollers->options);
  dynamics::System system(b, plan, dynamics::static_start(*rollers, b), {}, of_system, {}, rollers);
  return {std::move(b), std::move(rollers), std::move(system)};
}

}  // namespace roller_scene
