#include "dynamics/element_masses.hpp"

#include "base/errors.hpp"
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
  out.off_centre = !out.arm.isZero(0.0);
  return out;
}

}  // namespace

ElementMasses::ElementMasses(const bearing::Bearing& bearing) {
  const bool rollers = bearing.rollers() != nullptr;
  const auto arm = [&](const bearing::Inertia& given, double at) {
    return -given.geometric_centre[0] - at;
  };
  if (bearing.first_inertia)
    all_.push_back(
        element_mass(*bearing.first_inertia,
                     arm(*bearing.first_inertia, rollers ? bearing.roller_mass_offset : 0.0)));
  const bearing::Inertia& given = bearing.element_inertia;
  all_.push_back(element_mass(given, rollers ? 0.0 : arm(given, 0.0)));
}

bool ElementMasses::off_centre() const noexcept {
  return std::any_of(all_.begin(), all_.end(),
                     [](const ElementMass& one) { return one.off_centre; });
}

}  // namespace adore::dynamics
