#include "life/statistics.hpp"
#include "listing/print_life.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

/// Fatigue life in RUN.json: names carry their units; infinite lives are the text "infinite".
namespace adore::listing {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kParts{"outer race", "inner race", "rolling elements"};
constexpr std::array<const char*, 3> kForms{"basic", "STLE", "Tallian-type"};

Json number(double value) {
  if (std::isnan(value)) return nullptr;
  return std::isinf(value) ? Json("infinite") : Json(value);
}
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }
Json marked(const life::SourcedValue& m) { return {{"value", m.value}, {"origin", m.origin}}; }

Json lives(const life::LifeState& state) {
  Json out = Json::object();
  for (std::size_t m = 0; m < life::kModels; ++m)
    for (std::size_t f = 0; f < life::kModifications; ++f) {
      const life::PartLives& at = state.model[m].modified[f];
      Json entry = Json::object();
      for (std::size_t i = 0; i < 3; ++i)
        entry[std::string(kParts[i]) + " [Mrev]"] = number(at.part[i]);
      entry["origin"] = life_constants_origin(static_cast<bearing::LifeModel>(m),
                                              static_cast<bearing::LifeModification>(f));
      entry["elements counted"] = at.elements_counted;
      entry["L10 [Mrev]"] = number(at.L10);
      entry["L10 [hr]"] = number(life::life_hours(at.L10, state.relative_speed));
      entry["at the survival probability [hr]"] =
          number(life::life_hours(at.L_S, state.relative_speed));
      out[life_model_name(static_cast<bearing::LifeModel>(m), bearing::LifeModification::None)]
         [kForms[f]] = entry;
    }
  return out;
}

Json part(const life::BearingLife& life, std::size_t i) {
  const life::PartParameters& p = life.parameters.part[i];
  const life::ModificationFactors& f = life.state.factors;
  Json out{{"material", p.material},
           {"Weibull slope", marked(p.slope)},
           {"elastic modulus [Pa]", p.elastic_modulus},
           {"fatigue limit [Pa]", marked(p.fatigue_limit)}};
  if (p.temperature > 0.0) out["temperature [K]"] = p.temperature;
  if (i < 2) {
    out["original multiplier"] = marked(p.original_factor);
    out["residual stress [Pa]"] = p.residual_stress;
    out["asperity slope [rad]"] = marked(p.asperity_slope);
    out["asperity traction"] = marked(p.asperity_traction);
  }
  constexpr std::array<const char*, 3> kModels{"updated", "Zaretsky", "Harris"};
  for (std::size_t m = 0; m < 3; ++m)
    out[kModels[m]] = {{"multiplier", marked(p.model[m].factor)},
                       {"stress exponent", marked(p.model[m].stress_exponent)},
                       {"depth exponent", marked(p.model[m].depth_exponent)},
                       {"pressure exponent", life.pressure_exponent[m][i]}};
  out["STLE"] = {{"material", marked(p.stle_material)},
                 {"process", marked(p.stle_process)},
                 {"hardness", marked(p.stle_hardness)},
                 {"film", f.film[i]},
                 {"filter", f.filter},
                 {"residual", f.residual[i]},
                 {"life factor", f.stle[i]}};
  out["Tallian-type"] = {{"material", marked(p.tallian_material)},
                         {"process", marked(p.tallian_process)},
                         {"contamination", marked(p.tallian_contamination)},
                         {"asperity", f.asperity[i]},
                         {"hazard", f.hazard[i]},
                         {"life factor", f.tallian[i]}};
  return out;
}

const char* shape_name(life::ContactShape shape) {
  switch (shape) {
    case life::ContactShape::Point:
      return "point";
    case life::ContactShape::Line:
      return "line";
    case life::ContactShape::Between:
      break;
  }
  return "between: the shorter life";
}

Json race(const life::BearingLife& life, std::size_t i) {
  const life::RaceReport& r = life.race[i];
  return {{"counts as", shape_name(life.state.shape[i])},
          {"ellipse, major axis [m]", number(r.major_axis)},
          {"rotating relative to the load", r.rotating},
          {"contact angle [rad]", r.angle},
          {"load capacity [N]", r.Q_c},
          {"equivalent load [N]", r.Q_e},
          {"largest load [N]", r.Q_max},
          {"largest pressure [Pa]", r.p_max},
          {"stress capacity, updated [Pa]", number(r.stress_capacity[0])},
          {"stress capacity, Zaretsky [Pa]", number(r.stress_capacity[1])},
          {"stress capacity, Harris [Pa]", number(r.stress_capacity[2])}};
}

