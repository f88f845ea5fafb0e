#include "bearing/material_laws.hpp"

#include "base/errors.hpp"
#include "bearing/material_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace adore::bearing {
namespace {

using Json = nlohmann::json;

double polynomial(const std::vector<double>& c, double x) {
  double sum = 0.0;
  for (auto i = c.rbegin(); i != c.rend(); ++i) sum = sum * x + *i;
  return sum;
}

PropertyLaw parse_law(const Json& json) {
  static const std::map<std::string, PropertyLaw::Form> forms = {
      {"quadratic", PropertyLaw::Form::Polynomial},
      {"linear", PropertyLaw::Form::Polynomial},
      {"poly_T", PropertyLaw::Form::Polynomial},
      {"log10_poly", PropertyLaw::Form::Log10Polynomial},
      {"nist_cu_rational", PropertyLaw::Form::CopperRational},
      {"thermal_strain_poly", PropertyLaw::Form::StrainPolynomial}};
  PropertyLaw law;
  const auto form = forms.find(json.at("form").get<std::string>());
  demand(form != forms.end(), "a material property in materials.json has an unknown \"form\"");
  law.form = form->second;
  law.c = json.at("c").get<std::vector<double>>();
  demand(law.form != PropertyLaw::Form::CopperRational || law.c.size() == 9,
         "the conductivity law of copper must have nine coefficients");
  law.T_ref = json.value("T_ref", 0.0);
  law.T_min = json.at("T_min").get<double>();
  law.T_max = json.at("T_max").get<double>();
  law.T_low = json.value("T_low", 0.0);
  law.value_low = json.value("value_low", 0.0);
  law.provenance = json.at("provenance").get<std::string>();
  law.source = json.at("source").get<std::string>();
  return law;
}

PropertyEntry parse_property(const Json& material, const std::string& name) {
  PropertyEntry out;
  out.name = name;
  const Json& json = material.at(name);
  if (json.is_object()) {
    const char* key = name == "hardness" ? "hardness_Pa" : "value";
    if (!json.at(key).is_null()) out.value = json.at(key).get<double>();
    out.unit = name == "hardness" ? "Pa" : json.at("unit").get<std::string>();
    out.provenance = json.at("provenance").get<std::string>();
    out.source = json.at("source").get<std::string>();
  }
  const auto law = [&](const char* table) -> std::optional<PropertyLaw> {
    if (!material.contains(table) || !material[table].contains(name)) return std::nullopt;
    return parse_law(material[table][name]);
  };
  out.law = law("temperature_dependence");
  out.cryogenic = law("cryogenic");
  return out;
}

std::map<std::string, MaterialSheet> load_laws() {
  static constexpr std::array kProperties = {"density",
                                             "elastic_modulus",
                                             "poisson_ratio",
                                             "cte",
                                             "specific_heat",
                                             "thermal_conductivity",
                                             "hardness",
                                             "elastic_strain_limit",
                                             "wear_coefficient",
                                             "von_mises_yield",
                                             "von_mises_fatigue_limit"};
  const Json& json = material_json();
  std::map<std::string, MaterialSheet> out;
  for (const auto& [key, entry] : json.at("materials").items()) {
    MaterialSheet sheet;
    sheet.key = key;
    sheet.code = entry.at("code").get<int>();
    sheet.name = entry.at("name").get<std::string>();
    sheet.notes = entry.value("notes", std::string());
    for (const char* name : kProperties) sheet.properties.push_back(parse_property(entry, name));
    if (entry.contains("cryogenic") && entry["cryogenic"].contains("thermal_strain"))
      sheet.cryogenic_strain = parse_law(entry["cryogenic"]["thermal_strain"]);
    out.emplace(key, std::move(sheet));
  }
  return out;
}

const std::map<std::string, MaterialSheet>& sheets() {
  static const std::map<std::string, MaterialSheet> kSheets = load_laws();
  return kSheets;
}

void check_temperature(const Material& material, double T) {
  if (!(T > 0.0 && std::isfinite(T)))
    throw InputError(
        fmt::format("the temperature of a part made of {} is {} K; it must be above 0 (absolute)",
                    material.name, T));
}

const MaterialSheet* sheet_of(const Material& material) {
  return material.table_key.empty() ? nullptr : &material_sheet(material.table_key);
}

}  // namespace

