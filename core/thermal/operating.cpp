#include "thermal/operating.hpp"

#include "base/errors.hpp"
#include "bearing/material_laws.hpp"
#include "contact/groove.hpp"
#include "statics/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

using bearing::Bearing;
using bearing::Growth;
using bearing::Material;
using bearing::OperatingFits;

constexpr std::array<const char*, 2> kRaceName{"outer", "inner"};
constexpr std::array<const char*, 2> kMateName{"housing", "shaft"};

double growth_of(const Bearing& b, const Material& material, double temperature) {
  return bearing::thermal_growth(material, temperature, b.room_temperature,
                                 b.mounting.material_laws);
}

RingPart part(const Bearing& b, const Material& material, double temperature, double inner,
              double outer, double speed) {
  RingPart out;
  const Material at =
      b.mounting.material_laws ? bearing::material_at(material, temperature) : material;
  out.elastic = {at.elastic_modulus, at.poisson_ratio, at.density};
  out.inner = inner;
  out.outer = outer;
  out.growth = growth_of(b, material, temperature);
  out.speed = b.mounting.centrifugal_growth ? speed : 0.0;
  return out;
}

double elastic_limit(const Material& material) {
  return material.elastic_strain_limit * material.elastic_modulus;
}

/// Displacement of a part at r by its causes.
Growth growth_at(const RingPart& part, double r, double pressure = 0.0) {
  return {r * part.growth, part.free_displacement(r) - r * part.growth, pressure};
}

bearing::ClearanceState ball_state(double clearance, double centre_distance) {
  bearing::ClearanceState out;
  out.clearance = clearance;
  out.centre_distance = centre_distance;
  out.contact_angle = contact_angle(clearance, centre_distance);
  out.end_play = end_play(centre_distance, out.contact_angle);
  return out;
}

/// Displacement of both raceways.
std::array<double, 2> raceway_displacement(const MountedState& state) {
  return {state.race_displacement(0, state.rings.outer.inner),
          state.race_displacement(1, state.rings.inner.outer)};
}

/// Fits and growths, of any bearing type.
OperatingFits ring_report(const Bearing& b, const MountedState& state,
                          const MountedState& mounted) {
  OperatingFits out;
  const MountedRings& rings = state.rings;
  const std::array<const RingPart*, 2> races{&rings.outer, &rings.inner};
  const std::array<const RingPart*, 2> mates{&rings.housing, &rings.shaft};
  const std::array<const Material*, 2> mate_material{&b.mounting.housing, &b.mounting.shaft};
  out.raceway_radius = {rings.outer.inner, rings.inner.outer};
  for (int j = 0; j < 2; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double r = out.raceway_radius[k], at_fit = j == 0 ? rings.outer.outer : rings.inner.inner;
    out.fit[k] = {rings.fit[k],
                  state.interference[k],
                  mounted.pressure[k],
                  state.pressure[k],
                  state.race_hoop_stress(j),
                  state.mating_part_hoop_stress(j),
                  elastic_limit(b.race_material[k]),
                  elastic_limit(*mate_material[k])};
    out.raceway[k] = growth_at(*races[k], r, state.fit_pressure_displacement(j, r));
    out.race_at_fit[k] = growth_at(*races[k], at_fit);
    out.mate_at_fit[k] = growth_at(*mates[k], at_fit);
  }
  return out;
}