Json iso(const life::IsoReport& r, double speed) {
  Json out{{"origin",
            "from public implementations of the standards; the factors bm, X, Y, e and f0 are "
            "not verified"},
           {"C [N]", r.C},
           {"C0 [N]", number(r.C0)},
           {"Cu [N]", number(r.C_u)},
           {"radial load [N]", r.radial},
           {"axial load [N]", r.axial}};
  Json maker = Json::object();
  for (const auto& [name, value] : {std::pair{"C [N]", r.maker.C}, std::pair{"C0 [N]", r.maker.C0},
                                    std::pair{"Cu [N]", r.maker.C_u}, std::pair{"e", r.maker.e},
                                    std::pair{"X", r.maker.X}, std::pair{"Y", r.maker.Y}})
    if (value) maker[name] = *value;
  if (!maker.empty()) {
    out["maker's ratings"] = maker;
    out["estimates"] = {{"C [N]", r.C_estimate},
                        {"C0 [N]", number(r.C0_estimate)},
                        {"Cu [N]", number(r.C_u_estimate)}};
  }
  if (r.viscosity)
    out["oil"] = {{"name", r.oil},
                  {"temperature [K]", r.oil_temperature},
                  {"viscosity [m^2/s]", *r.viscosity},
                  {"required viscosity [m^2/s]", number(r.required_viscosity)}};
  if (r.equivalent)
    out["equivalent load"] = {{"P [N]", r.equivalent->P},
                              {"X", r.equivalent->X},
                              {"Y", r.equivalent->Y},
                              {"e", r.equivalent->e}};
  out["L10 [Mrev]"] = number(r.L10);
  if (r.L10) out["L10 [hr]"] = number(life::life_hours(*r.L10, speed));
  out["a1"] = r.a1;
  out["kappa"] = number(r.kappa);
  if (r.kappa) out["kappa from"] = r.kappa_origin;
  out["eC"] = number(r.contamination);
  out["aISO"] = number(r.a_iso);
  out["Lnm [Mrev]"] = number(r.L_nm);
  if (r.reference) {
    out["Pref [N]"] = r.reference->P_ref;
    out["L10r [Mrev]"] = number(r.reference->L10r);
    out["L10r [hr]"] = number(life::life_hours(r.reference->L10r, speed));
  }
  out["Lnmr [Mrev]"] = number(r.L_nmr);
  return out;
}

}  // namespace

Json life_json(const life::BearingLife& life) {
  Json out;
  out["origin"] = {{"original", life::constants().point_constant.origin},
                   {"stress models", "calibrated"},
                   {"STLE", life::constants().stle_origin},
                   {"Tallian-type asperity term", "derived"}};
  out["survival probability"] = marked(life.parameters.survival);
  out["Weibull slope of the bearing"] = marked(life.parameters.bearing_slope);
  out["modulus follows temperature"] = life.parameters.modulus_follows_temperature;
  out["lives"] = lives(life.state);
  if (life.effective_length > 0.0) out["effective length [m]"] = life.effective_length;
  for (std::size_t i = 0; i < 2; ++i) out["races"][kParts[i]] = race(life, i);
  for (std::size_t i = 0; i < 3; ++i) out["parameters"][kParts[i]] = part(life, i);
  if (life.iso) out["ISO"] = iso(*life.iso, life.state.relative_speed);
  out["notes"] = sentences_of(life.notes);
  if (life.iso)
    for (const Finding& note : life.iso->notes) out["notes"].push_back(note.message);
  return out;
}

Json run_life_json(const RunLife& run) {
  Json out{{"model", life_model_name(run.model, run.modification)},
           {"origin", life_constants_origin(run.model, run.modification)},
           {"skipped [rev]", run.skipped_turns},
           {"window [s]", run.damage.seconds()},
           {"window [rev]", run.damage.revolutions()},
           {"samples (integration steps)", run.steps},
           {"evaluations of the full model", run.evaluations},
           {"mean change between evaluations", run.change},
           {"batches", run.batches},
           {"revolutions per batch", run.revolutions_per_batch},
           {"relative standard error", number(run.relative_error)}};
  for (std::size_t i = 0; i < 3; ++i)
    out[std::string("damage, ") + kParts[i]] = run.damage.damage()[i];
  const bool empty = !(run.damage.seconds() > 0.0);
  out["life [Mrev]"] = empty ? Json(nullptr) : number(run.damage.life_mega_revolutions(run.slopes));
  out["life [hr]"] = empty ? Json(nullptr) : number(run.damage.life_hours(run.slopes));
  return out;
}

}  // namespace adore::listing
