#pragma once

#include "bearing/bearing.hpp"
#include "contact/tapered_geometry.hpp"
#include "core/statics/ball_bearings.hpp"

#include <numbers>

/// Roller bearings of the hard cases and imperfections, steel, rollers as solid cylinders.
namespace hard_rollers {

using adore::bearing::Bearing;
using adore::bearing::RollerGeometry;
using adore::bearing::RollerShape;
using adore::bearing::Type;

inline Bearing with(Type type, const RollerGeometry& g, double inner_rpm) {
  constexpr double kPi = std::numbers::pi;
  Bearing b;
  b.type = type;
  b.rollers = g;
  b.ball_material = ball_bearings::steel();
  b.race_material = {ball_bearings::steel(), ball_bearings::steel()};
  const double D = g.diameter;
  const double mass = 7800.0 * kPi * D * D * g.length / 4.0;
  const double across = mass * (D * D / 16.0 + g.length * g.length / 12.0);
  b.ball_inertia.mass = mass;
  b.ball_inertia.moments = {mass * D * D / 8.0, across, across};
  b.speed = {0.0, inner_rpm * kPi / 30.0};
  return b;
}

/// NU 209 size: both flanges on the outer race, none holds the inner race, so x is prescribed (0).
inline Bearing cylindrical(double clearance, double inner_rpm = 0.0) {
  RollerGeometry g;
  g.count = 16;
  g.diameter = 0.011;
  g.length = 0.012;
  g.crown_radius = 3.0;
  g.central_length = 0.008;
  g.corner_radius = {4e-4, 4e-4};
  g.pitch_diameter = 0.0655;
  g.clearance = clearance;
  g.land_width = {0.012, 0.012};
  g.flange[0] = {adore::bearing::Flange{0.01, 0.0015}, adore::bearing::Flange{0.01, 0.0015}};
  g.flange_play[0] = 5e-5;
  Bearing b = with(Type::Cylindrical, g, inner_rpm);
  b.constraints.displacement_given[0] = true;
  return b;
}

/// 30208 size, with the rib at the large end of the inner race.
inline Bearing tapered(double inner_rpm = 0.0) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  RollerGeometry g;
  g.count = 17;
  g.diameter = 0.0095;
  g.length = 0.014;
  g.crown_radius = 5.0;
  g.central_length = 0.010;
  g.end_radius = {0.135, 0.130};
  g.corner_radius = {4e-4, 4e-4};
  g.race_angle = {14.20 * kDegree, 10.35 * kDegree};
  const auto t = adore::contact::tapered_geometry(g.diameter, g.race_angle);
  g.pitch_diameter = t.pitch_diameter;
  g.half_angle = t.half_angle;
  g.axis_angle = t.axis_angle;
  g.land_width = {0.014, 0.014};
  g.flange[1][0] = adore::bearing::Flange{10.0 * kDegree, 0.002};
  return with(Type::Tapered, g, inner_rpm);
}

/// One row of barrels at 12 degrees.
inline Bearing spherical(double clearance = 0.0, double inner_rpm = 0.0) {
  RollerGeometry g;
  g.count = 16;
  g.diameter = 0.012;
  g.length = 0.012;
  g.shape = RollerShape::Arc;
  g.crown_radius = 0.040;
  g.corner_radius = {4e-4, 4e-4};
  g.axis_angle = 12.0 * std::numbers::pi / 180.0;
  g.race_angle = {g.axis_angle, g.axis_angle};
  g.groove_factor = {0.52, 0.52};
  g.pitch_diameter = 0.075;
  g.clearance = clearance;
  return with(Type::Spherical, g, inner_rpm);
}

}  // namespace hard_rollers
