#include "listing/print_heat.hpp"

#include "deck/unit_text.hpp"
#include "results/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace adore::listing {
namespace {

constexpr std::array<const char*, 2> kRace{"outer race", "inner race"};

struct Cause {
  std::string name;
  double power;
};

/// Everything that dissipates, in the order of the pages.
std::vector<Cause> causes(const statics::FrictionEstimate& f) {
  std::vector<Cause> out;
  for (const int j : {0, 1}) {
    const statics::FrictionOfContact sum = f.of_race(j);
    const std::string at = fmt::format("{}", kRace[static_cast<std::size_t>(j)]);
    out.push_back({"spin, " + at, sum.spin});
    out.push_back({"sliding of the curved contact, " + at, sum.sliding});
    out.push_back({"viscous rolling, " + at, sum.rolling});
    const double flange = f.flange[static_cast<std::size_t>(j)];
    if (flange > 0.0) out.push_back({"flanges, " + at, flange});
  }
  if (!f.medium.empty()) {
    const std::string in_medium = " in the medium";
    out.push_back({"drag of elements" + in_medium, f.element_drag});
    out.push_back({"drag of the cage" + in_medium, f.cage_drag});
  }
  return out;
}

std::string certainty(const std::string& provenance) {
  if (provenance == "given") return "the deck's own";
  if (provenance == "seen") return "from a public source";
  if (provenance == "recalled") return "at least one recalled, not seen";
  return "AT LEAST ONE AN ESTIMATE, not a measured value";
}

void network(Report& report, const thermal::BearingHeat& heat) {
  const bool is_ladder = heat.contact[0].first == 0.0;
  report.heading(is_ladder ? "Temperatures of the ladder" : "Temperatures of the network");
  for (const thermal::NodeTemperature& node : heat.nodes)
    report.item(node.name, node.temperature, unit::kTemperature);
  report.heading("Mean temperatures, for growth and material");
  const auto list = heat.bulk.list();
  for (std::size_t k = 0; k < list.size(); ++k)
    if (k + 1 < list.size() || heat.coolant)
      report.item(thermal::kBulkNames[k], list[k], unit::kTemperature);
  report.heading("Heat");
  const thermal::HeatSources& q = heat.sources;
  for (std::size_t j = 0; j < 2; ++j) {
    report.item(fmt::format("Made at the {}", kRace[j]), q.race[j], unit::kPower);
    if (q.flange[j] > 0.0)
      report.item(fmt::format("Made at the flanges, {}", kRace[j]), q.flange[j], unit::kPower);
    if (q.land[j] > 0.0)
      report.item(fmt::format("Made at the guide lands, {}", kRace[j]), q.land[j], unit::kPower);
  }
  if (q.element_cage > 0.0) report.item("Made in the cage pockets", q.element_cage, unit::kPower);
  if (q.churning > 0.0) report.item("Made by churning and drag", q.churning, unit::kPower);
  report.item("Made in all", q.total(), unit::kPower);
  for (const thermal::NodeFlow& flow : heat.links)
    report.item(fmt::format("From {} to {}", flow.from, flow.to), flow.heat, unit::kPower);
  for (const thermal::NodeFlow& flow : heat.leaving)
    report.item(fmt::format("Leaves to {}", flow.to), flow.heat, unit::kPower);
  if (heat.stored != 0.0) report.item("Warms the parts", heat.stored, unit::kPower);
  report.item("Made less taken", heat.imbalance(), unit::kPower);
  if (!is_ladder) {
    report.heading("Conductances");
    for (std::size_t j = 0; j < 2; ++j) {
      report.item(fmt::format("Contact film to rolling elements, {}", kRace[j]),
                  heat.contact[j].first, unit::kConductance);
      report.item(fmt::format("Contact film to the {}", kRace[j]), heat.contact[j].second,
                  unit::kConductance);
    }
    report.item("Housing to ambient", heat.to_ambient[0], unit::kConductance);
    report.item("Shaft to ambient", heat.to_ambient[1], unit::kConductance);
  }
  if (heat.coolant) {
    const thermal::Coolant& c = *heat.coolant;
    report.heading("Coolant");
    report.item("Coolant", c.name);
    report.item("Its properties", certainty(c.provenance));
    report.item("Density", c.density, unit::kDensity);
    report.item("Viscosity", c.viscosity, unit::kViscosity);
    report.item("Specific heat", c.specific_heat, unit::kSpecificHeat);
    report.item("Conductivity", c.conductivity, unit::kConductivity);
  } else {
    report.text("No coolant flows: all heat leaves through the races.");
  }
  if (heat.element_convection > 0.0)
    report.item("Convection of rolling elements", heat.element_convection, unit::kConvection);
  if (heat.cage_area > 0.0 && heat.cage_convection > 0.0)
    report.item("Convection of the cage", heat.cage_convection, unit::kConvection);
  if (is_ladder)
    report.text(
        "Ladder (thermalModel=ladder): half of the heat of a contact goes into either body; "
        "raceways have the temperature of the rolling elements; the heat balance is not closed.");
  for (const std::string& note : heat.notes) report.text(note);
}

std::string quantity(double si, const UnitPair& unit, UnitSystem units) {
  return Report::number(from_si(si, unit, units)) + " " + std::string(unit_name(unit, units));
}

}  // namespace

