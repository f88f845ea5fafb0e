#include "thermal/bearing_heat.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "bearing/material_laws.hpp"
#include "contact/groove.hpp"
#include "thermal/convection.hpp"
#include "thermal/operating.hpp"
#include "thermal/ring.hpp"
#include "tribology/fluid.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

using bearing::Bearing;

constexpr double kTried = 1e-6;  ///< change of a node that ends the iteration [K]
constexpr int kPasses = 50;

Coolant coolant_at(const Bearing& bearing, double T) {
  const bearing::ThermalInputs& given = *bearing.thermal;
  Coolant out;
  if (given.coolant == 2) {
    out = {"coolant of record 9.8", "given",           given.density, given.viscosity,
           given.specific_heat,     given.conductivity};
  } else if (given.coolant == 1) {
    demand(bearing.lubrication.has_value(),
           "cooling by the lubricant was requested, but there is no lubricant");
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
      throw InputError(
          fmt::format("the thermal network needs a conductivity and a width above 0 for the {}, "
                      "but these are {:g} W/m/K and {:g} m. Enter {} and the width of the race",
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
  out.housing = mean_of(rings.housing, T.housing_seat, T.housing);
  out.shaft = mean_of(rings.shaft, T.shaft, T.shaft_seat);
  out.element = T.element;
  out.cage = T.cage;
  out.medium = T.coolant_mean;
  return out;
}

/// Of what meets the medium.
struct Surfaces {
  double element = 0.0, cage = 0.0;  ///< [m²]
  std::array<double, 2> race{};      ///< raceways [m²]
  double speed = 0.0;                ///< of the coolant past the elements [m/s]
};

Surfaces surfaces_of(const Bearing& b, double cage_speed) {
  Surfaces out;
  const double D = b.element_diameter(), relative = cage_speed - b.speed[0];
  const bearing::RollerGeometry* rollers = b.rollers();
  out.element = b.element_count() * (rollers ? kPi * D * (rollers->length + 0.5 * D) : kPi * D * D);
  const std::array<double, 2> raceway = raceways(b);
  for (std::size_t j = 0; j < 2; ++j)
    out.race[j] = 2.0 * kPi * raceway[j] * b.envelope.race_width[j];
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

/// h of all that meets a fluid [W/(m² K)].
struct Convection {
  double element = 0.0, cage = 0.0;
  std::array<double, 2> race{};
};

Convection convection_in(const Bearing& b, const ConvectionFluid& fluid, const Surfaces& surfaces,
                         double cage_speed) {
  Convection out;
  out.element = b.rollers() ? cylinder_convection(fluid, b.element_diameter(), surfaces.speed)
                            : sphere_convection(fluid, b.element_diameter(), surfaces.speed);
  if (b.cage) out.cage = ring_convection(fluid, b.cage->outer_diameter, cage_speed - b.speed[0]);
  const std::array<double, 2> raceway = raceways(b);
  for (std::size_t j = 0; j < 2; ++j)
    out.race[j] = ring_convection(fluid, 2.0 * raceway[j], cage_speed - b.speed[j]);
  return out;
}

ConvectionFluid fluid_of(const Coolant& c) {
  return {c.density, c.viscosity, c.specific_heat, c.conductivity};
}

ConvectionFluid air_at(double T) {
  constexpr int kAir = 13;
  const tribology::FluidProperties air = tribology::fluid_properties(kAir, T);
  return {air.density, air.viscosity, air.specific_heat, air.conductivity};
}

/// Of what fills a bearing that nothing flows through.
ConvectionFluid still_medium(const Bearing& b, double T) {
  if (!b.lubrication) return air_at(T);
  const tribology::Lubricant oil = tribology::lubricant_of(*b.lubrication);
  return {oil.density.at(T), oil.base_viscosity(T), oil.specific_heat.at(T),
          oil.conductivity.at(T)};
}

/// Between ring and housing, ring and shaft [W/K].
std::array<double, 2> joints(const Bearing& b, const NetworkRings& rings) {
  constexpr double kAirConductivity = 0.026, kRoughness = 1.5e-6, kSlope = 0.15, kHardness = 2.5e9;
  std::array<double, 2> pressure{}, interference{};
  if (b.operating) {
    for (std::size_t j = 0; j < 2; ++j) {
      pressure[j] = b.operating->fit[j].pressure;
      interference[j] = b.operating->fit[j].interference;
    }
  } else {
    const MountedState state = mount(mounted_rings(b, raceways(b)));
    pressure = state.pressure;
    interference = state.interference;
  }
  std::array<double, 2> out{};
  for (std::size_t j = 0; j < 2; ++j) {
    const NetworkRing &race = j == 0 ? rings.outer : rings.inner,
                      &mate = j == 0 ? rings.housing : rings.shaft;
    const double gap = std::max(0.0, -0.5 * interference[j]),
                 solid = 2.0 * race.conductivity * mate.conductivity /
                         (race.conductivity + mate.conductivity),
                 h = kAirConductivity / (3.0 * kRoughness + gap) +
                     1.25 * solid * kSlope / kRoughness *
                         std::pow(std::max(pressure[j], 0.0) / kHardness, 0.95);
    out[j] = h * kPi * (j == 0 ? b.envelope.outer_diameter : b.envelope.bore) * race.width;
  }
  return out;
}

/// Housing and shaft to ambient [W/K].
std::array<double, 2> to_ambient(const Bearing& b) {
  constexpr double kDensity = 320.0, kLarge = 0.05, kFall = -0.34, kShaftShare = 0.5;
  constexpr int kFirstCryogenic = 3, kLastCryogenic = 7;
  const bearing::ThermalInputs& in = *b.thermal;
  const bool cryogenic =
      in.coolant >= kFirstCryogenic && in.coolant <= kLastCryogenic && in.flow > 0.0;
  const std::array<double, 2> seat{kPi * b.envelope.outer_diameter * b.envelope.race_width[0],
                                   kPi * b.envelope.bore * b.envelope.race_width[1]};
  const double both = seat[0] + seat[1],
               all = cryogenic ? 0.0
                               : kDensity * both * std::pow(std::max(1.0, both / kLarge), kFall),
               weighted = seat[0] + kShaftShare * seat[1];
  const bearing::Surroundings& given = in.surroundings;
  const auto base = static_cast<BaseNode>(in.base);
  const bool shaft_cools = base == BaseNode::InnerInterface || base == BaseNode::ShaftInside;
  return {given.conductance[0].value_or(shaft_cools ? 0.0 : all * seat[0] / weighted),
          given.conductance[1].value_or(all * kShaftShare * seat[1] / weighted)};
}

BearingNetwork::HeatCapacities capacities(const Bearing& b) {
  constexpr double kSteel = 460.0;  // [J/(kg K)]
  const auto per_volume = [](const bearing::Material& m) {
    return m.density * (m.specific_heat > 0.0 ? m.specific_heat : kSteel);
  };
  const auto ring = [&](const bearing::Material& m, double inside, double outside, double width) {
    return per_volume(m) * kPi * std::max(0.0, outside * outside - inside * inside) * width;
  };
  const bearing::Envelope& e = b.envelope;
  const std::array<double, 2> raceway = raceways(b);
  BearingNetwork::HeatCapacities out;
  out.race = {ring(b.race_material[0], raceway[0], 0.5 * e.outer_diameter, e.race_width[0]),
              ring(b.race_material[1], 0.5 * e.bore, raceway[1], e.race_width[1])};
  out.mate = {
      ring(b.mounting.housing, 0.5 * e.outer_diameter, 0.5 * e.housing_diameter, e.race_width[0]),
      ring(b.mounting.shaft, 0.5 * e.shaft_bore, 0.5 * e.bore, e.race_width[1])};
  const auto of_mass = [&](double mass, const bearing::Material& m) {
    return mass * (m.specific_heat > 0.0 ? m.specific_heat : kSteel);
  };
  out.element = of_mass(b.element_count() * b.element_inertia.mass, b.element_material);
  if (b.cage) out.cage = of_mass(b.cage->segments.count * b.cage->inertia.mass, b.cage->material);
  return out;
}

NetworkTemperatures start_of(const BulkTemperatures& bulk) {
  NetworkTemperatures T;
  T.coolant_in = T.coolant_mean = T.coolant_out = bulk.medium;
  T.element = bulk.element;
  T.cage = bulk.cage;
  T.outer_raceway = T.outer_interface = bulk.race[0];
  T.inner_raceway = T.inner_interface = bulk.race[1];
  T.housing = T.housing_seat = bulk.housing;
  T.shaft = T.shaft_seat = bulk.shaft;
  return T;
}

constexpr double kPatch = 0.005;  ///< half axis over diameter

/// Films whose patches no solution knows, and the touch of a row without load.
void add_patches(BearingNetwork& n, const Bearing& b, double cage_speed) {
  const double D = b.element_diameter(), count = b.element_count();
  const auto patch = [](const bearing::Material& body, double diameter, double speed) {
    return patch_conductance(body, kPatch * diameter, kPatch * diameter, speed);
  };
  for (std::size_t j = 0; j < 2; ++j) {
    const double rolls = std::abs(cage_speed - b.speed[j]) * 0.5 * b.pitch_diameter();
    const FilmConductance touch{count * patch(b.element_material, D, rolls),
                                count * patch(b.race_material[j], D, rolls)};
    if (b.rollers() && b.rollers()->has_flange(static_cast<int>(j))) n.flange[j] = touch;
    if (!(n.race[j].first > 0.0 && n.race[j].second > 0.0)) n.race[j] = touch;
  }
  if (!b.cage) return;
  // Pure rolling on the outer race gives the surface speed of the elements.
  const double surface = std::abs(cage_speed - b.speed[0]) * 0.5 * b.pitch_diameter();
  n.pocket = {count * patch(b.element_material, D, surface),
              count * patch(b.cage->material, D, 0.0)};
  for (const bearing::GuideLand& land : b.cage->lands) {
    if (land.guide == bearing::GuideLand::Guide::None) continue;
    const std::size_t j = land.guide == bearing::GuideLand::Guide::Outer ? 0 : 1;
    n.land[j].first += patch(b.cage->material, land.diameter, 0.0);
    n.land[j].second += patch(b.race_material[j], land.diameter,
                              std::abs(cage_speed - b.speed[j]) * 0.5 * land.diameter);
  }
}

/// Nodes and flows of a ladder, in the form of a network.
void list_ladder(BearingHeat& heat) {
  const NetworkTemperatures& T = heat.temperature;
  if (heat.coolant)
    heat.nodes = {{"coolant inlet", T.coolant_in},
                  {"coolant mean", T.coolant_mean},
                  {"coolant exit", T.coolant_out}};
  for (const auto& [name, at] :
       {std::pair{"rolling elements", T.element}, std::pair{"cage", T.cage},
        std::pair{"outer raceway", T.outer_raceway},
        std::pair{"outer race at the housing", T.outer_interface},
        std::pair{"housing outside", T.housing}, std::pair{"inner raceway", T.inner_raceway},
        std::pair{"inner race at the shaft", T.inner_interface},
        std::pair{"shaft inside", T.shaft}})
    heat.nodes.push_back({name, at});
  if (heat.coolant) {
    heat.links = {{"rolling elements", "coolant mean", heat.flows.element},
                  {"cage", "coolant mean", heat.flows.cage},
                  {"churning", "coolant mean", heat.sources.churning}};
    heat.leaving.push_back({"bearing", "coolant", heat.flows.coolant});
  }
  heat.links.push_back({"outer raceway", "outer race at the housing", heat.flows.race[0]});
  heat.links.push_back({"inner raceway", "inner race at the shaft", heat.flows.race[1]});
  heat.leaving.push_back({"bearing", "housing", heat.flows.race[0]});
  heat.leaving.push_back({"bearing", "shaft", heat.flows.race[1]});
}

/// Notes on the result.
void add_notes(BearingHeat& out, const Bearing& b, double cage_speed) {
  const bearing::ThermalInputs& in = *b.thermal;
  const auto note = [&](const char* code, std::string text) -> Finding& {
    out.notes.push_back(make_finding(code, std::move(text)));
    return out.notes.back();
  };
  if (!(b.envelope.shaft_bore > 0.0))
    note("thermal.solid_shaft",
         "the shaft is solid (shftID = 0): the thermal network uses a shaft bore of 1 % of the "
         "bearing bore");
  constexpr std::array<const char*, 2> kRing{"outer", "inner"}, kMate{"housing", "shaft"};
  for (std::size_t j = 0; j < 2; ++j)
    if (out.turned_back[j] > 0.0)
      note(
          "thermal.ladder",
          fmt::format("thermalModel=ladder: a heat flow of {:.4g} W through the {} race would cool "
                      "the {} below the lowest specified temperature. The flow through this race "
                      "is limited to {:.4g} W. The rest is removed by {}",
                      out.flows.race[j] + out.turned_back[j], kRing[j], kMate[j], out.flows.race[j],
                      out.coolant ? "the coolant"
                      : j == 1    ? "the outer race"
                                  : "the inner race"))
          .of(fmt::format("{} race", kRing[j]))
          .measure("heat flow that is removed elsewhere", out.turned_back[j], "W", 0.0);
  if (out.clamped)
    note("thermal.ladder",
         "thermalModel=ladder: housing or shaft would be colder than the lowest specified "
         "temperature, so this temperature is used and the heat balance has an error. Use "
         "thermalModel=network");
  const double T_mean = out.temperature.coolant_mean;
  if (out.coolant && out.coolant->outside(T_mean))
    note("thermal.coolant_range",
         fmt::format("the properties of the coolant are known from {:g} to {:g} K. The mean "
                     "temperature of the coolant is {:.4g} K, so the properties at the nearer "
                     "limit are used",
                     out.coolant->T_min, out.coolant->T_max, T_mean))
        .measure(T_mean, out.coolant->T_max)
        .at_least(out.coolant->T_min);
  if (out.coolant && b.cage && !in.convection_given) {
    const double reynolds = out.coolant->density * std::abs(cage_speed - b.speed[0]) *
                            b.cage->outer_diameter * b.cage->outer_diameter /
                            (2.0 * out.coolant->viscosity);
    constexpr double kMeasured = 4e5;
    if (reynolds > kMeasured)
      note("thermal.convection",
           fmt::format("convection of the cage is extrapolated: the Reynolds number is {:.3g}, but "
                       "the correlation was measured only up to {:.0e}",
                       reynolds, kMeasured))
          .of("cage")
          .measure(reynolds, kMeasured);
  }
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

BearingHeat solve_bearing_heat(const Bearing& b, const HeatSources& sources, double cage_speed,
                               const RaceConductance& contact, const HeatStep* step) {
  demand(b.thermal.has_value(), "a thermal network was requested without thermal analysis");
  const bearing::ThermalInputs& in = *b.thermal;
  const bool flows = in.coolant > 0 && in.flow > 0.0,
             is_ladder = in.model == bearing::ThermalModel::Ladder;
  const Surfaces surfaces = surfaces_of(b, cage_speed);
  BearingHeat out;
  out.sources = sources;
  out.element_area = surfaces.element;
  out.cage_area = surfaces.cage;
  out.bulk = BulkTemperatures::in(b);
  Ladder ladder;
  ladder.flows = split_heat_sources(sources, {});
  ladder.base = static_cast<BaseNode>(in.base);
  ladder.base_temperature = in.base_temperature;
  BearingNetwork network;
  network.sources = sources;
  network.base = ladder.base;
  network.base_temperature = in.base_temperature;
  network.ambient = in.surroundings.ambient.value_or(b.room_temperature);
  network.coolant_in = in.surroundings.coolant_inlet && ladder.base != BaseNode::CoolantIn
                           ? *in.surroundings.coolant_inlet
                           : in.base_temperature;
  network.cage = b.cage.has_value();
  network.race = contact;
  TransientStep in_time;
  if (step != nullptr) {
    network.capacity = capacities(b);
    in_time = {step->before, start_of(out.bulk), step->duration};
  }
  double T_in = in.base_temperature, T_mean = flows ? in.base_temperature : b.element_temperature;
  std::array<double, 7> before{};
  for (int pass = 0; pass < kPasses; ++pass) {
    const NetworkRings rings = rings_of(b, out.bulk);
    check(rings);
    Convection convection;
    double capacity_flow = 0.0;
    if (flows) {
      Coolant coolant = coolant_at(b, T_mean);
      coolant.mass_flow = coolant_at(b, T_in).density * in.flow;
      capacity_flow = coolant.mass_flow * coolant.specific_heat;
      if (in.convection_given) {
        convection.element = in.element_convection;
        convection.cage = in.cage_convection;
        convection.race.fill(in.element_convection);
      } else {
        convection = convection_in(b, fluid_of(coolant), surfaces, cage_speed);
      }
      if (!(capacity_flow > 0.0 && convection.element > 0.0 && (!b.cage || convection.cage > 0.0)))
        throw InputError(fmt::format(
            "the coolant {} removes no heat: its flow times its specific heat is {:g} W/K, and the "
            "convection coefficients of elements and cage are {:g} and {:g} W/m^2/K. Enter reHTC "
            "and cageHTC above 0 (or kHTC = 0), and a specific heat above 0",
            coolant.name, capacity_flow, convection.element, convection.cage));
      out.coolant = std::move(coolant);
    } else if (!is_ladder) {
      convection = convection_in(b, still_medium(b, T_mean), surfaces, cage_speed);
    }
    out.element_convection = convection.element;
    out.cage_convection = convection.cage;
    const double element_film = convection.element * surfaces.element,
                 cage_film = b.cage ? convection.cage * surfaces.cage : 0.0;
    if (is_ladder) {
      ladder.rings = rings;
      ladder.capacity_flow = capacity_flow;
      ladder.element_film = element_film;
      ladder.cage_film = b.cage ? cage_film : 1.0;
      const LadderResult result = solve_guarded_ladder(ladder, b.room_temperature);
      out.temperature = result.temperature;
      out.flows = result.flows;
      out.turned_back = result.turned_back;
      out.clamped = result.clamped;
    } else {
      network.rings = rings;
      network.joint = joints(b, rings);
      network.to_ambient = to_ambient(b);
      network.capacity_flow = capacity_flow;
      network.element_film = element_film;
      network.cage_film = cage_film;
      for (std::size_t j = 0; j < 2; ++j)
        network.race_film[j] = convection.race[j] * surfaces.race[j];
      if (pass == 0) add_patches(network, b, cage_speed);
      BearingNetworkResult result =
          solve_bearing_network(network, step == nullptr ? nullptr : &in_time);
      out.state = std::move(result.state);
      out.stored = result.stored;
      out.temperature = result.temperature;
      out.flows = result.flows;
      out.nodes = std::move(result.nodes);
      out.links = std::move(result.links);
      out.leaving = std::move(result.leaving);
      out.contact = network.race;
      out.to_ambient = network.to_ambient;
    }
    out.rings = rings;
    out.bulk = bulk_of(rings, out.temperature);
    T_in = out.temperature.coolant_in;
    T_mean = out.temperature.coolant_mean;
    const auto now = out.bulk.list();
    double change = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k)
      change = std::max(change, std::abs(now[k] - before[k]));
    before = now;
    if (change < kTried) break;
    // No properties exist below absolute zero: runaway() and too_cold() report it.
    if (!describe_thermal_runaway(out.bulk).empty() || (flows && !(T_in > 0.0 && T_mean > 0.0)))
      break;
  }
  if (is_ladder) list_ladder(out);
  add_notes(out, b, cage_speed);
  return out;
}

std::string describe_thermal_runaway(const BulkTemperatures& bulk) {
  const auto list = bulk.list();
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!(list[k] <= kHottest))
      return fmt::format("{} at {:.4g} K, above {:g} K", kBulkNames[k], list[k], kHottest);
    if (!(list[k] > 1.0)) return fmt::format("{} at {:.4g} K", kBulkNames[k], list[k]);
  }
  return {};
}

std::string describe_overheated_node(const BearingHeat& heat) {
  const auto hottest = std::max_element(heat.nodes.begin(), heat.nodes.end(),
                                        [](const NodeTemperature& a, const NodeTemperature& b) {
                                          return a.temperature < b.temperature;
                                        });
  if (hottest == heat.nodes.end() || hottest->temperature <= kHottest) return {};
  return fmt::format("{} at {:.4g} K; the thermal network is not valid above {:g} K", hottest->name,
                     hottest->temperature, kHottest);
}

}  // namespace adore::thermal
