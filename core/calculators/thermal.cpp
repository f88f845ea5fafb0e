#include "calculators/thermal.hpp"

#include "base/errors.hpp"
#include "bearing/material_laws.hpp"
#include "calculators/json_access.hpp"
#include "contact/groove.hpp"
#include "deck/units.hpp"
#include "thermal/assembly.hpp"
#include "tribology/fluid.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace adore::calculators {
namespace {

using namespace thermal;

Elastic elastic(const Json& m) { return {get(m, "E"), get(m, "nu"), m.value("rho", 0.0)}; }

// ---- thermal_lame

std::optional<Json> lame_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (kind(the_case) != "lame_fit") return std::nullopt;
  const double a = 0.5 * get(in, "inner_id"), c = 0.5 * get(in, "interface_dia"),
               b = 0.5 * get(in, "outer_od");
  if (!(a >= 0.0 && a < c && c < b))
    throw InputError(
        "the diameters of a fit must satisfy inner_id < interface_dia < outer_od. Enter inner_id = "
        "0 for a solid part");
  const Elastic inner = elastic(in.at("inner_part")), outer = elastic(in.at("outer_part"));
  const double p = fit_pressure(a, c, b, inner, outer, get(in, "diametral_interference"));
  return Json{{"pressure", p},
              {"outer_part_bore_change", 2.0 * pressure_displacement(c, c, b, outer, p, 0.0)},
              {"outer_part_od_change", 2.0 * pressure_displacement(b, c, b, outer, p, 0.0)},
              {"inner_part_od_change", 2.0 * pressure_displacement(c, a, c, inner, 0.0, p)},
              {"inner_part_id_change", 2.0 * pressure_displacement(a, a, c, inner, 0.0, p)},
              {"hoop_stress_outer_bore", pressure_hoop_stress(c, c, b, p, 0.0)},
              {"hoop_stress_inner_bore", pressure_hoop_stress(a, a, c, 0.0, p)}};
}

// ---- thermal_growth

Json spin_case(const Json& in) {
  const double a = 0.5 * get(in, "inner_dia"), b = 0.5 * get(in, "outer_dia");
  const Elastic m = elastic(in.at("material"));
  const double w = get(in, "rpm") * kRpm;
  Json out{{"od_growth", 2.0 * centrifugal_displacement(b, a, b, m, w)}};
  if (a > 0.0) {
    out["bore_growth"] = 2.0 * centrifugal_displacement(a, a, b, m, w);
    out["hoop_stress_inner"] = centrifugal_hoop_stress(a, a, b, m, w);
    out["radial_stress_mid"] = centrifugal_radial_stress(std::sqrt(a * b), a, b, m, w);
  } else {
    out["hoop_stress_mid"] = centrifugal_hoop_stress(0.5 * b, a, b, m, w);
  }
  return out;
}

/// Strain from 293.15 K with a constant coefficient or a law {form, T_ref, c, T_min, T_max}.
double strain(const Json& cte, double T) {
  const double dT = T - bearing::kStrainReference;
  if (cte.is_number()) return cte.get<double>() * dT;
  bearing::PropertyLaw law;
  law.c = cte.at("c").get<std::vector<double>>();
  law.T_ref = get(cte, "T_ref");
  law.T_min = get(cte, "T_min");
  law.T_max = get(cte, "T_max");
  return law(T) * dT;
}

std::optional<Json> growth_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  std::string what = kind(the_case);
  if (what.empty()) what = in.contains("rpm") ? "spin_growth" : "ring_thermal_growth";
  if (what == "spin_growth") return spin_case(in);
  if (what != "ring_thermal_growth") return std::nullopt;
  const Json& cte = in.at("cte");
  if (cte.is_object() && cte.at("form") != "quadratic" && cte.at("form") != "linear")
    return std::nullopt;
  const double a = 0.5 * get(in, "inner_dia"), b = 0.5 * get(in, "outer_dia");
  const double mean = mean_ring_temperature(a, b, get(in, "temp_inner"), get(in, "temp_outer"));
  const double g = strain(cte, mean) - strain(cte, get(in, "room_temp"));
  return Json{{"mean_temp", mean}, {"bore_growth", 2.0 * a * g}, {"od_growth", 2.0 * b * g}};
}

// ---- thermal_clearance

