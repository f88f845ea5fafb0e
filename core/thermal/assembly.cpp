#include "thermal/assembly.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

bool has_wall(const RingPart& part) { return part.outer > part.inner; }

/// Hoop stress of largest size among bore and outside; a solid disc is largest in its center.
double largest_hoop_stress(const RingPart& part, double pa, double pb) {
  if (!has_wall(part)) return 0.0;
  const auto stress = [&](double r) {
    return pressure_hoop_stress(r, part.inner, part.outer, pa, pb) +
           centrifugal_hoop_stress(r, part.inner, part.outer, part.elastic, part.speed);
  };
  const double at_bore = stress(part.inner), at_outside = stress(part.outer);
  return std::abs(at_bore) >= std::abs(at_outside) ? at_bore : at_outside;
}

}  // namespace

double RingPart::free_displacement(double r) const {
  // A part without wall is a thin hoop on its inner radius: it spins as such and carries no
  // pressure.
  return r * growth + centrifugal_displacement(r, inner, std::max(inner, outer), elastic, speed);
}

MountedRings at_rest(MountedRings rings) {
  for (RingPart* part : {&rings.shaft, &rings.inner, &rings.outer, &rings.housing})
    part->growth = part->speed = 0.0;
  return rings;
}

MountedState mount(const MountedRings& rings) {
  MountedState out;
  out.rings = rings;
  const double ro = rings.outer.outer, rb = rings.inner.inner;
  out.interference = {
      rings.fit[0] +
          2.0 * (rings.outer.free_displacement(ro) - rings.housing.free_displacement(ro)),
      rings.fit[1] + 2.0 * (rings.shaft.free_displacement(rb) - rings.inner.free_displacement(rb))};
  out.pressure = {fit_pressure(rings.outer.inner, ro, rings.housing.outer, rings.outer.elastic,
                               rings.housing.elastic, out.interference[0]),
                  fit_pressure(rings.shaft.inner, rb, rings.inner.outer, rings.shaft.elastic,
                               rings.inner.elastic, out.interference[1])};
  return out;
}

double MountedState::fit_pressure_displacement(int race, double r) const {
  const RingPart& part = race == 0 ? rings.outer : rings.inner;
  const double pa = race == 0 ? 0.0 : pressure[1], pb = race == 0 ? pressure[0] : 0.0;
  return pressure_displacement(r, part.inner, part.outer, part.elastic, pa, pb);
}

double MountedState::race_displacement(int race, double r) const {
  return (race == 0 ? rings.outer : rings.inner).free_displacement(r) +
         fit_pressure_displacement(race, r);
}

double MountedState::race_hoop_stress(int race) const {
  return race == 0 ? largest_hoop_stress(rings.outer, 0.0, pressure[0])
                   : largest_hoop_stress(rings.inner, pressure[1], 0.0);
}

double MountedState::mating_part_hoop_stress(int race) const {
  return race == 0 ? largest_hoop_stress(rings.housing, pressure[0], 0.0)
                   : largest_hoop_stress(rings.shaft, 0.0, pressure[1]);
}

double operating_clearance(double clearance, const std::array<double, 2>& u,
                           double element_growth) {
  return clearance + 2.0 * (u[0] - u[1]) - 2.0 * element_growth;
}

double contact_angle(double clearance, double centre_distance) {
  if (!(clearance > 0.0) || clearance >= 4.0 * centre_distance) return 0.0;
  // 1 - cos α = Pd/(2A), by the half angle so that small clearances keep their digits.
  return 2.0 * std::asin(std::sqrt(0.25 * clearance / centre_distance));
}

double end_play(double centre_distance, double angle) {
  return 2.0 * centre_distance * std::sin(angle);
}

SplitRace split_race(double groove_radius, double ball_diameter, double shim,
                     double measured_clearance, double centre_distance) {
  const double chord = 2.0 * groove_radius - ball_diameter;
  const double sine = shim / chord;
  if (!(sine >= 0.0 && sine < 1.0))
    throw InputError(
        fmt::format("the shim is {} m in a groove of radius {} m with a ball of diameter {} m; it "
                    "must not be negative and must be below {} m",
                    shim, groove_radius, ball_diameter, chord));
  SplitRace out;
  out.shim_angle = std::asin(sine);
  out.clearance = measured_clearance + chord * (1.0 - std::cos(out.shim_angle));
  out.contact_angle = contact_angle(out.clearance, centre_distance);
  out.end_play = end_play(centre_distance, out.contact_angle) - shim;
  return out;
}

double land_clearance(int race, double race_radius, double u_race, double cage_radius,
                      double u_cage) {
  const double gap = race_radius + u_race - cage_radius - u_cage;
  return race == 0 ? 2.0 * gap : -2.0 * gap;
}

double pocket_clearance(double clearance, double element_diameter, double g_cage,
                        double g_element) {
  return clearance + clearance * g_cage + element_diameter * (g_cage - g_element);
}

double cage_displacement(const RingPart& cage, double r, bool one_piece) {
  return one_piece ? cage.free_displacement(r) : r * cage.growth;
}

RollerOperatingGeometry roller_operating_geometry(const MountedState& state,
                                                  const RollerSizes& free, double element_growth,
                                                  double outer_half_angle) {
  RollerOperatingGeometry out;
  out.raceway_displacement = {state.race_displacement(0, state.rings.outer.inner),
                              state.race_displacement(1, state.rings.inner.outer)};
  const auto& u = out.raceway_displacement;
  out.geometry = free;
  out.geometry.diameter += free.diameter * element_growth;
  out.geometry.length += free.length * element_growth;
  out.geometry.crown_radius += free.crown_radius * element_growth;
  out.geometry.pitch_diameter += u[0] + u[1];
  out.geometry.clearance =
      operating_clearance(free.clearance, u, out.geometry.diameter - free.diameter);
  if (outer_half_angle > 0.0)
    out.axial_setting_change =
        tapered_setting_change(out.geometry.clearance - free.clearance, outer_half_angle);
  return out;
}

double tapered_setting_change(double clearance_change, double outer_half_angle) {
  if (!(outer_half_angle > 0.0 && outer_half_angle < 1.5707))
    throw InputError(fmt::format(
        "the half angle of a tapered outer raceway is {} rad; it must be between 0 and 90 degrees",
        outer_half_angle));
  return -0.5 * clearance_change / std::tan(outer_half_angle);
}

}  // namespace adore::thermal
