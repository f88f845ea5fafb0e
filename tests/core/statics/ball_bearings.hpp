#pragma once

#include "bearing/bearing.hpp"

#include <numbers>

/// Bearings for the tests of the ball statics.
namespace ball_bearings {

using adore::bearing::Bearing;

inline adore::bearing::Material steel() {
  adore::bearing::Material m;
  m.elastic_modulus = 206e9;
  m.poisson_ratio = 0.3;
  m.density = 7800.0;
  return m;
}

/// Solid balls, both races and balls of steel; speeds in rpm.
inline Bearing make(int count, double D, double dm, double fo, double fi, double angle_deg,
                    double clearance = 0.0, double inner_rpm = 0.0, double outer_rpm = 0.0) {
  constexpr double kPi = std::numbers::pi;
  Bearing b;
  b.balls().count = count;
  b.balls().diameter = D;
  b.balls().pitch_diameter = dm;
  b.balls().groove_factor = {fo, fi};
  b.balls().contact_angle = angle_deg * kPi / 180.0;
  b.balls().clearance = clearance;
  b.element_material = steel();
  b.race_material = {steel(), steel()};
  b.element_inertia.mass = 7800.0 * kPi * D * D * D / 6.0;
  b.element_inertia.moments.setConstant(0.1 * b.element_inertia.mass * D * D);
  b.speed = {outer_rpm * kPi / 30.0, inner_rpm * kPi / 30.0};
  return b;
}

inline Bearing angular_contact_218(double rpm = 0.0) {
  return make(16, 0.022225, 0.12526, 0.5232, 0.5232, 40.0, 0.0, rpm);
}
inline Bearing spindle(double rpm = 0.0) {
  return make(18, 0.00873125, 0.054, 0.525, 0.515, 25.0, 0.0, rpm);
}
inline Bearing deep_groove(double clearance, double rpm = 0.0) {
  return make(9, 0.0127, 0.065, 0.52, 0.52, 0.0, clearance, rpm);
}

inline Bearing& load(Bearing& b, double x, double y, double z, double about_y = 0.0,
                     double about_z = 0.0) {
  b.constraints.load = {x, y, z, about_y, about_z};
  return b;
}
inline Bearing& hold(Bearing& b, std::size_t direction, double displacement) {
  b.constraints.displacement_given[direction] = true;
  b.constraints.displacement[direction] = displacement;
  return b;
}

}  // namespace ball_bearings