RingPart ring(const Json& in, const char* name, double inner, double outer, double speed) {
  const Json& material = in.at("materials").at(name);
  const double g = get(material, "cte") * (get(in.at("temps"), name) - get(in, "room_temp"));
  return {elastic(material), inner, outer, g, speed};
}

/// Raceways and free clearance of the case: a ball bearing by its grooves, a roller bearing by its
/// clearance.
struct FreeGeometry {
  bool ball = true;
  double clearance = 0.0, contact_angle = 0.0;
  std::array<double, 2> groove{}, raceway{};
};

std::optional<FreeGeometry> free_geometry(const Json& in) {
  const std::string type = in.at("type").get<std::string>();
  FreeGeometry out;
  const double D = get(in, "re_dia"), dm = get(in, "pitch");
  if (type == "ball") {
    bearing::BallGeometry balls;
    balls.diameter = D;
    balls.pitch_diameter = dm;
    balls.groove_factor = {get(in, "f1"), get(in, "f2")};
    const contact::FreeAngleAndClearance free = contact::free_angle_and_clearance(
        D, balls.groove_factor, {}, get(in, "free_contact_angle") * kDegree,
        in.value("free_clearance", 0.0));
    balls.contact_angle = out.contact_angle = free.contact_angle;
    balls.clearance = out.clearance = free.clearance;
    const contact::GrooveGeometry groove = contact::groove_geometry(balls);
    out.groove = groove.groove_radius;
    out.raceway = {groove.centre_radius[0] + groove.groove_radius[0],
                   groove.centre_radius[1] - groove.groove_radius[1]};
    return out;
  }
  if (type != "cylindrical_roller" && type != "spherical_roller") return std::nullopt;
  out.ball = false;
  out.clearance = get(in, "free_clearance");
  out.raceway = {0.5 * (dm + D) + 0.25 * out.clearance, 0.5 * (dm - D) - 0.25 * out.clearance};
  return out;
}

std::optional<Json> assembly_case(const Json& in) {
  const auto free = free_geometry(in);
  if (!free) return std::nullopt;
  const double ro = 0.5 * get(in, "od"), rb = 0.5 * get(in, "bore"), D = get(in, "re_dia");
  const double w1 = get(in, "rpm1") * kRpm, w2 = get(in, "rpm2") * kRpm;
  MountedRings rings;
  rings.shaft = ring(in, "shaft", 0.5 * get(in, "shaft_id"), rb, w2);
  rings.inner = ring(in, "inner", rb, free->raceway[1], w2);
  rings.outer = ring(in, "outer", free->raceway[0], ro, w1);
  rings.housing = ring(in, "housing", ro, 0.5 * get(in, "housing_od"), w1);
  rings.fit = {get(in, "fit1"), get(in, "fit2")};
  const MountedState state = mount(rings), mounted = mount(at_rest(rings));
  const auto raceways = [&](const MountedState& s) {
    return std::array{s.race_displacement(0, free->raceway[0]),
                      s.race_displacement(1, free->raceway[1])};
  };
  const double dD = D * get(in.at("materials").at("re"), "cte") *
                    (get(in.at("temps"), "re") - get(in, "room_temp"));
  const std::array<double, 2> u = raceways(state);
  const double cold = operating_clearance(free->clearance, raceways(mounted), 0.0);
  const double warm = operating_clearance(free->clearance, u, dD);
  Json out{{"pressure_outer_fit", state.pressure[0]},
           {"pressure_inner_fit", state.pressure[1]},
           {"operating_fit_outer", state.interference[0]},
           {"operating_fit_inner", state.interference[1]},
           {"mounted_pressure_outer", mounted.pressure[0]},
           {"mounted_pressure_inner", mounted.pressure[1]},
           {"hoop_stress_outer_race", state.race_hoop_stress(0)},
           {"hoop_stress_inner_race", state.race_hoop_stress(1)},
           {"hoop_stress_housing", state.mating_part_hoop_stress(0)},
           {"hoop_stress_shaft", state.mating_part_hoop_stress(1)},
           {"free_diametral_clearance", free->clearance},
           {"mounted_clearance_room", cold},
           {"operating_diametral_clearance", warm},
           {"outer_raceway_radial_growth", u[0]},
           {"inner_raceway_radial_growth", u[1]},
           {"re_diameter_growth", dD}};
  if (free->ball) {
    const double A = free->groove[0] + free->groove[1] - D;
    const double A_op = free->groove[0] * (1.0 + rings.outer.growth) +
                        free->groove[1] * (1.0 + rings.inner.growth) - (D + dD);
    const double angle = contact_angle(warm, A_op);
    out["free_contact_angle_deg"] = free->contact_angle / kDegree;
    out["mounted_contact_angle_deg"] = contact_angle(cold, A) / kDegree;
    out["operating_free_contact_angle_deg"] = angle / kDegree;
    out["center_distance_A"] = A_op;
    out["operating_free_endplay"] = end_play(A_op, angle);
  }
  if (!in.contains("lands")) return out;
  const double ci = 0.5 * get(in, "cage_id"), co = 0.5 * get(in, "cage_od");
  const RingPart cage = ring(in, "cage", ci, co, get(in, "rpm_cage") * kRpm);
  int number = 0;
  for (const Json& land : in.at("lands")) {
    const int race = whole(land, "race", 1, 2) - 1;
    const double r = 0.5 * get(land, "land_dia"), on_cage = race == 0 ? co : ci;
    out[fmt::format("land_clearance_{}", ++number)] = land_clearance(
        race, r, state.race_displacement(race, r), on_cage, cage_displacement(cage, on_cage, true));
  }
  return out;
}

