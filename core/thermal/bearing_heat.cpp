#include "thermal/bearing_heat.hpp"

#include "base/errors.hpp"
#include "bearing/material_laws.hpp"
#include "contact/groove.hpp"
#include "thermal/convection.hpp"
#include "thermal/ring.hpp"
#include "tribology/fluid.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::thermal {
namespace {

using bearing::Bearing;

constexpr double kPi = std::numbers::pi;
constexpr double kTried = 1e-6;  ///< change of a node that ends the iteration [K]
constexpr int kPasses = 50;

Coolant coolant_at(const Bearing& bearing, double T) {
  const bearing::ThermalInputs& given = *bearing.thermal;
  Coolant out;
  if (given.coolant == 2) {
    out = {"coolant of record 9.8", "given",           given.density, given.viscosity,
           given.specific_heat,     given.conductivity};
  } else if (given.coolant == 1) {
    demand(bearing.lubrication.has_value(), "the lubricant cools, and there is none");
    const tribology::Lubricant oil = tribology::lubricant_of(*bearing.lubrication);
    out = {oil.name,
           oil.provenance,
           oil.density.at(T),
           oil.base_viscosity(T),
           oil.specific_heat.at(T),
           oil.conductivity.at(T)};
  } else {
    const tribology::FluidProperties fluid = tribology::fluid_properties(given.coolant, T);
    out = {fluid.name,      fluid.provenance,    fluid.density,
           fluid.viscosity, fluid.specific_heat, fluid.conductivity};
    out.T_min = fluid.T_min;
    out.T_max = fluid.T_max;
  }
  return out;
}

/// Radii of raceways or of the bottoms of the grooves, where the rings of the fits end too.
std::array<double, 2> raceways(const Bearing& b) {
  if (b.rollers()) return {b.rollers()->race_radius(0), b.rollers()->race_radius(1)};
  const contact::GrooveGeometry g = contact::groove_geometry(b.balls());
  return {g.centre_radius[0] + g.groove_radius[0], g.centre_radius[1] - g.groove_radius[1]};
}

double conductivity(const Bearing& b, const bearing::Material& material, double T) {
  return b.mounting.material_laws && T > 0.0 ? bearing::material_at(material, T).conductivity
                                             : material.conductivity;
}

NetworkRings rings_of(const Bearing& b, const BulkTemperatures& bulk) {
  const bearing::Envelope& e = b.envelope;
  const std::array<double, 2> raceway = raceways(b);
  const double bore = 0.5 * e.bore, outside = 0.5 * e.outer_diameter;
  constexpr double kBoreOfSolid = 0.01;  // N76
  const double shaft = e.shaft_bore > 0.0 ? 0.5 * e.shaft_bore : kBoreOfSolid * bore;
  const auto ring = [&](double inner, double outer, int race, const bearing::Material& material,
                        double T) {
    return NetworkRing{inner, std::max(outer, inner), e.race_width[static_cast<std::size_t>(race)],
                       conductivity(b, material, T)};
  };
  NetworkRings out;
  out.outer = ring(raceway[0], outside, 0, b.race_material[0], bulk.race[0]);
  out.housing = ring(outside, 0.5 * e.housing_diameter, 0, b.mounting.housing, bulk.housing);
  out.inner = ring(bore, raceway[1], 1, b.race_material[1], bulk.race[1]);
  out.shaft = ring(std::min(shaft, bore), bore, 1, b.mounting.shaft, bulk.shaft);
  return out;
}

void check(const NetworkRings& rings) {
  for (const auto& [ring, variable, what] : {std::tuple{&rings.outer, "raceTC1", "outer race"},
                                             std::tuple{&rings.inner, "raceTC2", "inner race"},
                                             std::tuple{&rings.housing, "hsngTC", "housing"},
                                             std::tuple{&rings.shaft, "shftTC", "shaft"}})
    if (!(ring->conductivity > 0.0 && ring->width > 0.0))
      throw InputError(fmt::format(
          "the thermal network needs a conductivity and a width above 0 of the {}; they "
          "are {:g} W/m/K and {:g} m: give {} and the width of the race",
          what, ring->conductivity, ring->width, variable));
}

double mean_of(const NetworkRing& ring, double inside, double outside) {
  return ring.outer > ring.inner ? mean_ring_temperature(ring.inner, ring.outer, inside, outside)
                                 : outside;
}

BulkTemperatures bulk_of(const NetworkRings& rings, const NetworkTemperatures& T) {
  BulkTemperatures out;
  out.race = {mean_of(rings.outer, T.outer_raceway, T.outer_interface),
              mean_of(rings.inner, T.inner_interface, T.inner_raceway)};
  out.housing = mean_of(rings.housing, T.outer_interface, T.housing);
  out.shaft = mean_of(rings.shaft, T.shaft, T.inner_interface);
  out.element = T.element;
  out.cage = T.cage;
  out.medium = T.coolant_mean;
  return out;
}

/// Heat of the inner race that a solid shaft cannot take (Ladder::turned_back) [W].
/// @param room [K]; 0: not known
double not_into_shaft(Ladder ladder, double room) {
  const auto too_cold = [&](double turned_back) {
    ladder.turned_back = turned_back;
    const NetworkTemperatures& T = solve_ladder(ladder).temperature;
    double coldest = ladder.base_temperature;
    if (room > 0.0) coldest = std::min(coldest, room);
    if (ladder.capacity_flow > 0.0) coldest = std::min(coldest, T.coolant_in);
    return T.shaft < coldest - 1e-9 * std::abs(coldest);
  };
  if (!too_cold(0.0)) return 0.0;
  ladder.turned_back = 0.0;
  double low = 0.0, high = solve_ladder(ladder).flows.race[1];
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (too_cold(middle) ? low : high) = middle;
  }
  return high;
}

