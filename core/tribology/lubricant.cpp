#include "tribology/lubricant.hpp"

#include "base/errors.hpp"
#include "base/resources.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace adore::tribology {
namespace {

using Json = nlohmann::json;

constexpr double kSofteningReference = 313.15, kBetaReference = 313.0;
/// ln(μ/μ0) of Barus' law in visco-elastic films goes no further: e^27.6 is 1e12.
constexpr double kLogBarusCap = 27.6;
/// Least Λ: the eighth power of laws/limited.hpp leaves the range of floats below 2e-4. Oils have
/// 0.03 and more. Only a user's lubricant with a large softening gets there.
constexpr double kLeastLimit = 1e-3;

double number(const Json& block, const char* key) {
  return block.at(key).at("value").get<double>();
}

LubricantProperty constant(double value) { return {{}, {}, value, 0.0, 0.0, 1.0, true}; }

LubricantProperty property(const Json& entry, const char* key) {
  if (entry.contains("thermalTable")) {
    const Json& table = entry.at("thermalTable").at("value");
    if (table.contains(key)) {
      LubricantProperty out;
      out.T = table.at("T").get<std::vector<double>>();
      out.value = table.at(key).get<std::vector<double>>();
      return out;
    }
  }
  if (key == std::string_view("conductivity") && entry.contains("conductivityLaw")) {
    const Json& law = entry.at("conductivityLaw");
    const Json& c = law.at("constants").at("value");
    return {{},
            {},
            c.at("k0").get<double>(),
            c.at("k1").get<double>(),
            c.at("Tr").get<double>(),
            c.value("m", 1.0),
            !c.contains("m")};
  }
  return constant(number(entry, key));
}

/// Every constant below `json` with its provenance.
void collect(const Json& json, const std::string& path, std::vector<LubricantSource>& out) {
  if (!json.is_object()) return;
  if (json.contains("value") && json.contains("provenance")) {
    if (json.at("value").is_number())
      out.push_back({path, json.at("value").get<double>(), json.value("unit", std::string()),
                     json.at("provenance").get<std::string>(),
                     json.value("source", std::string())});
    return;
  }
  for (const auto& [key, value] : json.items())
    if (key != "equivalentTypeII" && key != "measuredTo")
      collect(value, path.empty() ? key : path + "." + key, out);
}

LubricantModel model_of(const std::string& name) {
  static const std::map<std::string, LubricantModel> kModels = {
      {"newtonianThermal", LubricantModel::NewtonianThermal},
      {"newtonianThermalGeneral", LubricantModel::NewtonianGeneral},
      {"viscoelastic", LubricantModel::ViscoElastic},
      {"shearThinning", LubricantModel::ShearThinning}};
  const auto found = kModels.find(name);
  demand(found != kModels.end(), "lubricants.json contains an unknown lubricant model");
  return found->second;
}

Viscosity law_of(const Json& block, const Json& entry) {
  const std::string name = block.at("law").get<std::string>();
  return viscosity_law(name, [&](const char* key) {
    if (name == "typeII" && key == std::string_view("T0")) return number(block, "refTemp");
    if (block.contains(key)) return number(block, key);
    return number(entry.at("equationOfState"), key);
  });
}

Lubricant parse(const Json& entry) {
  Lubricant out;
  out.code = static_cast<int>(entry.at("kTrac").get<double>());
  out.name = entry.at("name").get<std::string>();
  out.model = model_of(entry.at("model").get<std::string>());
  out.density = property(entry, "density");
  out.specific_heat = property(entry, "specificHeat");
  out.conductivity = property(entry, "conductivity");
  const Json& base = entry.at("base");
  if (entry.contains("viscosity")) out.pressed = law_of(entry.at("viscosity"), entry);
  out.base = base.at("law") == "fromViscosityLaw" ? out.pressed : law_of(base, entry);
  const Json& traction = entry.at("traction");
  if (entry.contains("limitingStress")) {
    const Json& limit = entry.at("limitingStress");
    out.limit = {number(limit, "ratio"), number(limit, "softening"), number(limit, "refTemp"),
                 limit.at("ratio").at("provenance").get<std::string>()};
  }
  switch (out.model) {
    case LubricantModel::NewtonianThermal:
      out.traction_alpha = number(traction, "alphaT");
      out.traction_viscosity = number(traction, "refTracVis");
      out.traction_reference = number(traction, "refTracTemp");
      out.traction_decay = number(traction, "tracVisTempCoeff");
      out.film_beta = number(traction, "betaT");
      out.film_beta_exponent = number(traction, "betaTexp");
      break;
    case LubricantModel::NewtonianGeneral:
      break;
    case LubricantModel::ShearThinning:
      out.carreau_G = number(traction, "G");
      out.carreau_n = number(traction, "n");
      out.carreau_a = number(traction, "a");
      out.carreau_TR = number(traction, "TR");
      break;
    case LubricantModel::ViscoElastic:
      out.pressed = out.base;
      out.sinh_law = traction.at("kind") == "sinh";
      out.modulus = number(traction, "G0");
      out.modulus_p = number(traction, "Gp");
      out.stress = number(traction, "tau0");
      out.stress_p = number(traction, "tau0p");
      out.softening = number(traction, "bT");
      break;
  }
  collect(entry, "", out.sources);
  static constexpr std::array kWeaker{"seen", "recalled", "estimated"};
  std::size_t rank = 0;
  for (const LubricantSource& one : out.sources)
    for (std::size_t i = 0; i < kWeaker.size(); ++i)
      if (one.provenance == kWeaker[i]) rank = std::max(rank, i);
  out.provenance = kWeaker[rank];
  return out;
}

const std::map<int, Lubricant>& table() {
  static const std::map<int, Lubricant> kTable = [] {
    std::map<int, Lubricant> out;
    const Json json = Json::parse(resources::get("lubricants.json"));
    for (const Json& entry : json.at("lubricants")) {
      if (entry.at("base").is_null()) continue;  // the user's own, records 10.4
      Lubricant one = parse(entry);
      out.emplace(one.code, std::move(one));
    }
    return out;
  }();
  return kTable;
}

}  // namespace