std::optional<Json> clearance_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  std::string what = kind(the_case);
  if (what.empty()) what = in.contains("shim") ? "split_race" : "assembly";
  if (what == "assembly") return assembly_case(in);
  if (what != "split_race") return std::nullopt;
  const SplitRace split =
      split_race(get(in, "curvature_radius"), get(in, "ball_dia"), get(in, "shim"),
                 get(in, "measured_clearance"), get(in, "center_distance_A"));
  return Json{{"shim_angle_deg", split.shim_angle / kDegree},
              {"unarched_clearance", split.clearance},
              {"contact_angle_deg", split.contact_angle / kDegree},
              {"free_endplay", split.end_play}};
}

// ---- thermal_units

/// SI per English unit of each quantity, from the unit pairs of the deck.
const std::map<std::string, double>& unit_factors() {
  using namespace deck::unit;
  static const std::map<std::string, double> table = {
      {"acceleration", kAcceleration.en_factor},
      {"area", kInch * kInch},
      {"density", kDensity.en_factor},
      {"energy", kMoment.en_factor},
      {"force", kForce.en_factor},
      {"heat_flux", kPoundForce / kInch},
      {"heat_transfer_coefficient", kConvection.en_factor},
      {"inertia", kInertia.en_factor},
      {"kinematic_viscosity", kInch * kInch},
      {"length", kLength.en_factor},
      {"mass", kMass.en_factor},
      {"mass_flow", kMass.en_factor},
      {"moment", kMoment.en_factor},
      {"power", kMoment.en_factor},
      {"pressure", kStress.en_factor},
      {"pressure_viscosity_coefficient", kPerStress.en_factor},
      {"rotational_stiffness", kMoment.en_factor},
      {"specific_heat", kSpecificHeat.en_factor},
      {"stiffness", kPoundForce / kInch},
      {"temperature", kTemperature.en_factor},
      {"temperature_difference", kTemperature.en_factor},
      {"temperature_viscosity_beta_T", kTemperature.en_factor},
      {"temperature_viscosity_beta_per_T", kPerTemperature.en_factor},
      {"thermal_conductivity", kConductivity.en_factor},
      {"thermal_expansion", kPerTemperature.en_factor},
      {"time", kTime.en_factor},
      {"traction_slope", kPerSpeed.en_factor},
      {"velocity", kSpeed.en_factor},
      {"viscosity", kViscosity.en_factor},
      {"volume", kVolumeFlow.en_factor},
      {"volume_flow", kVolumeFlow.en_factor},
      {"wear_rate", kVolumeFlow.en_factor}};
  return table;
}

std::optional<Json> units_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (kind(the_case) == "unit_constant" || in.contains("name")) {
    if (in.at("name") != "gc") return std::nullopt;
    constexpr double kGravity = 9.80665;  // exact, by definition of the pound-force
    return Json{{"value", kGravity / deck::unit::kInch}, {"unit", "lbm.in/(lbf.s^2)"}};
  }
  const double factor = unit_factors().at(in.at("quantity").get<std::string>());
  const bool to_si = in.value("direction", "to_si") == "to_si";
  Json values = Json::array();
  for (const Json& value : in.at("values"))
    values.push_back(to_si ? value.get<double>() * factor : value.get<double>() / factor);
  return Json{{"factor", factor}, {"values", values}};
}