/// Adds the three states of a ball bearing's clearance and the circles of curvature centers. Shims
/// g of split races take their thickness from the end play: 2 A sin α - g (contact/groove.hpp).
void add_ball_states(OperatingFits& out, const Bearing& b, const contact::GrooveGeometry& groove,
                     const MountedState& state, const MountedState& mounted,
                     double element_growth) {
  const std::array<double, 2> u = raceway_displacement(state);
  const double g_outer = state.rings.outer.growth, g_inner = state.rings.inner.growth;
  out.locus_free = groove.centre_radius;
  out.locus = {groove.centre_radius[0] + u[0] - groove.groove_radius[0] * g_outer,
               groove.centre_radius[1] + u[1] + groove.groove_radius[1] * g_inner};
  const double D = b.balls().diameter, r0 = groove.groove_radius[0], r1 = groove.groove_radius[1];
  out.element_growth = D * element_growth;
  const double free = r0 + r1 - D;
  const double operating = r0 * (1.0 + g_outer) + r1 * (1.0 + g_inner) - (D + out.element_growth);
  const double Pd = b.balls().clearance;
  out.free = {Pd, b.balls().contact_angle, end_play(free, b.balls().contact_angle), free};
  out.mounted = ball_state(operating_clearance(Pd, raceway_displacement(mounted), 0.0), free);
  out.operating = ball_state(operating_clearance(Pd, u, out.element_growth), operating);
  const std::array<double, 2>& shim = b.balls().shim;
  if (shim[0] > 0.0 || shim[1] > 0.0) {
    const std::array<double, 2> offset{r0 - 0.5 * D, r1 - 0.5 * D};
    const double grown_radius = 0.5 * (D + out.element_growth);
    out.free.end_play = contact::split_race_end_play(offset, shim, out.free.contact_angle);
    out.mounted.end_play = contact::split_race_end_play(offset, shim, out.mounted.contact_angle);
    out.operating.end_play = contact::split_race_end_play(
        {r0 * (1.0 + g_outer) - grown_radius, r1 * (1.0 + g_inner) - grown_radius},
        {shim[0] * (1.0 + g_outer), shim[1] * (1.0 + g_inner)}, out.operating.contact_angle);
  }
  out.pitch_free = out.pitch = b.balls().pitch_diameter;
}

/// Balls and grooves in operation; the report's pitch diameter.
/// @param plane of the groove centers on the bench, which each race keeps [m]
void move_grooves(bearing::BallGeometry& balls, OperatingFits& report, const MountedState& state,
                  const std::array<double, 2>& plane) {
  const std::array<double, 2> growth{state.rings.outer.growth, state.rings.inner.growth};
  const double free_diameter = balls.diameter;
  balls.diameter += report.element_growth;
  for (int j = 0; j < 2; ++j) {
    const auto k = static_cast<std::size_t>(j);
    balls.groove_factor[k] *= (1.0 + growth[k]) * free_diameter / balls.diameter;
    balls.shim[k] *= 1.0 + growth[k];
    const double shoulder = 0.5 * balls.shoulder_diameter[k];
    if (shoulder > 0.0) balls.shoulder_diameter[k] += 2.0 * state.race_displacement(j, shoulder);
  }
  balls.clearance = report.operating.clearance;
  balls.contact_angle = report.operating.contact_angle;
  balls.groove_plane = plane;
  // The groove centers of groove_geometry must be on the moved circles.
  const double offset = (balls.groove_factor[0] - 0.5) * balls.diameter;
  balls.pitch_diameter =
      2.0 * (report.locus[0] + (balls.contact_angle > 0.0 ? offset * std::cos(balls.contact_angle)
                                                          : offset - 0.25 * balls.clearance));
  report.pitch = balls.pitch_diameter;
}

void scale_inertia(bearing::Inertia& inertia, double growth) {
  inertia.moments *= (1.0 + growth) * (1.0 + growth);
  inertia.geometric_centre *= 1.0 + growth;
}

/// Play between a cage surface of the given diameter and a race, before and after; moves the play.
void move_play(const std::string& name, int race, double cage_diameter, double& play,
               const MountedState& state, const RingPart& ring, OperatingFits& report) {
  const double cage_radius = 0.5 * cage_diameter;
  const double race_radius = cage_radius + (race == 0 ? 0.5 : -0.5) * play;
  bearing::CageClearance entry{name, play, play};
  const double u_race = state.race_displacement(race, race_radius);
  const double u_cage = cage_displacement(ring, cage_radius, true);
  if (u_race != 0.0 || u_cage != 0.0)
    entry.operating = land_clearance(race, race_radius, u_race, cage_radius, u_cage);
  if (entry.free >= 0.0 && entry.operating < 0.0)
    report.warnings.push_back(
        make_finding(
            "fit.cage_clearance",
            fmt::format(
                "the cage loses its clearance ({}): {:.4g} m cold and {:.4g} m in operation", name,
                entry.free, entry.operating))
            .of("cage")
            .measure(entry.operating)
            .at_least(0.0));
  play = entry.operating;
  report.plays.push_back(entry);
}

