#include "listing/print_fits.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace adore::listing {
namespace {

using bearing::ClearanceState;
using bearing::FitState;
using bearing::Growth;
using bearing::OperatingFits;
using Json = nlohmann::ordered_json;

double known(double limit) { return limit > 0.0 ? limit : kNaN; }

void fits_table(Report& report, const OperatingFits& fits) {
  report.heading("Diametral fits (positive: interference; negative: clearance)");
  std::vector<Report::Row> rows, stresses;
  const std::array<const char*, 2> names{"outer race in housing", "inner race on shaft"};
  for (std::size_t j = 0; j < 2; ++j) {
    const FitState& fit = fits.fit[j];
    rows.push_back(
        {names[j], {fit.allowance, fit.mounted_pressure, fit.interference, fit.pressure}});
    stresses.push_back(
        {j == 0 ? "outer race" : "inner race", {fit.race_hoop, known(fit.race_limit)}});
    stresses.push_back({j == 0 ? "housing" : "shaft", {fit.mate_hoop, known(fit.mate_limit)}});
  }
  report.table("",
               {{"allowance", &unit::kLength},
                {"p mounted", &unit::kPressure},
                {"operating", &unit::kLength},
                {"p operating", &unit::kPressure}},
               rows, 24);
  report.heading("Largest hoop stress in operation from fit and rotation (positive: tension)");
  report.table("", {{"stress", &unit::kPressure}, {"elastic lim", &unit::kPressure}}, stresses, 12);
}

void growth_table(Report& report, const OperatingFits& fits, bool cage) {
  report.heading("Radial growth in operation by cause (positive: outward)");
  std::vector<Report::Row> rows;
  const auto row = [&](std::string name, const Growth& g) {
    rows.push_back({std::move(name), {g.thermal, g.centrifugal, g.pressure, g.total()}});
  };
  row("outer raceway", fits.raceway[0]);
  row("inner raceway", fits.raceway[1]);
  row("outer race at the fit, no fit pressure", fits.race_at_fit[0]);
  row("housing bore, no fit pressure", fits.mate_at_fit[0]);
  row("shaft outside, no fit pressure", fits.mate_at_fit[1]);
  row("inner race bore, no fit pressure", fits.race_at_fit[1]);
  if (cage) {
    row("cage outside", fits.cage[0]);
    row("cage bore", fits.cage[1]);
  }
  report.table("",
               {{"thermal", &unit::kLength},
                {"centrifug.", &unit::kLength},
                {"fit press.", &unit::kLength},
                {"total", &unit::kLength}},
               rows, 40);
  report.item("Growth of the rolling element diameter", fits.element_growth, unit::kLength);
  if (cage)
    report.item("Cage speed for the centrifugal cage growth (epicyclic)", fits.cage_speed,
                unit::kRotation);
}

void clearance_table(Report& report, const OperatingFits& fits) {
  const bool balls = fits.locus[0] > 0.0;
  std::vector<Report::Row> rows;
  if (!balls) {
    report.heading(
        "Diametral internal clearance (tapered bearings: change from the nominal position)");
    for (const auto& [name, state] :
         {std::pair{"unmounted, cold", &fits.free}, std::pair{"mounted, cold", &fits.mounted},
          std::pair{"in operation", &fits.operating}})
      rows.push_back({name, {state->clearance}});
    report.table("", {{"clearance", &unit::kLength}}, rows, 16);
  } else {
    report.heading(
        "Diametral internal clearance, free contact angle and distance A of the curvature centers");
    const auto row = [&](const char* name, const ClearanceState& s) {
      rows.push_back({name, {s.clearance, s.contact_angle, s.end_play, s.centre_distance}});
    };
    row("unmounted, cold", fits.free);
    row("mounted, cold", fits.mounted);
    row("in operation", fits.operating);
    report.table("",
                 {{"clearance", &unit::kLength},
                  {"angle", &unit::kAngle},
                  {"end play", &unit::kLength},
                  {"centers A", &unit::kLength}},
                 rows, 16);
  }
  report.blank();
  report.item("Pitch diameter, cold", fits.pitch_free, unit::kLength);
  report.item("Pitch diameter, in operation", fits.pitch, unit::kLength);
  if (fits.axial_setting)
    report.item("Change of the axial setting (positive: less clearance)", *fits.axial_setting,
                unit::kLength);
  if (!(fits.locus[0] > 0.0)) return;  // rollers
  for (std::size_t j = 0; j < 2; ++j) {
    const char* race = j == 0 ? "outer" : "inner";
    report.item(fmt::format("Distance of {} groove centers from bearing axis, cold", race),
                fits.locus_free[j], unit::kLength);
    report.item(fmt::format("Distance of {} groove centers from bearing axis, operating", race),
                fits.locus[j], unit::kLength);
  }
}

/// Properties that follow temperature, at the temperature of each part.
void warm_materials(Report& report, const bearing::Bearing& b) {
  report.heading("Material properties at the temperature of each part");
  std::vector<Report::Row> rows;
  const auto row = [&](const char* name, const bearing::Material& m, double T) {
    rows.push_back(
        {name, {T, m.elastic_modulus, m.thermal_expansion, m.conductivity, m.specific_heat}});
  };
  row("balls", b.element_material, b.element_temperature);
  row("outer race", b.race_material[0], b.race_temperature[0]);
  row("inner race", b.race_material[1], b.race_temperature[1]);
  if (b.cage) row("cage", b.cage->material, b.cage_temperature);
  row("housing", b.mounting.housing, b.mounting.housing_temperature);
  row("shaft", b.mounting.shaft, b.mounting.shaft_temperature);
  report.table("",
               {{"temperature", &unit::kTemperature},
                {"E", &unit::kPressure},
                {"expansion", &unit::kPerTemperature},
                {"conduct.", &unit::kConductivity},
                {"spec. heat", &unit::kSpecificHeat}},
               rows, 12);
  report.text(
      "Column \"expansion\": mean coefficient between 293.15 K and the temperature of the part.");
}

Json growth_json(const Growth& g) {
  return {{"thermal [m]", g.thermal},
          {"centrifugal [m]", g.centrifugal},
          {"fit pressure [m]", g.pressure},
          {"total [m]", g.total()}};
}

Json clearance_json(const ClearanceState& s) {
  return {{"diametral clearance [m]", s.clearance},
          {"free contact angle [rad]", s.contact_angle},
          {"free end play [m]", s.end_play},
          {"distance of curvature centres [m]", s.centre_distance}};
}

Json limit_json(double limit) { return limit > 0.0 ? Json(limit) : Json(nullptr); }

}  // namespace