double StressLimit::at(double temperature) const {
  return ratio * std::exp(-softening * (temperature - reference));
}

double LubricantProperty::at(double temperature) const {
  if (T.empty()) {
    if (k1 == 0.0) return k0;
    constexpr double kLeast = 233.0, kMost = 450.0;
    const double distance = std::clamp(temperature, kLeast, kMost) - Tr;
    return k0 + k1 * (signed_distance ? distance : std::pow(std::abs(distance), exponent));
  }
  const auto above = std::upper_bound(T.begin(), T.end(), temperature);
  if (above == T.begin()) return value.front();
  if (above == T.end()) return value.back();
  const auto i = static_cast<std::size_t>(above - T.begin());
  return value[i - 1] + (value[i] - value[i - 1]) * (temperature - T[i - 1]) / (T[i] - T[i - 1]);
}

double Lubricant::viscosity_under_pressure(double pressure, double T) const {
  if (model == LubricantModel::NewtonianThermal)
    return std::exp(liquid(std::log(traction_viscosity) +
                           traction_decay * (traction_reference - T) + traction_alpha * pressure));
  if (model == LubricantModel::ViscoElastic)
    return std::exp(liquid(base.log_at(0.0, T) + std::min(base_alpha(T) * pressure, kLogBarusCap)));
  return pressed.at(pressure, T);
}

double Lubricant::beta_under_pressure(double pressure, double T) const {
  if (model == LubricantModel::NewtonianThermal)
    return film_beta * std::pow(T / kBetaReference, film_beta_exponent);
  return pressed.temperature_coefficient(pressure, T);
}

double Lubricant::limiting_ratio(double T) const {
  if (model != LubricantModel::ViscoElastic)
    return limit.ratio > 0.0 ? std::max(limit.at(T), kLeastLimit) : 0.0;
  return sinh_law ? 0.0 : stress_p * std::exp(-softening * (T - kSofteningReference));
}

const Lubricant& lubricant(int code) {
  const auto found = table().find(code);
  if (found == table().end()) {
    std::string codes;
    for (const int valid : lubricant_codes())
      codes += fmt::format("{}{}", codes.empty() ? "" : ", ", valid);
    throw InputError(fmt::format(
        "lubricant {} (kTrac) is not in the table of lubricants. The codes in the table are {}",
        code, codes));
  }
  return found->second;
}

Lubricant user_lubricant(const bearing::UserLubricant& given) {
  Lubricant out;
  constexpr int kUserCode = 9;
  out.code = kUserCode;
  out.name = given.name;
  out.model = LubricantModel::NewtonianThermal;
  out.density = constant(given.density);
  out.specific_heat = constant(given.specific_heat);
  out.conductivity = constant(given.conductivity);
  out.base = {TypeTwoViscosity{given.viscosity, given.alpha, given.beta, given.T0}};
  out.traction_alpha = given.traction_alpha;
  out.traction_viscosity = given.traction_viscosity;
  out.traction_reference = given.T0;
  out.traction_decay = out.film_beta = given.traction_beta;
  out.limit = {given.limit_ratio.value_or(kUserLimit), given.limit_softening, kSofteningReference,
               given.limit_ratio ? "given" : "estimated"};
  out.provenance = "given";
  return out;
}

Lubricant lubricant_of(const bearing::Lubrication& lubrication) {
  Lubricant out =
      lubrication.user ? user_lubricant(*lubrication.user) : lubricant(lubrication.code);
  if (lubrication.recommended && !lubrication.user) {
    const int code = oil_of(lubrication.code).recommended;
    if (code != lubrication.code) {
      Lubricant traction = lubricant(code);  // with the inlet of the code of the deck
      traction.base = out.base;
      traction.code = out.code;
      traction.name = fmt::format("{}, traction law of kTrac {}", out.name, code);
      out = std::move(traction);
    }
  }
  if (!lubrication.stress_limit) out.limit = {};
  return out;
}

Oil oil_of(int code) {
  static const std::vector<Oil> kOils = [] {
    std::vector<Oil> out;
    const Json json = Json::parse(resources::get("lubricants.json"));
    for (const Json& entry : json.at("oils"))
      out.push_back({entry.at("name").get<std::string>(), entry.at("codes").get<std::vector<int>>(),
                     entry.at("recommended").get<int>(), entry.at("why").get<std::string>()});
    return out;
  }();
  for (const Oil& one : kOils)
    if (std::find(one.codes.begin(), one.codes.end(), code) != one.codes.end()) return one;
  return {lubricant(code).name, {code}, code, {}};
}

std::vector<int> lubricant_codes() {
  std::vector<int> out;
  for (const auto& [code, one] : table()) out.push_back(code);
  return out;
}

}  // namespace adore::tribology