/// Of what meets the coolant.
struct Surfaces {
  double element = 0.0, cage = 0.0;  ///< [m²]
  double speed = 0.0;                ///< of the coolant past the elements [m/s]
};

Surfaces surfaces_of(const Bearing& b, double cage_speed) {
  Surfaces out;
  const double D = b.element_diameter(), relative = cage_speed - b.speed[0];
  const bearing::RollerGeometry* rollers = b.rollers();
  out.element = b.element_count() * (rollers ? kPi * D * (rollers->length + 0.5 * D) : kPi * D * D);
  const std::array<double, 2> raceway = raceways(b);
  double annulus = kPi * (raceway[0] * raceway[0] - raceway[1] * raceway[1]);
  if (b.cage) {
    out.cage = kPi * b.cage->width * (b.cage->outer_diameter + b.cage->inner_diameter);
    const double section = 0.25 * kPi *
                           (b.cage->outer_diameter * b.cage->outer_diameter -
                            b.cage->inner_diameter * b.cage->inner_diameter);
    annulus = std::max(annulus - section, 0.1 * annulus);
  }
  out.speed = std::hypot(0.5 * relative * b.pitch_diameter(), b.thermal->flow / annulus);
  return out;
}

}  // namespace

BulkTemperatures BulkTemperatures::in(const Bearing& b) noexcept {
  BulkTemperatures out;
  out.race = b.race_temperature;
  out.element = b.element_temperature;
  out.cage = b.cage_temperature;
  out.housing = b.mounting.housing_temperature;
  out.shaft = b.mounting.shaft_temperature;
  out.medium = b.medium_temperature.value_or(b.element_temperature);
  return out;
}

void BulkTemperatures::set(Bearing& b) const noexcept {
  b.race_temperature = race;
  b.element_temperature = element;
  b.cage_temperature = cage;
  b.mounting.housing_temperature = housing;
  b.mounting.shaft_temperature = shaft;
  b.medium_temperature = medium;
}

