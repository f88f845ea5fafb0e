#include "base/constants.hpp"
#include "design/calculator_inputs.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <numbers>

/// Inputs of the calculators of a whole bearing.
namespace adore::design {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kRpm = std::numbers::pi / 30.0;

/// Contact angle as made [rad]: of rollers the mean of both races.
double made_angle(const bearing::Bearing& made) {
  if (const bearing::RollerGeometry* rollers = made.rollers())
    return 0.5 * (rollers->race_angle[0] + rollers->race_angle[1]);
  return made.balls().contact_angle;
}

Json kinematics(const runs::Prepared& p) {
  const bearing::Bearing& made = p.as_built;
  return {{"Z", made.element_count()},
          {"D", made.element_diameter()},
          {"dm", made.pitch_diameter()},
          {"contact_angle_deg", made_angle(made) / kDegree},
          {"inner_speed_rpm", made.speed[1] / kRpm},
          {"outer_speed_rpm", made.speed[0] / kRpm}};
}

const life::IsoReport& iso_of(const runs::Prepared& p, std::string_view calculator) {
  if (!p.life.iso)
    throw InputError(fmt::format(
        "calculator {} needs the ISO rating of the bearing, which is not available for this deck",
        calculator));
  return *p.life.iso;
}

bool is_thrust(const life::IsoGeometry& g) {
  return g.type == life::IsoType::ThrustBall || g.type == life::IsoType::ThrustRoller;
}

Json iso281(const runs::Prepared& p) {
  const life::IsoReport& r = iso_of(p, "iso281");
  const life::IsoGeometry& g = r.geometry;
  const bool ball = g.type == life::IsoType::RadialBall || g.type == life::IsoType::ThrustBall;
  Json in{
      {"bearing", std::string(is_thrust(g) ? "thrust_" : "radial_") + (ball ? "ball" : "roller")},
      {ball ? "Dw" : "Dwe", g.element_diameter},
      {"Dpw", g.pitch_diameter},
      {"Z", g.count},
      {"alpha_deg", g.contact_angle / kDegree},
      {"bm", g.rating_factor}};
  if (ball) {
    in["f_inner"] = g.conformity_inner;
    in["f_outer"] = g.conformity_outer;
  } else {
    in["Lwe"] = g.length;
  }
  if (r.equivalent && r.equivalent->P > 0.0) in["P"] = r.equivalent->P;
  return in;
}

Json iso16281(const runs::Prepared& p) {
  const life::IsoReport& r = iso_of(p, "iso16281");
  if (p.rollers)
    throw InputError(
        "calculator iso16281 accepts only decks with balls, because it uses the same distribution "
        "of lamina loads for all rollers");
  Json outer = Json::array(), inner = Json::array();
  for (const statics::StaticBall& ball : p.statics.balls) {
    outer.push_back(ball.Q[0]);
    inner.push_back(ball.Q[1]);
  }
  const life::IsoGeometry& g = r.geometry;
  return {{"C", r.C},
          {"Z", g.count},
          {"gamma", life::iso_gamma(g)},
          {"alpha_deg", g.contact_angle / kDegree},
          {"f_inner", g.conformity_inner},
          {"f_outer", g.conformity_outer},
          {"Qi", inner},
          {"Qe", outer}};
}

Json static_safety(const runs::Prepared& p) {
  const life::IsoReport& r = iso_of(p, "static-safety");
  if (!r.C0)
    throw InputError(
        "calculator static-safety: the static rating of this bearing is not computed. Enter C0 in "
        "record X1 of ADORE.json.");
  const life::IsoGeometry& g = r.geometry;
  const double degrees = g.contact_angle / kDegree;
  std::string type = "thrust";
  if (!is_thrust(g)) {
    if (p.rollers)
      type = degrees > 0.0 ? "tapered_roller" : "cylindrical_roller";
    else
      type = degrees > 0.0 ? "angular_contact" : "deep_groove";
  }
  Json in{{"type", type}, {"Fr", r.radial}, {"Fa", r.axial}, {"C0", *r.C0}};
  if (type != "deep_groove" && type != "cylindrical_roller") in["alpha_deg"] = degrees;
  return in;
}

Json minimum_load(const runs::Prepared& p) {
  const life::IsoReport& r = iso_of(p, "minimum-load");
  return {{"rule", p.rollers ? "roller_share" : "ball_share"},
          {"C", r.C},
          {"F", r.equivalent ? r.equivalent->P : std::hypot(r.radial, r.axial)}};
}

/// As a pair of races: each has its own groove factor.
Json load_capacity(const runs::Prepared& p) {
  const bearing::Bearing& made = p.as_built;
  Json out = Json::object();
  for (const std::size_t j : {0UL, 1UL}) {
    Json in{{"D", 1e3 * made.element_diameter()},
            {"dm", 1e3 * made.pitch_diameter()},
            {"Z", made.element_count()},
            {"alpha_deg", made_angle(made) / kDegree}};
    if (const bearing::RollerGeometry* rollers = made.rollers())
      in["l"] = 1e3 * rollers->contact_length();
    else
      in["f"] = made.balls().groove_factor[j];
    out[j == 0 ? "outer race" : "inner race"] = std::move(in);
  }
  return out;
}

Json roller_inertia(const runs::Prepared& p) {
  const bearing::RollerGeometry* rollers = p.as_built.rollers();
  if (rollers == nullptr)
    throw InputError(
        "the calculator \"roller-inertia\" needs the deck of a roller bearing; this deck has "
        "balls");
  return {{"roller", {{"dia", rollers->diameter}, {"length", rollers->length}}},
          {"density", p.as_built.element_material.density}};
}

Json part_material(const bearing::Material& m) {
  return {{"E", m.elastic_modulus},
          {"nu", m.poisson_ratio},
          {"rho", m.density},
          {"cte", m.thermal_expansion}};
}

Json clearance(const runs::Prepared& p) {
  const bearing::Bearing& made = p.as_built;
  if (made.mounting.material_laws)
    throw InputError(
        "calculator \"clearance\" uses constant expansion coefficients. Set kMatPropMod to 0, or "
        "read the clearance from the results of the deck.");
  const bool rollers = made.rollers() != nullptr;
  if (rollers && made.type != bearing::Type::Cylindrical && made.type != bearing::Type::Spherical)
    throw InputError(
        "calculator \"clearance\" accepts only decks with balls, cylindrical rollers or spherical "
        "rollers");
  Json in{{"type", !rollers                                  ? "ball"
                   : made.type == bearing::Type::Cylindrical ? "cylindrical_roller"
                                                             : "spherical_roller"},
          {"bore", made.envelope.bore},
          {"od", made.envelope.outer_diameter},
          {"shaft_id", made.envelope.shaft_bore},
          {"housing_od", made.envelope.housing_diameter},
          {"re_dia", made.element_diameter()},
          {"pitch", made.pitch_diameter()},
          {"fit1", made.mounting.fit[0]},
          {"fit2", made.mounting.fit[1]},
          {"room_temp", made.room_temperature},
          {"rpm1", made.speed[0] / kRpm},
          {"rpm2", made.speed[1] / kRpm}};
  if (rollers) {
    in["free_clearance"] = made.rollers()->clearance;
  } else {
    const bearing::BallGeometry& balls = made.balls();
    in["f1"] = balls.groove_factor[0];
    in["f2"] = balls.groove_factor[1];
    in["free_contact_angle"] = balls.contact_angle / kDegree;
    if (balls.contact_angle == 0.0) in["free_clearance"] = balls.clearance;
  }
  in["temps"] = {{"housing", made.mounting.housing_temperature},
                 {"shaft", made.mounting.shaft_temperature},
                 {"outer", made.race_temperature[0]},
                 {"inner", made.race_temperature[1]},
                 {"re", made.element_temperature}};
  in["materials"] = {{"housing", part_material(made.mounting.housing)},
                     {"shaft", part_material(made.mounting.shaft)},
                     {"outer", part_material(made.race_material[0])},
                     {"inner", part_material(made.race_material[1])},
                     {"re", {{"cte", made.element_material.thermal_expansion}}}};
  return in;
}

struct Entry {
  std::string_view name;
  Json (*inputs)(const runs::Prepared&);
  bool by_race = false;
};
constexpr std::array<Entry, 8> kEntries = {{{"clearance", clearance},
                                            {"iso16281", iso16281},
                                            {"iso281", iso281},
                                            {"kinematics", kinematics},
                                            {"load-capacity", load_capacity, true},
                                            {"minimum-load", minimum_load},
                                            {"roller-inertia", roller_inertia},
                                            {"static-safety", static_safety}}};

}  // namespace

const std::vector<std::string_view>& deck_calculators() {
  static const std::vector<std::string_view> kNames = {
      "clearance",    "film",           "hertz",        "iso16281",
      "iso281",       "kinematics",     "line-contact", "load-capacity",
      "minimum-load", "roller-inertia", "static-safety"};
  return kNames;
}

Json bearing_calculator_inputs(const runs::Prepared& prepared, std::string_view calculator) {
  for (const Entry& entry : kEntries)
    if (entry.name == calculator)
      return entry.by_race ? entry.inputs(prepared) : Json{{"bearing", entry.inputs(prepared)}};
  return nullptr;
}

}  // namespace adore::design