void print_fits(Report& report, const bearing::Bearing& bearing) {
  demand(bearing.operating.has_value(), "the page of fits needs an operating geometry");
  const OperatingFits& fits = *bearing.operating;
  report.new_page("OPERATING FITS AND CLEARANCES");
  report.text(
      "The rings are in plane stress. Thermal growth, centrifugal growth and growth from fit "
      "pressure are added. \"Mounted\" means at room temperature and not rotating.");
  if (!fits.changed)
    report.text(
        "There is no thermal or centrifugal growth and no fit pressure. The geometry is that of "
        "the deck.");
  fits_table(report, fits);
  growth_table(report, fits, !fits.plays.empty());
  clearance_table(report, fits);
  if (!fits.plays.empty()) {
    report.heading("Cage clearance, diametral");
    std::vector<Report::Row> rows;
    for (const bearing::CageClearance& play : fits.plays)
      rows.push_back({play.name, {play.free, play.operating}});
    report.table("", {{"cold", &unit::kLength}, {"operating", &unit::kLength}}, rows, 34);
  }
  if (bearing.mounting.material_laws) warm_materials(report, bearing);
  if (fits.warnings.empty()) return;
  report.heading("Warnings");
  for (const Finding& warning : fits.warnings) report.text(warning.message);
}

Json fits_json(const OperatingFits& fits) {
  Json out;
  out["geometry changed"] = fits.changed;
  for (std::size_t j = 0; j < 2; ++j) {
    const FitState& f = fits.fit[j];
    const std::string mate = j == 0 ? "housing" : "shaft";
    Json fit{{"allowance [m]", f.allowance},
             {"mounted pressure [Pa]", f.mounted_pressure},
             {"operating interference [m]", f.interference},
             {"operating pressure [Pa]", f.pressure},
             {"hoop stress of the race [Pa]", f.race_hoop},
             {"elastic limit of the race [Pa]", limit_json(f.race_limit)},
             {"hoop stress of the " + mate + " [Pa]", f.mate_hoop},
             {"elastic limit of the " + mate + " [Pa]", limit_json(f.mate_limit)},
             {"growth of the raceway", growth_json(fits.raceway[j])},
             {"circle of curvature centers, not mounted [m]", fits.locus_free[j]},
             {"radius of the curvature centres [m]", fits.locus[j]}};
    out[j == 0 ? "outer race" : "inner race"] = std::move(fit);
  }
  out["growth of the element diameter [m]"] = fits.element_growth;
  out["unmounted"] = clearance_json(fits.free);
  out["mounted"] = clearance_json(fits.mounted);
  out["operating"] = clearance_json(fits.operating);
  if (fits.axial_setting) out["change of the axial setting [m]"] = *fits.axial_setting;
  out["pitch diameter, free [m]"] = fits.pitch_free;
  out["pitch diameter [m]"] = fits.pitch;
  if (!fits.plays.empty()) {
    Json plays = Json::object();
    for (const bearing::CageClearance& play : fits.plays)
      plays[play.name] = {{"cold [m]", play.free}, {"operating [m]", play.operating}};
    out["cage play, diametral"] = std::move(plays);
    out["growth of the cage outside"] = growth_json(fits.cage[0]);
    out["growth of the cage bore"] = growth_json(fits.cage[1]);
  }
  out["warnings"] = sentences_of(fits.warnings);
  return out;
}

}  // namespace adore::listing
