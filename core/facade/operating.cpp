#include "facade/operating.hpp"

#include "thermal/operating.hpp"

#include <utility>

namespace adore::facade {

bearing::Bearing at_work(const bearing::Bearing& as_built) {
  if (!as_built.rollers) return thermal::operating_bearing(as_built);
  bearing::Bearing out = as_built;
  bearing::RollerGeometry& rollers = *out.rollers;
  const bool cone =
      as_built.type == bearing::Type::Tapered || as_built.type == bearing::Type::SphericalTapered;
  thermal::OperatingRollers operating = thermal::operating_roller_bearing(
      as_built,
      {rollers.diameter, rollers.length, rollers.crown_radius, rollers.pitch_diameter,
       rollers.clearance},
      {rollers.race_radius(bearing::kOuter), rollers.race_radius(bearing::kInner)},
      cone ? rollers.race_angle[bearing::kOuter] : 0.0);
  const thermal::RollerSizes& sizes = operating.rollers.geometry;
  rollers.diameter = sizes.diameter;
  rollers.length = sizes.length;
  rollers.crown_radius = sizes.crown_radius;
  rollers.pitch_diameter = sizes.pitch_diameter;
  rollers.clearance = sizes.clearance;
  out.operating = std::move(operating.report);
  return out;
}

}  // namespace adore::facade
