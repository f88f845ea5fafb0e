#include "life/constants.hpp"

#include "base/resources.hpp"
#include "bearing/material_json.hpp"

#include <nlohmann/json.hpp>

namespace adore::life {
namespace {

using Json = nlohmann::json;

SourcedValue marked(const Json& entry) {
  return {entry.at("value").get<double>(), entry.at("provenance").get<std::string>()};
}

std::vector<std::pair<double, double>> pairs(const Json& rows) {
  std::vector<std::pair<double, double>> out;
  for (const Json& row : rows) out.emplace_back(row.at(0).get<double>(), row.at(1).get<double>());
  return out;
}

LifeConstants::LoadFactors load_factors(const Json& table) {
  LifeConstants::LoadFactors out;
  out.X = table.at("X").get<double>();
  for (const Json& row : table.at("rows"))
    out.rows.push_back({row.at(0).get<double>(), row.at(1).get<double>(), row.at(2).get<double>()});
  return out;
}

AisoFormula aiso(const Json& entry, double divisor) {
  AisoFormula out;
  for (const Json& band : entry.at("bands"))
    out.bands.push_back({band.at(0).get<double>(), band.at(1).get<double>(),
                         band.at(2).get<double>(), band.at(3).get<double>()});
  out.constant = entry.at("const").get<double>();
  out.inner = entry.at("inner_exp").get<double>();
  out.load = entry.at("load_exp").get<double>();
  out.outer = entry.at("outer_exp").get<double>();
  out.thrust_divisor = divisor;
  return out;
}

void read_fatigue(const Json& json, LifeConstants& c) {
  const Json& lp = json.at("lundberg_palmgren");
  c.point_constant = marked(lp.at("A_point_N_mm1.8"));
  c.line_constant = marked(lp.at("B_line_N_mm"));
  c.stress_exponent = marked(lp.at("c"));
  c.depth_exponent = marked(lp.at("h"));
  c.point_slope = marked(lp.at("e_point"));
  c.line_slope = marked(lp.at("e_line"));
  c.reduction_ball = marked(lp.at("reduction_ball_single_row")).value;
  c.reduction_ball_double = marked(lp.at("reduction_ball_double_row")).value;
  c.reduction_roller = marked(lp.at("reduction_roller_lambda_nu")).value;
  c.reduction_thrust_roller = marked(lp.at("reduction_thrust_roller")).value;
  c.zaretsky_exponent = marked(json.at("gz_life_stress_exponent_c"));
  const Json& calibration = json.at("calibration");
  c.elastic_modulus = calibration.at("elastic_modulus_Pa").get<double>();
  c.poisson_ratio = calibration.at("poisson_ratio").get<double>();
  c.harris_limit = calibration.at("ih_limit_Pa").get<double>();
  const auto contact = [&](const char* name) {
    const Json& entry = calibration.at(name);
    return CalibrationContact{entry.at("D").get<double>(), entry.value("f", 0.0),
                              entry.value("l", 0.0), entry.at("gamma").get<double>(),
                              entry.at("Z").get<int>()};
  };
  c.point = contact("point");
  c.line = contact("line");
  const Json& limit = json.at("ih_limit");
  c.iso_equivalent_limit = {limit.at("iso_281_equivalent_Pa").get<double>(),
                            limit.at("provenance").get<std::string>()};
}

void read_factors(const Json& json, LifeConstants& c) {
  const Json& stle = json.at("stle");
  c.stle_material = stle.at("material").at("value").get<std::map<std::string, double>>();
  c.stle_process = stle.at("process").at("value").get<std::map<std::string, double>>();
  c.film_table = pairs(stle.at("lambda_table").at("value"));
  c.stle_origin = stle.at("material").at("provenance").get<std::string>();
  const Json& form = json.at("tallian").at("asperity_form").at("value");
  c.asperity_slope = form.at("theta0_rad").get<double>();
  c.asperity_traction = form.at("mu0").get<double>();
  c.asperity_exponent = form.at("q").get<double>();
  c.asperity_life_factor = form.at("life_factor_at_lambda_1").get<double>();
  const Json& by_code = json.at("defaults_by_material_code");
  for (const auto& [code, row] : by_code.at("stle").items())
    c.stle_by_code[std::stoi(code)] = {row.at(0).get<double>(), row.at(1).get<double>()};
  for (const auto& [code, row] : by_code.at("tallian").items())
    c.tallian_by_code[std::stoi(code)] = {row.at(0).get<double>(), row.at(1).get<double>(),
                                          row.at(2).get<double>()};
}

void read_iso(const Json& json, LifeConstants& c) {
  const Json& iso = json.at("iso281");
  c.thrust_roller_constant = marked(iso.at("thrust_roller_90_N_mm")).value;
  c.rating_factor = iso.at("bm").at("value").get<std::map<std::string, double>>();
  const Json& conformity = iso.at("fc_conformity_used").at("value");
  c.table_conformity_radial = conformity.at("radial ball").get<double>();
  c.table_conformity_thrust = conformity.at("thrust ball").get<double>();
  c.static_factor = pairs(iso.at("f0").at("value"));
  c.deep_groove = load_factors(iso.at("xye_deep_groove").at("value"));
  c.spindle = load_factors(iso.at("xye_15_degrees").at("value"));
  for (const Json& row : iso.at("xye_angular_contact").at("value").at("rows"))
    c.angular.push_back({row.at(0).get<double>(), row.at(1).get<double>(), row.at(2).get<double>(),
                         row.at(3).get<double>()});
  const Json& divisor = iso.at("a_iso_thrust_divisor").at("value");
  const Json& forms = iso.at("a_iso").at("value");
  c.aiso_ball = aiso(forms.at("radial_ball"), divisor.at("ball").get<double>());
  c.aiso_roller = aiso(forms.at("radial_roller"), divisor.at("roller").get<double>());
  for (const auto& [code, row] : iso.at("e_C").at("value").items())
    c.contamination[code] = {row.at(0).get<double>(), row.at(1).get<double>()};
  const Json& ball = json.at("iso16281").at("ball").at("value");
  c.ball_inner = ball.at("inner").get<double>();
  c.ball_outer = ball.at("outer").get<double>();
  c.ball_bracket = ball.at("bracket").get<double>();
  const Json& roller = json.at("iso16281").at("roller").at("value");
  c.roller_inner = roller.at("inner").get<double>();
  c.roller_outer = roller.at("outer").get<double>();
  c.roller_bracket = roller.at("bracket").get<double>();
  c.roller_reduction = roller.at("lambda_nu").get<double>();
  c.roller_lamina_load = roller.at("P_sk").get<double>();
}

std::map<int, SourcedValue> load_limits() {
  std::map<int, SourcedValue> out;
  const Json& json = bearing::material_json();
  for (const auto& [key, entry] : json.at("materials").items()) {
    const Json& limit = entry.at("von_mises_fatigue_limit");
    if (limit.is_null() || limit.at("value").is_null()) continue;
    out[entry.at("code").get<int>()] = marked(limit);
  }
  return out;
}

}  // namespace

const LifeConstants& constants() {
  static const LifeConstants loaded = [] {
    const Json json = Json::parse(resources::get("life_constants.json"));
    LifeConstants c;
    read_fatigue(json, c);
    read_factors(json, c);
    read_iso(json, c);
    return c;
  }();
  return loaded;
}

std::optional<SourcedValue> fatigue_limit_of_code(int code) {
  static const std::map<int, SourcedValue> limits = load_limits();
  const auto found = limits.find(code);
  if (found == limits.end()) return std::nullopt;
  return found->second;
}

}  // namespace adore::life