void warn_of_pocket(OperatingFits& report, double clearance, std::string text) {
  report.warnings.push_back(make_finding("fit.pocket_clearance", std::move(text))
                                .of("cage")
                                .measure(clearance)
                                .at_least(0.0));
}

void move_pocket(const std::string& name, double& clearance, double diameter, double g_cage,
                 double g_ball, OperatingFits& report) {
  bearing::CageClearance entry{name, clearance,
                               pocket_clearance(clearance, diameter, g_cage, g_ball)};
  if (entry.free >= 0.0 && entry.operating < 0.0)
    warn_of_pocket(report, entry.operating,
                   fmt::format("the cage clamps its rolling elements: {} is {:.4g} m cold and "
                               "{:.4g} m in operation",
                               name, entry.free, entry.operating));
  clearance = entry.operating;
  report.plays.push_back(entry);
}

/// Quantities that determine motion and pockets of the cage, for balls or rollers.
struct ElementSizes {
  int count = 0;
  double diameter = 0.0, pitch_diameter = 0.0;  ///< [m]
  double angle = 0.0;                           ///< of contact [rad]
};

ElementSizes element_sizes(const Bearing& b) {
  if (!b.rollers())
    return {b.element_count(), b.balls().diameter, b.balls().pitch_diameter,
            b.balls().contact_angle};
  return {b.rollers()->count, b.rollers()->diameter, b.rollers()->pitch_diameter,
          b.rollers()->axis_angle};
}

/// The tightest of the pockets that differ from the others.
void report_tightest_pocket(const bearing::Cage& cage, std::size_t which, double nominal,
                            double diameter, double g_cage, double g_ball, OperatingFits& report) {
  const auto& own = cage.pocket_deviation;
  const auto tightest = std::min_element(
      own.begin(), own.end(),
      [which](const auto& a, const auto& b) { return a.clearance[which] < b.clearance[which]; });
  if (tightest == own.end()) return;
  double clearance = nominal + tightest->clearance[which];
  if (nominal >= 0.0 && clearance < 0.0)
    warn_of_pocket(report, clearance,
                   fmt::format("pocket {} of the cage clamps its rolling element: pocket clearance "
                               "{} is {:.4g} m",
                               tightest - own.begin() + 1, which == 0 ? "I" : "II", clearance));
  move_pocket(fmt::format("pocket clearance {}, {} {}", which == 0 ? "I" : "II",
                          own.size() > 1 ? "least: no." : "pocket", tightest - own.begin() + 1),
              clearance, diameter, g_cage, g_ball, report);
}