double PropertyLaw::operator()(double temperature) const {
  const double T = std::clamp(temperature, T_min, T_max);
  switch (form) {
    case Form::Polynomial:
      return polynomial(c, T - T_ref);
    case Form::Log10Polynomial:
      return std::pow(10.0, polynomial(c, std::log10(T)));
    case Form::CopperRational: {
      const double s = std::sqrt(T);
      const double over = polynomial({c[0], c[2], c[4], c[6], c[8]}, s);
      const double under = polynomial({1.0, c[1], c[3], c[5], c[7]}, s);
      return std::pow(10.0, over / under);
    }
    case Form::StrainPolynomial:
      return 1e-5 * (T < T_low ? value_low : polynomial(c, T));
  }
  return 0.0;
}

const PropertyEntry& MaterialSheet::property(const std::string& wanted) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PropertyEntry& p) { return p.name == wanted; });
  demand(found != properties.end(), "no material property is named " + wanted);
  return *found;
}

double MaterialSheet::at(const std::string& wanted, double T) const {
  const PropertyEntry& p = property(wanted);
  if (T < kStrainReference && wanted == "cte" && cryogenic_strain)
    return (*cryogenic_strain)(T) / (T - kStrainReference);
  if (T < kStrainReference && p.cryogenic) return (*p.cryogenic)(T);
  if (p.law) return (*p.law)(T);
  demand(p.value.has_value(), "material property " + wanted + " has no value");
  return *p.value;
}

const MaterialSheet& material_sheet(const std::string& key) {
  const auto found = sheets().find(key);
  if (found != sheets().end()) return found->second;
  std::string keys;
  for (const auto& [name, sheet] : sheets()) keys += (keys.empty() ? "" : ", ") + name;
  throw InputError(
      fmt::format("material \"{}\" is not in the material table, which contains {}", key, keys));
}

double thermal_strain(const Material& material, double T, bool laws) {
  check_temperature(material, T);
  const MaterialSheet* sheet = laws ? sheet_of(material) : nullptr;
  const double alpha = sheet == nullptr ? material.thermal_expansion : sheet->at("cte", T);
  return alpha * (T - kStrainReference);
}

double thermal_growth(const Material& material, double T, double T_room, bool laws) {
  check_temperature(material, T);
  check_temperature(material, T_room);
  if (!laws || material.table_key.empty()) return material.thermal_expansion * (T - T_room);
  return thermal_strain(material, T, true) - thermal_strain(material, T_room, true);
}

std::vector<ClampedLaw> clamped_laws(const Material& material, double T) {
  std::vector<ClampedLaw> out;
  const MaterialSheet* sheet = sheet_of(material);
  if (sheet == nullptr) return out;
  for (const char* name : {"elastic_modulus", "cte", "thermal_conductivity", "specific_heat"}) {
    const PropertyEntry& p = sheet->property(name);
    const bool cold = T < kStrainReference;
    const std::optional<PropertyLaw>& cryogenic =
        p.name == "cte" ? sheet->cryogenic_strain : p.cryogenic;
    const std::optional<PropertyLaw>& law = cold && cryogenic ? cryogenic : p.law;
    if (!law || (T >= law->T_min && T <= law->T_max)) continue;
    const bool both = cryogenic.has_value() && p.law.has_value();
    out.push_back({p.name, both ? std::min(cryogenic->T_min, p.law->T_min) : law->T_min,
                   both ? std::max(cryogenic->T_max, p.law->T_max) : law->T_max});
  }
  return out;
}

Material material_at(const Material& material, double T) {
  check_temperature(material, T);
  const MaterialSheet* sheet = sheet_of(material);
  if (sheet == nullptr) return material;
  Material out = material;
  // A single given property (record X3) changes with temperature like that of the table.
  const auto scaled = [&](const char* name, double given) {
    const std::optional<double> room = sheet->property(name).value;
    const double at = sheet->at(name, T);
    return room && *room != 0.0 && given != *room ? given * at / *room : at;
  };
  out.elastic_modulus = scaled("elastic_modulus", material.elastic_modulus);
  out.thermal_expansion = scaled("cte", material.thermal_expansion);
  out.conductivity = sheet->at("thermal_conductivity", T);
  out.specific_heat = sheet->at("specific_heat", T);
  return out;
}

}  // namespace adore::bearing
