#include "base/errors.hpp"
#include "deck/defaults.hpp"
#include "deck/orbit_records.hpp"
#include "deck/schema.hpp"
#include "life/constants.hpp"
#include "listing/print_cage.hpp"
#include "listing/print_file.hpp"
#include "listing/print_imperfections.hpp"
#include "statics/ball_friction.hpp"
#include "statics/roller_friction.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

/// Front part of PRINT.txt (outputs.md 3.1).
namespace adore::listing {
namespace {

std::string value_text(const deck::Value& value) {
  if (const auto* integer = std::get_if<long long>(&value)) return std::to_string(*integer);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  if (const auto* text = std::get_if<std::string>(&value)) return "'" + *text + "'";
  return "(no value)";
}

/// The first sentence of the help, without its full stop, and what the chosen code means.
std::string meaning(const deck::VariableSpec& variable, const std::vector<deck::Value>& values) {
  if (variable.name == "recID") return {};
  std::string text(variable.help.substr(0, variable.help.find(". ")));
  if (!text.empty() && text.back() == '.') text.pop_back();
  if (values.size() != 1) return text;
  const std::string code = value_text(values.front());
  const auto look_up = [&](std::span<const deck::OptionSpec> options) {
    for (const deck::OptionSpec& option : options)
      if (option.code == code) text += fmt::format(": {}", option.meaning);
  };
  if (!variable.options.empty()) look_up(variable.options);
  if (!variable.option_table.empty()) look_up(deck::option_table(variable.option_table));
  return text;
}

void defaults(Report& report, const deck::Deck& deck) {
  report.heading("Default values of variables that are not in the deck");
  std::vector<std::vector<std::string>> rows;
  for (const deck::DefaultUsed& used : deck::defaults_used(deck))
    rows.push_back({used.record, used.variable, used.value, used.unit});
  if (rows.empty()) {
    report.text("None. The deck contains all values.");
    return;
  }
  report.text_table({{"record", 14}, {"variable", 18}, {"value", 76}, {"unit", 12}}, rows);
}

void echo(Report& report, const deck::Deck& deck) {
  report.new_page("INPUT");
  report.text(
      "This page lists all records as read, in the units of the deck. The descriptions are not "
      "part of the deck. The meaning of a selected code follows the description.");
  const deck::Deck shown = deck::with_orbit_records(deck);
  for (const deck::RecordData& record : shown.records) {
    const deck::RecordSpec* spec = deck::find_record(record.id);
    demand(spec != nullptr, "the deck contains a record that is not in the schema");
    report.heading(fmt::format(
        "Record {}{}: {}", record.id,
        spec->repeat.empty() ? std::string() : fmt::format(" ({})", record.instance), spec->title));
    for (std::size_t v = 0; v < record.values.size() && v < spec->variables.size(); ++v) {
      const deck::VariableSpec& variable = spec->variables[v];
      std::string values;
      for (const deck::Value& value : record.values[v])
        values += (values.empty() ? "" : ", ") + value_text(value);
      std::string_view unit = unit_name(variable.unit, report.units());
      if (unit == "-") unit = {};
      const std::string what = meaning(variable, record.values[v]);
      if (values.size() <= 20)
        report.text(fmt::format("{:<16}{:>20}  {:<14}{}", variable.name, values, unit, what), 4);
      else
        report.text(fmt::format("{:<16}{}  {}  {}", variable.name, values, unit, what), 4);
    }
  }
  defaults(report, deck);
  if (deck.user_lines.empty()) return;
  report.heading("Input lines for user routines");
  for (const std::string& line : deck.user_lines) report.text(line, 4);
}

void ball_geometry(Report& report, const bearing::Bearing& bearing) {
  const bearing::BallGeometry& balls = bearing.balls();
  report.item("Number of balls", static_cast<long>(balls.count));
  report.item("Ball diameter", balls.diameter, unit::kLength);
  report.item("Pitch diameter", balls.pitch_diameter, unit::kLength);
  report.item("Free contact angle", balls.contact_angle, unit::kAngle);
  report.item("Diametral clearance without shims (negative: interference)", balls.clearance,
              unit::kLength);
  report.item("Bearing bore", bearing.envelope.bore, unit::kLength);
  report.item("Bearing outside diameter", bearing.envelope.outer_diameter, unit::kLength);
  report.item("Shaft bore", bearing.envelope.shaft_bore, unit::kLength);
  report.item("Housing outside diameter", bearing.envelope.housing_diameter, unit::kLength);
  report.blank();
  std::vector<Report::Row> rows;
  for (int race = 0; race < 2; ++race) {
    const auto r = static_cast<std::size_t>(race);
    rows.push_back({race == bearing::kOuter ? "outer race" : "inner race",
                    {balls.groove_factor[r], balls.groove_factor[r] * balls.diameter,
                     balls.shoulder_diameter[r], balls.shim[r], bearing.envelope.race_width[r],
                     balls.roughness[r]}});
  }
  report.table("",
               {{"groove/D", &unit::kPure},
                {"groove rad", &unit::kLength},
                {"shoulder", &unit::kLength},
                {"shim", &unit::kLength},
                {"race width", &unit::kLength},
                {"roughness", &unit::kLength}},
               rows, 12);
}

void geometry(Report& report, const bearing::Bearing& bearing, const deck::Deck& deck) {
  report.new_page("BEARING GEOMETRY");
  if (bearing.rollers())
    print_roller_geometry(report, *bearing.rollers(), bearing.envelope);
  else
    ball_geometry(report, bearing);
  print_cage_geometry(report, bearing, deck);
}

void materials(Report& report, const bearing::Bearing& bearing) {
  struct Part {
    const char* name;
    const bearing::Material* material;
  };
  std::vector<Part> parts{{bearing.rollers() ? "rollers" : "balls", &bearing.element_material},
                          {"outer race", &bearing.race_material[0]},
                          {"inner race", &bearing.race_material[1]}};
  if (bearing.cage) parts.push_back({"cage", &bearing.cage->material});
  parts.push_back({"housing", &bearing.mounting.housing});
  parts.push_back({"shaft", &bearing.mounting.shaft});
  report.new_page("MATERIAL PROPERTIES AND INERTIA");
  std::vector<std::vector<std::string>> names;
  for (const Part& part : parts)
    names.push_back({part.name, part.material->name, std::to_string(part.material->code),
                     part.material->provenance});
  report.text_table({{"part", 12}, {"material", 60}, {"code", 6}, {"least reliable source", 30}},
                    names);
  report.blank();
  struct Property {
    const char* name;
    double bearing::Material::*member;
    const UnitPair* unit;
  };
  const std::array<Property, 10> properties{
      {{"Density", &bearing::Material::density, &unit::kDensity},
       {"Elastic modulus", &bearing::Material::elastic_modulus, &unit::kPressure},
       {"Poisson's ratio", &bearing::Material::poisson_ratio, &unit::kPure},
       {"Coefficient of thermal expansion", &bearing::Material::thermal_expansion,
        &unit::kPerTemperature},
       {"Thermal conductivity", &bearing::Material::conductivity, &unit::kConductivity},
       {"Specific heat", &bearing::Material::specific_heat, &unit::kSpecificHeat},
       {"Elastic strain limit", &bearing::Material::elastic_strain_limit, &unit::kPure},
       {"Hardness, as indentation pressure", &bearing::Material::hardness, &unit::kPressure},
       {"Wear coefficient", &bearing::Material::wear_coefficient, &unit::kPure},
       {"Fatigue limit stress (von Mises)", &bearing::Material::fatigue_limit_stress,
        &unit::kPressure}}};
  const auto table = [&](std::span<const Part> some) {
    std::vector<std::pair<std::string, std::size_t>> columns{{"property", 36}, {"unit", 16}};
    for (const Part& part : some) columns.emplace_back(part.name, 14);
    std::vector<std::vector<std::string>> rows;
    for (const Property& property : properties) {
      std::vector<std::string> row{property.name,
                                   property.unit == &unit::kPure
                                       ? std::string()
                                       : std::string(unit_name(*property.unit, report.units()))};
      for (const Part& part : some) {
        // The deck's records leave out what a part does not need: 0 there means not given.
        const double value = part.material->*property.member;
        // Without a known fatigue limit the material has its yield stress instead.
        const int code = part.material->code;
        const bool no_limit = property.member == &bearing::Material::fatigue_limit_stress &&
                              code != 1 &&
                              (part.material->table_key == "mild_steel" ||
                               !life::fatigue_limit_of_code(code == 0 ? 100 : code));
        const bool missing = (value == 0.0 && part.material->code == 1) || no_limit;
        row.push_back(missing ? "-"
                              : Report::number(from_si(value, *property.unit, report.units())));
      }
      rows.push_back(std::move(row));
    }
    report.text_table(columns, rows);
  };
  const std::span<const Part> all(parts);
  table(all.first(all.size() - 2));
  report.blank();
  table(all.last(2));

  report.heading("Inertia about the mass center, geometric axes");
  std::vector<Report::Row> inertia, places;
  const auto add = [&](const char* name, const bearing::Inertia& body) {
    inertia.push_back({name, {body.mass, body.moments.x(), body.moments.y(), body.moments.z()}});
    if (body.geometric_centre.isZero(0.0) && body.frame.isZero(0.0)) return;
    const bearing::Vec3 &c = body.geometric_centre, &a = body.frame;
    places.push_back({name, {c.x(), c.y(), c.z(), a.x(), a.y(), a.z()}});
  };
  add(bearing.rollers() ? "roller" : "ball", bearing.element_inertia);
  if (bearing.first_inertia) add("element 1", *bearing.first_inertia);
  if (bearing.cage && bearing.cage->inertia.mass > 0.0)
    add(bearing.cage->segments.several() ? "segment" : "cage", bearing.cage->inertia);
  add("outer race", bearing.race_inertia[0]);
  add("inner race", bearing.race_inertia[1]);
  report.table("",
               {{"mass", &unit::kMass},
                {"about x", &unit::kInertia},
                {"about y", &unit::kInertia},
                {"about z", &unit::kInertia}},
               inertia, 12);
  if (places.empty()) return;
  report.text(
      "Unbalance: position of the geometric center relative to the mass center; angles from the "
      "principal axes to the geometric axes");
  report.table("",
               {{"x", &unit::kLength},
                {"y", &unit::kLength},
                {"z", &unit::kLength},
                {"about x", &unit::kAngle},
                {"about y", &unit::kAngle},
                {"about z", &unit::kAngle}},
               places, 12);
}

void traction(Report& report, const bearing::Bearing& bearing) {
  report.heading("Traction coefficient k as a function of slip speed u");
  const auto curve = [&](std::string_view where, const bearing::TractionCurve& c) {
    const bool exponential = c.form == bearing::TractionCurve::Form::Exponential;
    report.text(fmt::format("{}: {}", where,
                            exponential ? "k = (A + B u) exp(-C u) + D"
                                        : "k = A + B u up to u0, k = A + B u0 + C (u - u0) above"));
    report.item("    A", c.A, unit::kPure);
    report.item("    B", c.B, unit::kPerSpeed);
    report.item("    C", c.C, unit::kPerSpeed);
    if (exponential)
      report.item("    D", c.D, unit::kPure);
    else
      report.item("    u0", c.u0, unit::kSpeed);
  };
  curve("Rolling element to race", bearing.race_traction);
  if (bearing.pocket_traction) curve("Rolling element to cage pocket", *bearing.pocket_traction);
  if (bearing.land_traction) curve("Cage to race", *bearing.land_traction);
  report.item("Slip speed below which the traction law is smoothed", tribology::kRegularizationSlip,
              unit::kSpeed);
}

void operation(Report& report, const FrontMatter& front) {
  const bearing::Bearing& bearing = front.bearing;
  report.new_page("INITIAL OPERATING CONDITIONS");
  report.item("Outer race speed", bearing.speed[0], unit::kRotation);
  report.item("Inner race speed", bearing.speed[1], unit::kRotation);
  const bearing::StaticConstraints& c = bearing.constraints;
  const char* const axes[] = {"along x", "along y", "along z", "about y", "about z"};
  for (std::size_t k = 0; k < 5; ++k) {
    const bool turn = k >= 3;
    if (c.displacement_given[k])
      report.item(fmt::format("Inner race {}: {} given, {} found", axes[k],
                              turn ? "misalignment" : "displacement", turn ? "moment" : "force"),
                  c.displacement[k], turn ? unit::kAngle : unit::kLength);
    else
      report.item(fmt::format("Inner race {}: {} given, {} found", axes[k],
                              turn ? "moment" : "force", turn ? "misalignment" : "displacement"),
                  c.load[k], turn ? unit::kMoment : unit::kForce);
  }
  report.item("Misalignment of the outer race about y", c.outer_misalignment[0], unit::kAngle);
  report.item("Misalignment of the outer race about z", c.outer_misalignment[1], unit::kAngle);
  const char* spin = bearing.spin_rule == bearing::SpinRule::MinimumHeat   ? "minimum heat"
                     : bearing.spin_rule == bearing::SpinRule::RaceControl ? "race control"
                                                                           : "given direction";
  // kAngVel is a rule for balls.
  statics::BallStaticsOptions statics;
  statics::RollerOptions rollers;
  for (const auto& [name, value] : front.options) {
    const bool asked =
        value == "balance" && !(front.deck.has("kTrac") && front.deck.integer("kTrac") == -1);
    if (name == "ballFriction") statics.friction_balance = asked;
    if (name == "rollerFriction") rollers.friction_balance = asked;
    if (name == "rollerContact" && value == "point")
      rollers.contact = statics::RollerContact::Point;
  }
  report.item("Assumption for the speeds of the rolling elements",
              statics::has_friction_balance(bearing, rollers)
                  ? "friction equilibrium (fallback: pure rolling at nominal geometry)"
              : bearing.rollers() ? "pure rolling at nominal geometry"
              : statics::has_friction_balance(bearing, statics)
                  ? fmt::format("friction equilibrium (fallback: {})", spin)
                  : spin);
  if (!bearing.rollers() && bearing.spin_rule == bearing::SpinRule::Prescribed)
    report.item("Angle between the spin axis and the x axis", bearing.spin_angle, unit::kAngle);
  for (int k = 0; k < 3; ++k)
    report.item(fmt::format("Gravity along {}", "xyz"[k]), bearing.gravity[k], unit::kAcceleration);
  report.item("Outer race temperature", bearing.race_temperature[0], unit::kTemperature);
  report.item("Inner race temperature", bearing.race_temperature[1], unit::kTemperature);
  report.item("Rolling element temperature", bearing.element_temperature, unit::kTemperature);
  if (bearing.cage) report.item("Cage temperature", bearing.cage_temperature, unit::kTemperature);
  report.item("Housing temperature", bearing.mounting.housing_temperature, unit::kTemperature);
  report.item("Shaft temperature", bearing.mounting.shaft_temperature, unit::kTemperature);
  report.item("Room temperature", bearing.room_temperature, unit::kTemperature);
  report.item("Diametral fit of the outer race, cold (positive: interference)",
              bearing.mounting.fit[0], unit::kLength);
  report.item("Diametral fit of the inner race, cold (positive: interference)",
              bearing.mounting.fit[1], unit::kLength);
  report.item("Material properties", bearing.mounting.material_laws
                                         ? "at the temperature of each part"
                                         : "at room temperature (constant)");
  const int pieces =
      bearing.cage && front.deck.integer("mode") >= 0 ? bearing.cage->segments.count : 0;
  for (int piece = 0; piece < pieces; ++piece) {
    const bearing::CageStartState& start = bearing.cage->start_of(static_cast<std::size_t>(piece));
    const std::string name = pieces > 1 ? fmt::format("cage segment {}", piece + 1) : "cage";
    report.heading(fmt::format("Initial state of the {}", name));
    report.item("Whirl speed divided by the angular speed of the cage", start.whirl_ratio,
                unit::kPure);
    report.item("Angular speed of the cage divided by the epicyclic speed", start.speed_ratio,
                unit::kPure);
    for (int k = 0; k < 3; ++k)
      report.item(fmt::format("Center position along {}", "xyz"[k]), start.start_offset[k],
                  unit::kLength);
    for (int k = 0; k < 3; ++k)
      report.item(fmt::format("Angle {} of the {}",
                              std::array{"eta", "xi", "lambda"}[static_cast<std::size_t>(k)], name),
                  start.start_angles[k], unit::kAngle);
  }
  if (front.deck.integer("mode") < 0) return;
  report.heading(
      "Constraints of the races in the dynamic run (1: motion specified, 0: load specified)");
  const auto flag = [&](const char* name) {
    return front.deck.has(name) ? front.deck.integer(name) : 1;
  };
  for (const auto& [label, names] :
       {std::pair{"Translation: outer x, y, z, inner x, y, z",
                  std::vector<const char*>{"kFD11", "kFD21", "kFD31", "kFD12", "kFD22", "kFD32"}},
        std::pair{
            "Rotation: outer x, y, z, inner x, y, z",
            std::vector<const char*>{"kMD11", "kMD21", "kMD31", "kMD12", "kMD22", "kMD32"}}}) {
    std::string text;
    for (const char* name : names) text += fmt::format("{:>3}", flag(name));
    report.item(label, text.substr(2));
  }
}

void scales(Report& report, const scene::Scales& s) {
  report.heading("Scale factors");
  report.text(
      "Multiply a dimensionless number of the deck (step sizes and end time of record 2.1) by its "
      "scale factor to get the value with units.");
  report.item("Length: radius of a rolling element", s.length, unit::kLength);
  report.item("Force: largest applied load", s.force, unit::kForce);
  report.item("Time: sqrt(mass / stiffness) of the stiffest race contact", s.time, unit::kTime);
  report.item("Velocity", s.length / s.time, unit::kSpeed);
  report.item("Acceleration", s.length / (s.time * s.time), unit::kAcceleration);
  report.item("Angular velocity", 1.0 / s.time, unit::kRotation);
  report.item("Angular acceleration", 1.0 / (s.time * s.time), unit::kRotationRate);
  report.item("Moment", s.force * s.length, unit::kMoment);
  report.item("Mass", s.force * s.time * s.time / s.length, unit::kMass);
  report.item("Pressure", s.force / (s.length * s.length), unit::kPressure);
  report.item("Power", s.force * s.length / s.time, unit::kPower);
}

void output_control(Report& report, const FrontMatter& front) {
  const deck::Deck& deck = front.deck;
  if (deck.integer("mode") >= 0) {
    report.heading("Output control");
    report.item("kPrtOpt, code for the sections of a printed step",
                static_cast<long>(deck.integer("kPrtOpt")));
    for (const auto& [name, what] :
         {std::pair{"kPrtFreq", "steps between printed steps"},
          std::pair{"kPltFreq", "steps between stored steps of SOL1-SOL7"},
          std::pair{"kAGraf", "steps between stored steps of SOL8"},
          std::pair{"kLifeFreq", "steps between life predictions"}}) {
      const long every = static_cast<long>(deck.integer(name));
      report.item(fmt::format("{}, {}{}", name, what, every == 0 ? " (0: first and last)" : ""),
                  every);
    }
    std::string elements;
    for (int k = 1; k <= deck.integer("kNumPltElem"); ++k)
      elements += fmt::format("{} ", deck.integer("kPltElemInd", k));
    report.item("kPltElemInd, bodies with a plot file",
                elements.empty() ? std::string("none") : elements.substr(0, elements.size() - 1));
  }
  if (front.options.empty()) return;
  report.heading("Named options");
  for (const auto& [name, value] : front.options) report.item(name, value);
}

}  // namespace

void print_front_matter(Report& report, const FrontMatter& front) {
  echo(report, front.deck);
  geometry(report, front.bearing, front.deck);
  print_imperfections(report, front.bearing);
  materials(report, front.bearing);
  traction(report, front.bearing);
  operation(report, front);
  if (front.scales) scales(report, *front.scales);
  output_control(report, front);
}

}  // namespace adore::listing