// ---- thermal_props

Json fluid_case(const Json& in) {
  const tribology::FluidProperties fluid =
      tribology::fluid_properties(whole(in, "code", 0, 1'000'000), get(in, "T"));
  return {{"name", fluid.name},
          {"provenance", fluid.provenance},
          {"density", fluid.density},
          {"viscosity", fluid.viscosity},
          {"specific_heat", fluid.specific_heat},
          {"conductivity", fluid.conductivity},
          {"range_K", {fluid.T_min, fluid.T_max}},
          {"clamped_to_range", fluid.clamped}};
}

/// Table key of {"code": 100, "100", "mild_steel" or 0 with "part"}.
std::string material_key(const Json& in) {
  const Json& code = in.at("code");
  if (code.is_string() && code != "0") return code.get<std::string>();
  static const std::map<std::string, bearing::Part> parts = {
      {"rolling_element", bearing::Part::RollingElement},
      {"outer_race", bearing::Part::OuterRace},
      {"inner_race", bearing::Part::InnerRace},
      {"housing", bearing::Part::Housing},
      {"shaft", bearing::Part::Shaft},
      {"cage", bearing::Part::Cage}};
  const std::string part = in.value("part", "rolling_element");
  const int number = code.is_string() ? 0 : whole(in, "code", -1'000'000, 1'000'000);
  return bearing::material_from_table(number, parts.at(part)).table_key;
}

/// One material as the table has it, with unit and provenance of each property; at a temperature
/// too when asked.
Json material_case(const Json& in) {
  const bearing::MaterialSheet& sheet = bearing::material_sheet(material_key(in));
  const bool warm = in.contains("T");
  const double T = warm ? get(in, "T") : bearing::kStrainReference;
  const auto law_json = [](const bearing::PropertyLaw& law) {
    return Json{{"range_K", {law.T_min, law.T_max}},
                {"provenance", law.provenance},
                {"source", law.source}};
  };
  Json properties = Json::object();
  for (const bearing::PropertyEntry& p : sheet.properties) {
    if (!p.value) {
      properties[p.name] = nullptr;
      continue;
    }
    Json entry{
        {"value", *p.value}, {"unit", p.unit}, {"provenance", p.provenance}, {"source", p.source}};
    if (warm) entry["value_at_T"] = sheet.at(p.name, T);
    if (p.law) entry["law"] = law_json(*p.law);
    if (p.cryogenic) entry["law_below_293.15_K"] = law_json(*p.cryogenic);
    if (p.name == "cte" && sheet.cryogenic_strain)
      entry["strain_law_below_293.15_K"] = law_json(*sheet.cryogenic_strain);
    properties[p.name] = std::move(entry);
  }
  Json out{
      {"key", sheet.key}, {"name", sheet.name}, {"notes", sheet.notes}, {"properties", properties}};
  if (!warm) return out;
  out["T"] = T;
  for (const char* name : {"elastic_modulus", "cte", "thermal_conductivity", "specific_heat"})
    out[name] = sheet.at(name, T);
  bearing::Material material;
  material.table_key = sheet.key;
  out["clamped"] = Json::object();
  for (const bearing::ClampedLaw& law : bearing::clamped_laws(material, T))
    out["clamped"][law.property] = fmt::format(
        "T is outside the range of the property law, {} to {} K. The value at the nearer limit is "
        "used",
        law.T_min, law.T_max);
  out["thermal_strain_from_293K"] = sheet.at("cte", T) * (T - bearing::kStrainReference);
  return out;
}

std::optional<Json> property_case(const Json& the_case) {
  const std::string what = kind(the_case);
  const Json& in = the_case.at("inputs");
  if (what == "fluid_property") return fluid_case(in);
  if (what == "material_property") return material_case(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> thermal_adapters() {
  return {{"thermal_lame", lame_case},
          {"thermal_growth", growth_case},
          {"thermal_clearance", clearance_case},
          {"thermal_units", units_case},
          {"thermal_props", property_case}};
}

}  // namespace adore::calculators
