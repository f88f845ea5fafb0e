#include "dynamics/element_masses.hpp"

#include "base/errors.hpp"
#include "bearing/element_inertia.hpp"
#include "dynamics/rigid_body.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace adore::dynamics {
namespace {

/// @param along_axis of the arm [m]
ElementMass element_mass(const bearing::Inertia& given, double along_axis) {
  demand(given.mass > 0.0 && given.moments.minCoeff() > 0.0,
         "an element needs a positive mass and positive moments of inertia");
  ElementMass out;
  const RigidBody rigid = rigid_body(given);
  out.mass = rigid.mass;
  out.inertia = rigid.inertia;
  out.inverse = out.inertia.inverse();
  if (given.geometric_centre.isZero(0.0)) return out;
  out.arm = -given.geometric_centre;
  out.arm[0] = along_axis;
  out.has_eccentric_mass = !out.arm.isZero(0.0);
  return out;
}

}  // namespace

ElementMasses::ElementMasses(const bearing::Bearing& bearing) {
  const bool rollers = bearing.rollers() != nullptr;
  std::size_t own = bearing.first_inertia ? 2 : 1;
  if (bearing::has_unequal_balls(bearing)) own = static_cast<std::size_t>(bearing.element_count());
  for (std::size_t i = 0; i < own; ++i) {
    const bearing::Inertia given = bearing::inertia_of(bearing, i);
    const bool nominal = i > 0 || !bearing.first_inertia;
    const double at = !rollers  ? -given.geometric_centre[0]
                      : nominal ? 0.0
                                : -given.geometric_centre[0] - bearing.roller_mass_offset;
    distinct_masses_.push_back(element_mass(given, at));
  }
}

bool ElementMasses::has_eccentric_mass() const noexcept {
  return std::any_of(distinct_masses_.begin(), distinct_masses_.end(),
                     [](const ElementMass& one) { return one.has_eccentric_mass; });
}

}  // namespace adore::dynamics