BearingHeat solve_bearing_heat(const Bearing& b, const HeatSources& sources, double cage_speed) {
  demand(b.thermal.has_value(), "a thermal network without a thermal analysis");
  const bearing::ThermalInputs& in = *b.thermal;
  const bool flows = in.coolant > 0 && in.flow > 0.0;
  const Surfaces surfaces = surfaces_of(b, cage_speed);
  BearingHeat out;
  out.sources = sources;
  out.element_area = surfaces.element;
  out.cage_area = surfaces.cage;
  out.bulk = BulkTemperatures::in(b);
  Ladder ladder;
  ladder.flows = share_out(sources, {});
  ladder.base = static_cast<BaseNode>(in.base);
  ladder.base_temperature = in.base_temperature;
  double T_in = in.base_temperature, T_mean = in.base_temperature;
  std::array<double, 7> before{};
  for (int pass = 0; pass < kPasses; ++pass) {
    ladder.rings = rings_of(b, out.bulk);
    check(ladder.rings);
    if (flows) {
      Coolant coolant = coolant_at(b, T_mean);
      coolant.mass_flow = coolant_at(b, T_in).density * in.flow;
      ladder.capacity_flow = coolant.mass_flow * coolant.specific_heat;
      const ConvectionFluid fluid{coolant.density, coolant.viscosity, coolant.specific_heat,
                                  coolant.conductivity};
      if (in.convection_given) {
        out.element_convection = in.element_convection;
        out.cage_convection = in.cage_convection;
      } else {
        out.element_convection =
            b.rollers() ? cylinder_convection(fluid, b.element_diameter(), surfaces.speed)
                        : sphere_convection(fluid, b.element_diameter(), surfaces.speed);
        if (b.cage)
          out.cage_convection =
              ring_convection(fluid, b.cage->outer_diameter, cage_speed - b.speed[0]);
      }
      ladder.element_film = out.element_convection * surfaces.element;
      ladder.cage_film = b.cage ? out.cage_convection * surfaces.cage : 1.0;
      if (!(ladder.capacity_flow > 0.0 && ladder.element_film > 0.0 && ladder.cage_film > 0.0))
        throw InputError(fmt::format(
            "the coolant {} takes no heat: flow times heat capacity is {:g} W/K, convection "
            "coefficients of elements and cage are {:g} and {:g} W/m^2/K; give reHTC and cageHTC "
            "(or kHTC = 0) and a specific heat above 0",
            coolant.name, ladder.capacity_flow, out.element_convection, out.cage_convection));
      out.coolant = std::move(coolant);
    }
    ladder.turned_back = 0.0;
    if (!(b.envelope.shaft_bore > 0.0))
      ladder.turned_back = not_into_shaft(ladder, b.room_temperature);
    const LadderResult result = solve_ladder(ladder);
    out.temperature = result.temperature;
    out.flows = result.flows;
    out.rings = ladder.rings;
    out.bulk = bulk_of(ladder.rings, out.temperature);
    T_in = out.temperature.coolant_in;
    T_mean = out.temperature.coolant_mean;
    const auto now = out.bulk.list();
    double change = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k)
      change = std::max(change, std::abs(now[k] - before[k]));
    before = now;
    if (change < kTried) break;
    // Nothing above absolute zero is left to evaluate properties at: runaway(), too_cold() say so.
    if (!runaway(out.bulk).empty() || (flows && !(T_in > 0.0 && T_mean > 0.0))) break;
  }
  if (!(b.envelope.shaft_bore > 0.0))
    out.notes.emplace_back(
        "the shaft is solid (shftID = 0): the thermal network gives it a bore of 1 % of the "
        "bearing's");
  if (ladder.turned_back > 0.0)
    out.notes.push_back(fmt::format(
        "nothing cools the solid shaft: with {:.4g} W into it its axis would be colder than "
        "everything around it; it takes {:.4g} W, its axis is at {:.4g} K, and the rest leaves by "
        "{}",
        out.flows.race[1] + ladder.turned_back, out.flows.race[1], out.temperature.shaft,
        flows ? "the coolant" : "the outer race"));
  if (out.coolant && out.coolant->outside(T_mean))
    out.notes.push_back(fmt::format(
        "the coolant's properties are known from {:g} to {:g} K; its mean temperature is {:.4g} K, "
        "and the nearer end is used",
        out.coolant->T_min, out.coolant->T_max, T_mean));
  if (out.coolant && b.cage && !in.convection_given) {
    const double reynolds = out.coolant->density * std::abs(cage_speed - b.speed[0]) *
                            b.cage->outer_diameter * b.cage->outer_diameter /
                            (2.0 * out.coolant->viscosity);
    if (reynolds > 4e5)
      out.notes.push_back(
          fmt::format("convection of the cage is extrapolated: its Reynolds number is {:.3g}, the "
                      "correlation is from tests up to 4e5",
                      reynolds));
  }
  return out;
}

std::string runaway(const BulkTemperatures& bulk) {
  const auto list = bulk.list();
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!(list[k] <= kHottest))
      return fmt::format("{} at {:.4g} K, above {:g} K", kBulkNames[k], list[k], kHottest);
    if (!(list[k] > 1.0)) return fmt::format("{} at {:.4g} K", kBulkNames[k], list[k]);
  }
  return {};
}

}  // namespace adore::thermal