/// Cage, lands and pockets in operation. `free` is the bearing on the bench.
void move_cage(bearing::Cage& cage, const Bearing& free, const MountedState& state,
               double ball_growth, OperatingFits& report) {
  using Guide = bearing::GuideLand::Guide;
  const ElementSizes elements = element_sizes(free);
  report.cage_speed =
      statics::epicyclic_speeds(elements.count, elements.diameter, elements.pitch_diameter,
                                elements.angle, free.speed[0], free.speed[1])
          .cage_speed;
  // Segments are not a ring that rotation could stretch.
  const double stretched_at = cage.segments.several() ? 0.0 : report.cage_speed;
  const RingPart ring = part(free, cage.material, free.cage_temperature, 0.5 * cage.inner_diameter,
                             0.5 * cage.outer_diameter, stretched_at);
  report.cage = {growth_at(ring, ring.outer), growth_at(ring, ring.inner)};

  for (std::size_t i = 0; i < cage.lands.size(); ++i) {
    bearing::GuideLand& land = cage.lands[i];
    if (land.guide != Guide::None)
      move_play(fmt::format("guide land {} on the {} race", i + 1,
                            land.guide == Guide::Outer ? "outer" : "inner"),
                land.guide == Guide::Outer ? 0 : 1, land.diameter, land.clearance, state, ring,
                report);
    land.diameter += 2.0 * cage_displacement(ring, 0.5 * land.diameter, true);
    land.width *= 1.0 + ring.growth;
    land.edge *= 1.0 + ring.growth;
  }
  move_play("cage outside to the outer race", 0, cage.outer_diameter, cage.clearance_outer, state,
            ring, report);
  move_play("cage bore to the inner race", 1, cage.inner_diameter, cage.clearance_inner, state,
            ring, report);
  const std::array<double, 2> nominal{cage.pocket_clearance_1, cage.pocket_clearance_2};
  const auto tightest = [&](std::size_t which) {
    report_tightest_pocket(cage, which, nominal[which], elements.diameter, ring.growth, ball_growth,
                           report);
  };
  move_pocket("pocket clearance I", cage.pocket_clearance_1, elements.diameter, ring.growth,
              ball_growth, report);
  tightest(0);
  if (cage.pocket == bearing::PocketShape::Elongated)
    cage.pocket_clearance_2 *= 1.0 + ring.growth;  // length of the straight part
  else if (!free.rollers() && (cage.pocket == bearing::PocketShape::Rectangular ||
                               cage.pocket == bearing::PocketShape::Conical)) {
    move_pocket("pocket clearance II", cage.pocket_clearance_2, elements.diameter, ring.growth,
                ball_growth, report);
    tightest(1);
  }
  cage.outer_diameter += 2.0 * report.cage[0].total();
  cage.inner_diameter += 2.0 * report.cage[1].total();
  cage.width *= 1.0 + ring.growth;
  scale_inertia(cage.inertia, ring.growth);
}

void warn(OperatingFits& report, const Bearing& free) {
  const auto say = [&](const char* code, const std::string& body, std::string text) -> Finding& {
    report.warnings.push_back(make_finding(code, std::move(text)));
    return report.warnings.back().of(body);
  };
  // The clearance of cones is the axial setting, which the bearing's position on the shaft
  // determines.
  if (!report.axial_setting && report.operating.clearance < 0.0 && report.free.clearance >= 0.0)
    say("fit.clearance", "",
        fmt::format("the diametral clearance becomes negative: {:.4g} m unmounted, {:.4g} m "
                    "mounted, {:.4g} m in operation. Fits and growth preload the bearing radially",
                    report.free.clearance, report.mounted.clearance, report.operating.clearance))
        .measure(report.operating.clearance)
        .at_least(0.0);
  for (std::size_t j = 0; j < 2; ++j) {
    const bearing::FitState& fit = report.fit[j];
    const bool wall = j == 0 ? free.envelope.housing_diameter > free.envelope.outer_diameter
                             : free.envelope.shaft_bore < free.envelope.bore;
    if (wall && fit.allowance > 0.0 && fit.interference <= 0.0)
      say("fit.loose", fmt::format("{} race", kRaceName[j]),
          fmt::format("the {} race comes loose from the {}: the interference is {:.4g} m when "
                      "mounted, but in operation there is a clearance of {:.4g} m",
                      kRaceName[j], kMateName[j], fit.allowance, -fit.interference))
          .measure(-fit.interference, 0.0);
    const auto check = [&](const char* what, double stress, double limit) {
      if (limit > 0.0 && std::abs(stress) > limit)
        say("fit.hoop_stress", what,
            fmt::format("the hoop stress of the {} is {:.4g} Pa, above its elastic limit of {:.4g} "
                        "Pa: the elastic fit calculation is not valid",
                        what, stress, limit))
            .measure(stress, limit);
    };
    check(j == 0 ? "outer race" : "inner race", fit.race_hoop, fit.race_limit);
    check(kMateName[j], fit.mate_hoop, fit.mate_limit);
  }
}

