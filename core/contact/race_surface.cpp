#include "contact/race_surface.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

namespace adore::contact {
namespace {

void require_radius(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0.0))
    throw InputError(
        fmt::format("race: the {} is {} m; it must be a positive number", name, value));
}

}  // namespace

RaceSurface cylinder_race(int side, double radius) { return cone_race(side, radius, 0.0); }

RaceSurface cone_race(int side, double radius_at_x0, double half_angle) {
  require_radius(radius_at_x0, "radius");
  if (!(std::abs(half_angle) < 1.57))
    throw InputError(fmt::format(
        "race: the half angle of the cone is {} rad; it must be between -π/2 and π/2", half_angle));
  RaceSurface race;
  race.side = side;
  race.radius = radius_at_x0;
  race.cos_angle = std::cos(half_angle);
  race.sin_angle = std::sin(half_angle);
  race.mid_r = radius_at_x0;
  race.along_x = race.cos_angle;
  race.along_r = -race.sin_angle;
  return race;
}

RaceSurface groove_race(int side, double groove_radius, double groove_x,
                        double groove_centre_radius) {
  require_radius(groove_radius, "groove radius");
  if (!std::isfinite(groove_x) || !std::isfinite(groove_centre_radius))
    throw InputError(fmt::format("race: the groove center ({}, {}) m must be finite", groove_x,
                                 groove_centre_radius));
  RaceSurface race;
  race.shape = RaceSurface::Shape::Groove;
  race.side = side;
  race.groove_radius = groove_radius;
  race.groove_x = groove_x;
  race.groove_centre_radius = groove_centre_radius;
  return race;
}

RaceSurface crowned_race(const RaceSurface& cone, double crown_radius, double land) {
  if (!(crown_radius > 0.0) || !(land >= 0.0))
    throw InputError(
        fmt::format("race: a crown radius of {} m and a straight part of {} m; the radius must be "
                    "positive and the straight part must not be negative",
                    crown_radius, land));
  RaceSurface race = cone;
  race.shape = RaceSurface::Shape::CrownedCone;
  race.crown_curvature = 1.0 / crown_radius;
  race.crown_land = land;
  return race;
}

}  // namespace adore::contact