void print_friction(Report& report, const statics::FrictionEstimate& f,
                    const std::string& element) {
  report.new_page("FRICTION: ESTIMATE FROM THE EQUILIBRIUM");
  report.item("Traction", f.law);
  if (!f.medium.empty()) {
    report.item("Churning medium", f.medium);
    report.item("Its properties", certainty(f.medium_provenance));
  }
  if (const std::string why = f.why_none(); !why.empty()) {
    report.item("Power loss", "not computed");
    report.item("Friction torque", "not computed");
    report.text("Not computed: " + why + ".");
    return;
  }
  report.heading("Heat by cause");
  for (const Cause& cause : causes(f)) report.item(cause.name, cause.power, unit::kPower);
  report.item("Power loss", f.power(), unit::kPower);
  report.item("Friction torque: power over the relative speed of the races", f.torque(),
              unit::kMoment);
  std::vector<Report::Row> rows;
  for (std::size_t i = 0; i < f.race[0].size(); ++i) {
    Report::Row row{std::to_string(i + 1), {}};
    for (const auto& race : f.race)
      for (const double value : {race[i].spin, race[i].sliding, race[i].rolling})
        row.values.push_back(value);
    rows.push_back(std::move(row));
  }
  report.heading("Heat of the contacts");
  report.table(element,
               {{"spin outer", &unit::kPower},
                {"slide outer", &unit::kPower},
                {"roll outer", &unit::kPower},
                {"spin inner", &unit::kPower},
                {"slide inner", &unit::kPower},
                {"roll inner", &unit::kPower}},
               rows);
  report.text(
      "Each contact creeps so that it carries no force along the rolling direction; elastic "
      "hysteresis is not included.");
  for (const std::string& note : f.notes) report.text(deck::message_in_units(note, report.units()));
}

void print_steady_state(Report& report, const thermal::SteadyState& steady) {
  report.new_page("THERMAL STEADY STATE");
  report.text(steady.as_built.thermal->geometry_every > 0
                  ? "Temperatures, operating geometry, loads and friction are consistent."
                  : "Temperatures, oil and friction are consistent; geometry and material stay "
                    "those of record 9.1.3 (kGeoMod = 0).");
  report.item("Passes", static_cast<long>(steady.passes));
  report.item("Largest change of the last pass", steady.change, unit::kTemperature);
  report.item("Growth of heat with temperature over its removal (unstable above 1)", steady.gain,
              unit::kPure);
  if (steady.friction.why_none().empty()) {
    report.item("Power loss", steady.friction.power(), unit::kPower);
    report.item("Friction torque", steady.friction.torque(), unit::kMoment);
  } else {
    report.item("Power loss", "not computed");
    report.item("Friction torque", "not computed");
  }
  if (steady.operating.operating)
    report.item("Operating clearance", steady.operating.operating->operating.clearance,
                unit::kLength);
  network(report, steady.heat);
}

void print_thermal_step(Report& report, const thermal::BearingHeat& heat, long step, double time,
                        bool geometry) {
  report.new_page("THERMAL STEP");
  report.item("Thermal step", step);
  report.item("Its end", time, unit::kTime);
  report.text(geometry ? "Geometry and material change with this step."
                       : "Geometry and material do not change; oil and medium follow.");
  network(report, heat);
}

StaticTable friction_table(const statics::FrictionEstimate& f) {
  StaticTable out{"friction", {}};
  if (!f.why_none().empty()) return out;
  for (const Cause& cause : causes(f)) out.add(cause.name, unit::kPower, {cause.power});
  out.add("power loss", unit::kPower, {f.power()});
  out.add("friction torque", unit::kMoment, {f.torque()});
  return out;
}

void add_friction_columns(StaticTable& elements, const statics::FrictionEstimate& f) {
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = j == 0 ? "outer " : "inner ";
    const auto add = [&](const char* name, double statics::FrictionOfContact::*member) {
      std::vector<double> values;
      for (const statics::FrictionOfContact& one : f.race[j]) values.push_back(one.*member);
      elements.add(race + name, unit::kPower, std::move(values));
    };
    add("spin heat", &statics::FrictionOfContact::spin);
    add("sliding heat", &statics::FrictionOfContact::sliding);
    add("rolling heat", &statics::FrictionOfContact::rolling);
  }
}