/// Whether anything moves at all.
bool moves(const OperatingFits& report, const MountedState& state, const Bearing& free) {
  if (report.element_growth != 0.0 || state.rings.outer.growth != 0.0 ||
      state.rings.inner.growth != 0.0 || report.raceway[0].total() != 0.0 ||
      report.raceway[1].total() != 0.0)
    return true;
  if (!free.cage) return false;
  return growth_of(free, free.cage->material, free.cage_temperature) != 0.0 ||
         (free.mounting.centrifugal_growth && report.cage_speed != 0.0);
}

void apply_material_laws(Bearing& b) {
  b.element_material = bearing::material_at(b.element_material, b.element_temperature);
  for (std::size_t j = 0; j < 2; ++j)
    b.race_material[j] = bearing::material_at(b.race_material[j], b.race_temperature[j]);
  b.mounting.housing = bearing::material_at(b.mounting.housing, b.mounting.housing_temperature);
  b.mounting.shaft = bearing::material_at(b.mounting.shaft, b.mounting.shaft_temperature);
  if (b.cage) b.cage->material = bearing::material_at(b.cage->material, b.cage_temperature);
}

/// operating_bearing of a roller bearing.
Bearing operating_roller_bearing_of(const Bearing& free) {
  Bearing out = free;
  bearing::RollerGeometry& rollers = *out.rollers();
  const bool cone =
      free.type == bearing::Type::Tapered || free.type == bearing::Type::SphericalTapered;
  OperatingRollers operating = operating_roller_bearing(
      free,
      {rollers.diameter, rollers.length, rollers.crown_radius, rollers.pitch_diameter,
       rollers.clearance},
      {rollers.race_radius(bearing::kOuter), rollers.race_radius(bearing::kInner)},
      cone ? rollers.race_angle[bearing::kOuter] : 0.0);
  OperatingFits& report = operating.report;
  const double growth = growth_of(free, free.element_material, free.element_temperature);
  if (free.cage) {
    move_cage(*out.cage, free, operating.state, growth, report);
    report.changed = moves(report, operating.state, free);
  }
  if (report.changed) {
    const RollerSizes& sizes = operating.rollers.geometry;
    bearing::UnmountedRollerGeometry bench{rollers.diameter,
                                           rollers.length,
                                           rollers.crown_radius,
                                           rollers.pitch_diameter,
                                           rollers.clearance,
                                           rollers.groove_factor,
                                           {}};
    const std::array<double, 2> strain{operating.state.rings.outer.growth,
                                       operating.state.rings.inner.growth};
    for (std::size_t j = 0; j < 2; ++j) {
      bench.growth[j] = {operating.rollers.raceway_displacement[j], strain[j]};
      if (rollers.groove_factor[j] > 0.0)
        rollers.groove_factor[j] *= (1.0 + strain[j]) * rollers.crown_radius / sizes.crown_radius;
    }
    rollers.bench = bench;
    rollers.diameter = sizes.diameter;
    rollers.length = sizes.length;
    rollers.crown_radius = sizes.crown_radius;
    rollers.pitch_diameter = sizes.pitch_diameter;
    rollers.clearance = sizes.clearance;
    scale_inertia(out.element_inertia, growth);
    if (out.first_inertia) scale_inertia(*out.first_inertia, growth);
    scale_inertia(out.race_inertia[0], operating.state.rings.outer.growth);
    scale_inertia(out.race_inertia[1], operating.state.rings.inner.growth);
  } else {
    out.cage = free.cage;
  }
  if (free.mounting.material_laws) apply_material_laws(out);
  out.operating = std::move(report);
  return out;
}

}  // namespace

