#include "tribology/bearing_drag.hpp"

#include "base/errors.hpp"
#include "tribology/fluid.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::tribology {
namespace {

using bearing::Bearing;
using bearing::GuideLand;

/// Part of a disc of radius R between two heights.
double share_of_disc(double R, double low, double high) {
  const auto below = [R](double z) {
    const double s = std::clamp(z / R, -1.0, 1.0);
    return 0.5 + (std::asin(s) + s * std::sqrt(1.0 - s * s)) / std::numbers::pi;
  };
  return std::max(0.0, below(high) - below(low));
}

/// Of what the wall of the cage hides of an element.
double hidden(const bearing::Cage& cage, const Bearing& bearing) {
  const double middle = 0.5 * bearing.pitch_diameter(), R = 0.5 * bearing.element_diameter();
  const double low = 0.5 * cage.inner_diameter - middle, high = 0.5 * cage.outer_diameter - middle;
  if (bearing.rollers() == nullptr) return share_of_disc(R, low, high);
  return std::max(0.0, std::min(high, R) - std::max(low, -R)) / (2.0 * R);
}

/// T/ω; `of` is odd in ω and creeping at rest, where the limit is taken from a speed that is next
/// to none.
template <class Torque>
double over_speed(double omega, const Torque& of) noexcept {
  constexpr double kRest = 1e-6;  // [rad/s]
  const double w = std::max(std::abs(omega), kRest);
  return of(w).torque / w;
}

}  // namespace

ChurningMedium churning_medium(const Bearing& bearing) {
  const bearing::Churning& given = *bearing.churning;
  ChurningMedium out;
  out.temperature = bearing.medium_temperature.value_or(
      (bearing.race_temperature[0] + bearing.race_temperature[1] + bearing.element_temperature) /
      3.0);
  if (given.code == 2) {
    out.name = "medium of record 10.7A";
    out.provenance = "given";
    out.medium = {given.density, given.viscosity};
    return out;
  }
  if (given.code == 1) {
    demand(bearing.lubrication.has_value(),
           "churning by the lubricant was requested, but there is no lubricant");
    const Lubricant oil = lubricant_of(*bearing.lubrication);
    out.name = oil.name;
    out.provenance = oil.provenance;
    out.medium = {oil.density.at(out.temperature), oil.base_viscosity(out.temperature)};
  } else {
    const FluidProperties fluid = fluid_properties(given.code, out.temperature);
    out.name = fluid.name;
    out.provenance = fluid.provenance;
    out.T_min = fluid.T_min;
    out.T_max = fluid.T_max;
    out.medium = {fluid.density, fluid.viscosity};
  }
  out.medium.density *= given.density_ratio;
  out.medium.viscosity *= given.viscosity_ratio;
  if (!(out.medium.density > 0.0 && out.medium.viscosity > 0.0))
    throw InputError(fmt::format(
        "the churning medium {} has a density of {:g} kg/m^3 and a viscosity of {:g} Pa s; both "
        "must be above 0. Enter denRatio and visRatio above 0, or set kChrn to 0",
        out.name, out.medium.density, out.medium.viscosity));
  return out;
}

BearingDrag::BearingDrag(const Bearing& bearing)
    : medium_(churning_medium(bearing)), diameter_(bearing.element_diameter()) {
  if (const bearing::RollerGeometry* rollers = bearing.rollers()) length_ = rollers->length;
  if (bearing.cage) add_cage(*bearing.cage, bearing);
}

void BearingDrag::add_cage(const bearing::Cage& cage, const Bearing& bearing) {
  exposed_area_fraction_ = 1.0 - hidden(cage, bearing);
  cage_face_radii_ = {0.5 * cage.outer_diameter, 0.5 * cage.inner_diameter};
  const bool films = bearing.cage_films && bearing.cage_films->lands;
  for (const int race : {0, 1}) {
    const auto guide = race == 0 ? GuideLand::Guide::Outer : GuideLand::Guide::Inner;
    const double play = race == 0 ? cage.clearance_outer : cage.clearance_inner;
    const double surface = 0.5 * (race == 0 ? cage.outer_diameter : cage.inner_diameter);
    double rest = cage.width;
    const auto add = [&](double radius, double clearance, double length) {
      const double gap = 0.5 * clearance;
      if (gap > 0.0 && length > 0.0)
        surfaces_.push_back({race, race == 0 ? radius : radius - gap, gap, length});
    };
    for (const GuideLand& land : cage.lands) {
      if (land.guide != guide) continue;
      rest -= land.width;
      if (!films) add(0.5 * land.diameter, land.clearance, land.width);
    }
    add(surface, play, rest);
  }
}

double BearingDrag::element_force_per_speed(double V) const noexcept {
  constexpr double kRest = 1e-9;  // [m/s]: creeping flow, where F/V is constant
  const double v = std::max(V, kRest);
  const double R = 0.5 * diameter_;
  const double force =
      length_ > 0.0
          ? exposed_area_fraction_ * cylinder_drag(medium_.medium, v, diameter_, length_).force
          : sphere_drag(medium_.medium, v, diameter_,
                        exposed_area_fraction_ * std::numbers::pi * R * R)
                .force;
  return force / v;
}

double BearingDrag::element_spin(double omega) const noexcept {
  const double R = 0.5 * diameter_;
  if (!(length_ > 0.0))
    return over_speed(omega, [&](double w) { return spin_drag(medium_.medium, w, R); });
  const double ends = over_speed(omega, [&](double w) { return disc_drag(medium_.medium, w, R); });
  return ends + over_speed(omega, [&](double w) {
           return annulus_drag(medium_.medium, w, R, 0.5 * R, length_);
         });
}

double BearingDrag::surface_moment_per_speed(const CageSurface& surface,
                                             double omega) const noexcept {
  return over_speed(omega, [&](double w) {
    return annulus_drag(medium_.medium, w, surface.radius, surface.gap, surface.length);
  });
}

double BearingDrag::face_moment_per_speed(double omega) const noexcept {
  return std::max(0.0, over_speed(omega, [&](double w) {
                         return disc_drag(medium_.medium, w, cage_face_radii_[0]);
                       }) - over_speed(omega, [&](double w) {
                         return disc_drag(medium_.medium, w, cage_face_radii_[1]);
                       }));
}

DragPower drag_power(const BearingDrag& drag, const Bearing& bearing, double orbit, double spin,
                     double cage) {
  DragPower out;
  const double at = bearing.speed[0];
  const double V = std::abs(orbit - at) * 0.5 * bearing.pitch_diameter(), w = std::abs(spin);
  out.elements = bearing.element_count() *
                 (drag.element_force_per_speed(V) * V * V + drag.element_spin(w) * w * w);
  if (!bearing.cage) return out;
  for (const CageSurface& surface : drag.surfaces()) {
    const double relative = std::abs(cage - bearing.speed[static_cast<std::size_t>(surface.race)]);
    out.cage += drag.surface_moment_per_speed(surface, relative) * relative * relative;
  }
  const double relative = std::abs(cage - at);
  out.cage += drag.face_moment_per_speed(relative) * relative * relative;
  return out;
}

}  // namespace adore::tribology
