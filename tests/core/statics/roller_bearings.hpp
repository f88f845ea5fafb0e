#pragma once

#include "base/constants.hpp"
#include "contact/roller_inertia.hpp"
#include "contact/roller_shape.hpp"
#include "contact/tapered_geometry.hpp"
#include "statics/roller_statics.hpp"

#include <cmath>
#include <numbers>

/// Roller bearings of the tests and benchmarks: the templates of resources/decks, in SI.
namespace roller_bearings {

using adore::kDegree;
using adore::bearing::Bearing;
using adore::bearing::Type;

inline void finish(Bearing& b, double rpm) {
  for (auto* m : {&b.element_material, &b.race_material[0], &b.race_material[1]}) {
    m->elastic_modulus = 206e9;
    m->poisson_ratio = 0.3;
    m->density = 7800.0;
  }
  const auto i =
      adore::contact::roller_inertia(adore::contact::roller_profile(*b.rollers()), 7800.0);
  b.element_inertia.mass = i.mass;
  b.element_inertia.moments = {i.axial, i.transverse, i.transverse};
  b.roller_mass_offset = i.mass_centre;
  b.speed = {0.0, rpm * std::numbers::pi / 30.0};
}

/// Straight raceways that recede beyond a flat land, in the middle of the contact.
inline Bearing on_crowned_races(Bearing b) {
  b.rollers()->race_crown_radius = {0.8, 0.5};
  b.rollers()->race_central_length = {0.004, 0.003};
  return b;
}

inline Bearing cylindrical(double rpm, double clearance = 2e-5) {
  Bearing b;
  b.type = Type::Cylindrical;
  adore::bearing::RollerGeometry g;
  g.count = 14;
  g.diameter = 0.011;
  g.crown_radius = 2.0;
  g.length = 0.012;
  g.central_length = 0.008;
  g.corner_radius = {3e-4, 3e-4};
  g.pitch_diameter = 0.06;
  g.clearance = clearance;
  g.land_width = {0.012, 0.012};
  for (int side = 0; side < 2; ++side)
    g.flange[0][static_cast<std::size_t>(side)] = adore::bearing::Flange{0.5 * kDegree, 0.0015};
  g.flange_play = {5e-5, 0.0};
  b.elements = g;
  finish(b, rpm);
  b.constraints.displacement_given = {true, false, false, true, true};
  b.constraints.load = {0.0, 0.0, 5000.0, 0.0, 0.0};
  return b;
}

/// Ends of 100 mm and 0.2 degrees of layback: the dome touches the rib's face.
inline Bearing tapered(double rpm, double layback = 0.2 * kDegree) {
  Bearing b;
  b.type = Type::Tapered;
  adore::bearing::RollerGeometry g;
  g.count = 17;
  g.diameter = 0.0095;
  g.crown_radius = 5.0;
  g.length = 0.014;
  g.central_length = 0.010;
  g.corner_radius = {4e-4, 4e-4};
  g.end_radius = {0.100, 0.100};
  g.race_angle = {14.2 * kDegree, 10.35 * kDegree};
  const auto t = adore::contact::tapered_geometry(g.diameter, g.race_angle);
  g.pitch_diameter = t.pitch_diameter;
  g.half_angle = t.half_angle;
  g.axis_angle = t.axis_angle;
  g.land_width = {0.014, 0.014};
  g.flange[1][0] = adore::bearing::Flange{layback, 0.002};
  b.elements = g;
  finish(b, rpm);
  b.constraints.displacement_given = {false, false, false, true, true};
  b.constraints.load = {2000.0, 0.0, 5000.0, 0.0, 0.0};
  return b;
}

/// A row of barrels.
inline Bearing spherical(double rpm, double clearance = 3e-5) {
  Bearing b;
  b.type = Type::Spherical;
  adore::bearing::RollerGeometry g;
  g.count = 15;
  g.diameter = 0.0105;
  g.shape = adore::bearing::RollerShape::Arc;
  g.crown_radius = 0.036;
  g.length = 0.011;
  g.corner_radius = {3e-4, 3e-4};
  g.pitch_diameter = 0.06;
  g.clearance = clearance;
  g.groove_factor = {0.51, 0.51};
  g.axis_angle = 8.0 * kDegree;
  g.race_angle = {g.axis_angle, g.axis_angle};
  b.elements = g;
  finish(b, rpm);
  b.constraints.displacement_given = {true, false, false, true, true};
  b.constraints.load = {0.0, 0.0, 5000.0, 0.0, 0.0};
  return b;
}

/// Barrels between cones of the tapered bearing, with its rib.
inline Bearing spherical_tapered(double rpm) {
  Bearing b = tapered(rpm);
  b.type = Type::SphericalTapered;
  auto& g = *b.rollers();
  g.shape = adore::bearing::RollerShape::Arc;
  g.crown_radius = 0.040;
  g.length = 0.012;
  g.central_length = 0.0;
  g.end_radius = {0.105, 0.105};
  g.land_width = {};
  g.groove_factor = {0.51, 0.51};
  finish(b, rpm);
  return b;
}

/// Without loads and with all freedoms but x of the cylindrical bearing, which nothing holds.
inline Bearing unloaded(Bearing b) {
  b.constraints.load.fill(0.0);
  b.constraints.displacement_given.fill(false);
  b.constraints.displacement_given[0] = b.type == Type::Cylindrical;
  return b;
}

}  // namespace roller_bearings