MountedRings mounted_rings(const Bearing& b, const std::array<double, 2>& raceway_radius) {
  const double bore = 0.5 * b.envelope.bore, outside = 0.5 * b.envelope.outer_diameter;
  if (!(raceway_radius[0] > 0.0 && raceway_radius[0] < outside))
    throw InputError(
        fmt::format("the outer raceway radius is {} m; it must be smaller than the outside radius "
                    "of the bearing, {} m, because the ring needs a thickness above 0",
                    raceway_radius[0], outside));
  if (!(raceway_radius[1] > bore && bore > 0.0))
    throw InputError(fmt::format(
        "the inner raceway radius is {} m; it must be larger than the bore radius of {} m, and the "
        "bore radius must be above 0, because the ring needs a thickness above 0",
        raceway_radius[1], bore));
  MountedRings out;
  out.shaft = part(b, b.mounting.shaft, b.mounting.shaft_temperature, 0.5 * b.envelope.shaft_bore,
                   bore, b.speed[1]);
  out.inner =
      part(b, b.race_material[1], b.race_temperature[1], bore, raceway_radius[1], b.speed[1]);
  out.outer =
      part(b, b.race_material[0], b.race_temperature[0], raceway_radius[0], outside, b.speed[0]);
  out.housing = part(b, b.mounting.housing, b.mounting.housing_temperature, outside,
                     0.5 * b.envelope.housing_diameter, b.speed[0]);
  out.fit = b.mounting.fit;
  return out;
}

Bearing operating_bearing(const Bearing& free) {
  demand(!free.operating.has_value(), "the operating geometry was already computed");
  if (free.rollers()) return operating_roller_bearing_of(free);
  const contact::GrooveGeometry groove = contact::groove_geometry(free.balls());
  const MountedRings rings =
      mounted_rings(free, {groove.centre_radius[0] + groove.groove_radius[0],
                           groove.centre_radius[1] - groove.groove_radius[1]});
  const MountedState state = mount(rings), mounted = mount(at_rest(rings));
  const double ball_growth = growth_of(free, free.element_material, free.element_temperature);
  OperatingFits report = ring_report(free, state, mounted);
  add_ball_states(report, free, groove, state, mounted, ball_growth);
  if (!(report.operating.clearance < 2.0 * report.operating.centre_distance))
    throw InputError(
        fmt::format("the operating clearance is {} m, but above {} m the free contact angle "
                    "exceeds 90 degrees. Check fits, temperatures and speeds",
                    report.operating.clearance, 2.0 * report.operating.centre_distance));

  Bearing out = free;
  if (free.cage) move_cage(*out.cage, free, state, ball_growth, report);
  report.changed = moves(report, state, free);
  if (report.changed) {
    move_grooves(out.balls(), report, state, groove.centre_x);
    scale_inertia(out.element_inertia, ball_growth);
    if (out.first_inertia) scale_inertia(*out.first_inertia, ball_growth);
    scale_inertia(out.race_inertia[0], rings.outer.growth);
    scale_inertia(out.race_inertia[1], rings.inner.growth);
  } else {
    out.cage = free.cage;
    report.operating = report.free;
    report.locus = report.locus_free;
    if (mounted.pressure == std::array{0.0, 0.0}) report.mounted = report.free;
  }
  if (free.mounting.material_laws) apply_material_laws(out);
  warn(report, free);
  out.operating = std::move(report);
  return out;
}

OperatingRollers operating_roller_bearing(const Bearing& free, const RollerSizes& rollers,
                                          const std::array<double, 2>& raceway_radius,
                                          double outer_half_angle) {
  OperatingRollers out;
  out.state = mount(mounted_rings(free, raceway_radius));
  const MountedState mounted = mount(at_rest(out.state.rings));
  const double growth = growth_of(free, free.element_material, free.element_temperature);
  out.rollers = roller_operating_geometry(out.state, rollers, growth, outer_half_angle);
  out.report = ring_report(free, out.state, mounted);
  OperatingFits& report = out.report;
  report.element_growth = out.rollers.geometry.diameter - rollers.diameter;
  if (outer_half_angle > 0.0) report.axial_setting = out.rollers.axial_setting_change;
  report.free.clearance = rollers.clearance;
  report.mounted.clearance =
      operating_clearance(rollers.clearance, raceway_displacement(mounted), 0.0);
  report.operating.clearance = out.rollers.geometry.clearance;
  report.pitch_free = rollers.pitch_diameter;
  report.pitch = out.rollers.geometry.pitch_diameter;
  report.changed = moves(report, out.state, free);
  warn(report, free);
  return out;
}

}  // namespace adore::thermal