StaticTable network_table(const thermal::BearingHeat& heat) {
  StaticTable out{"thermal network", {}};
  for (const thermal::NodeTemperature& node : heat.nodes)
    out.add(node.name, unit::kTemperature, {node.temperature});
  for (const thermal::NodeFlow& flow : heat.links)
    out.add(fmt::format("{} to {}", flow.from, flow.to), unit::kPower, {flow.heat});
  for (const thermal::NodeFlow& flow : heat.leaving)
    out.add(fmt::format("leaves to {}", flow.to), unit::kPower, {flow.heat});
  if (heat.stored != 0.0) out.add("stays in the parts", unit::kPower, {heat.stored});
  out.add("mean of the outer race", unit::kTemperature, {heat.bulk.race[0]});
  out.add("mean of the inner race", unit::kTemperature, {heat.bulk.race[1]});
  const thermal::HeatSources& q = heat.sources;
  out.add("made at the outer race", unit::kPower, {q.race[0] + q.flange[0] + q.land[0]});
  out.add("made at the inner race", unit::kPower, {q.race[1] + q.flange[1] + q.land[1]});
  out.add("made in the pockets", unit::kPower, {q.element_cage});
  out.add("made by churning", unit::kPower, {q.churning});
  return out;
}

StaticTable time_line_table(const thermal::TimeLine& line) {
  StaticTable out{"thermal time line", {}};
  const auto add = [&](const char* name, const UnitPair& unit, auto&& value) {
    std::vector<double> values;
    for (const thermal::TimeLinePoint& point : line.points) values.push_back(value(point));
    out.add(name, unit, std::move(values));
  };
  using Point = thermal::TimeLinePoint;
  add("time", unit::kTime, [](const Point& p) { return p.time; });
  add("heat", unit::kPower, [](const Point& p) { return p.heat; });
  add("heat that warms the parts", unit::kPower, [](const Point& p) { return p.stored; });
  for (std::size_t k = 0; k < thermal::kBulkNames.size(); ++k)
    add(thermal::kBulkNames[k], unit::kTemperature,
        [k](const Point& p) { return p.bulk.list()[k]; });
  add("operating clearance", unit::kLength, [](const Point& p) { return p.clearance; });
  return out;
}

void print_time_line(Report& report, const thermal::TimeLine& line) {
  report.new_page("THERMAL TIME LINE");
  report.text(
      "From the temperatures of record 9.1.3 to the steady state, at constant speed and load, with "
      "heat capacities.");
  constexpr std::size_t kRows = 50;
  const std::size_t every = std::max<std::size_t>(1, line.points.size() / kRows);
  std::vector<Report::Row> rows;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (i % every != 0 && i + 1 != line.points.size()) continue;
    const thermal::TimeLinePoint& p = line.points[i];
    rows.push_back({std::to_string(i),
                    {p.time, p.heat, p.bulk.race[0], p.bulk.race[1], p.bulk.element, p.bulk.housing,
                     p.bulk.shaft, p.clearance}});
  }
  report.table("step",
               {{"time", &unit::kTime},
                {"heat", &unit::kPower},
                {"outer race", &unit::kTemperature},
                {"inner race", &unit::kTemperature},
                {"elements", &unit::kTemperature},
                {"housing", &unit::kTemperature},
                {"shaft", &unit::kTemperature},
                {"clearance", &unit::kLength}},
               rows);
}

std::vector<std::string> heat_lines(const statics::FrictionEstimate& f,
                                    const thermal::SteadyState* steady, UnitSystem units) {
  std::vector<std::string> out;
  const std::string why = f.why_none();
  out.push_back(!why.empty()
                    ? "friction torque: not computed: " + why
                    : fmt::format("friction torque: {}, power loss {} (estimate without {})",
                                  quantity(f.torque(), unit::kMoment, units),
                                  quantity(f.power(), unit::kPower, units),
                                  f.oil ? "the cage" : "cage and oil"));
  if (steady == nullptr) return out;
  const thermal::BulkTemperatures& T = steady->heat.bulk;
  std::string line = fmt::format("temperatures: outer race {}, inner race {}, elements {}",
                                 quantity(T.race[0], unit::kTemperature, units),
                                 quantity(T.race[1], unit::kTemperature, units),
                                 quantity(T.element, unit::kTemperature, units));
  if (steady->heat.coolant)
    line += fmt::format(", coolant {} to {}",
                        quantity(steady->heat.temperature.coolant_in, unit::kTemperature, units),
                        quantity(steady->heat.temperature.coolant_out, unit::kTemperature, units));
  out.push_back(std::move(line));
  return out;
}

}  // namespace adore::listing
