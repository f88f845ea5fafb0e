#include "bearing/material.hpp"

#include "base/errors.hpp"
#include "base/resources.hpp"
#include "bearing/material_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace adore::bearing {
namespace {

using Json = nlohmann::json;

constexpr double kPascalPerVickers = 9.80665e6;  // 1 kgf/mm^2, exact

struct HardnessPoint {
  double hrc = 0.0;
  double vickers = 0.0;
};

struct Table {
  std::map<std::string, Material> materials;  // by the key of the file: the code, or "mild_steel"
  std::map<Part, std::string> defaults;
  std::vector<HardnessPoint> hardness;  // ascending HRC
};

/// A chain is as strong as its weakest link: seen > recalled > estimated.
void weaken(std::string& provenance, const std::string& other) {
  static const std::vector<std::string> order = {"seen", "recalled", "estimated"};
  const auto rank = [](const std::string& word) {
    const auto found = std::find(order.begin(), order.end(), word);
    demand(found != order.end(), "unknown provenance '" + word + "' in materials.json");
    return found - order.begin();
  };
  if (provenance.empty() || rank(other) > rank(provenance)) provenance = other;
}

double property(const Json& entry, const char* name, std::string& provenance) {
  const Json& item = entry.at(name);
  weaken(provenance, item.at("provenance").get<std::string>());
  return item.at("value").get<double>();
}

Material parse_material(const Json& entry) {
  Material material;
  std::string& provenance = material.provenance;
  material.code = entry.at("code").get<int>();
  material.name = entry.at("name").get<std::string>();
  material.density = property(entry, "density", provenance);
  material.elastic_modulus = property(entry, "elastic_modulus", provenance);
  material.poisson_ratio = property(entry, "poisson_ratio", provenance);
  material.thermal_expansion = property(entry, "cte", provenance);
  material.conductivity = property(entry, "thermal_conductivity", provenance);
  material.specific_heat = property(entry, "specific_heat", provenance);
  material.elastic_strain_limit = property(entry, "elastic_strain_limit", provenance);
  material.wear_coefficient = property(entry, "wear_coefficient", provenance);
  const Json& hardness = entry.at("hardness");
  weaken(provenance, hardness.at("provenance").get<std::string>());
  material.hardness = hardness.at("hardness_Pa").get<double>();
  const Json& limit = entry.at("von_mises_fatigue_limit");
  const bool limit_known = !limit.is_null() && !limit.at("value").is_null();
  material.fatigue_limit_stress =
      property(entry, limit_known ? "von_mises_fatigue_limit" : "von_mises_yield", provenance);
  return material;
}

Table load() {
  const Json& json = material_json();
  Table table;
  for (const auto& [key, entry] : json.at("materials").items())
    table.materials.emplace(key, parse_material(entry)).first->second.table_key = key;

  const Json& defaults = json.at("defaults");
  const std::pair<Part, const char*> parts[] = {{Part::RollingElement, "rolling_element"},
                                                {Part::OuterRace, "outer_race"},
                                                {Part::InnerRace, "inner_race"},
                                                {Part::Housing, "housing"},
                                                {Part::Shaft, "shaft"},
                                                {Part::Cage, "cage"}};
  for (const auto& [part, name] : parts) table.defaults[part] = defaults.at(name);

  for (const auto& [hrc, vickers] : json.at("hrc_to_hv").items())
    table.hardness.push_back({static_cast<double>(std::stoi(hrc)), vickers.get<double>()});
  std::sort(table.hardness.begin(), table.hardness.end(),
            [](const HardnessPoint& a, const HardnessPoint& b) { return a.hrc < b.hrc; });
  demand(table.hardness.size() >= 2,
         "\"hrc_to_hv\" in materials.json must have at least two values");
  return table;
}

const Table& table() {
  static const Table kTable = load();
  return kTable;
}

}  // namespace

const nlohmann::json& material_json() {
  static const Json kJson = Json::parse(resources::get("materials.json"));
  return kJson;
}

Material material_from_table(int code, Part part) {
  const std::string key = code == 0 ? table().defaults.at(part) : std::to_string(code);
  const auto found = table().materials.find(key);
  if (found != table().materials.end()) {
    Material material = found->second;
    material.code = code;
    return material;
  }
  std::string codes = "0 (default)";
  for (const int valid : material_codes()) codes += fmt::format(", {}", valid);
  std::string message = fmt::format("material code {} is not in the material table", code);
  if (code == 1) message += " (code 1 means that the deck gives the properties)";
  if (code == 2) message += " (code 2 means that a user routine gives the properties)";
  throw InputError(message + "; valid codes are " + codes);
}

std::vector<int> material_codes() {
  std::vector<int> codes;
  for (const auto& [key, material] : table().materials)
    if (material.code > 0) codes.push_back(material.code);
  std::sort(codes.begin(), codes.end());
  return codes;
}

double hardness_from_hrc(double hrc) {
  const std::vector<HardnessPoint>& points = table().hardness;
  auto upper = std::upper_bound(points.begin(), points.end(), hrc,
                                [](double x, const HardnessPoint& point) { return x < point.hrc; });
  upper = std::clamp(upper, points.begin() + 1, points.end() - 1);
  const HardnessPoint& a = *(upper - 1);
  const HardnessPoint& b = *upper;
  const double vickers = a.vickers + (b.vickers - a.vickers) * (hrc - a.hrc) / (b.hrc - a.hrc);
  if (!(vickers > 0.0))
    throw InputError(
        fmt::format("a Rockwell C hardness of {} cannot be converted to Vickers hardness; give a "
                    "value from 20 to 70",
                    hrc));
  return kPascalPerVickers * vickers;
}

double contact_modulus(const Material& a, const Material& b) {
  for (const Material* m : {&a, &b}) {
    if (!(m->elastic_modulus > 0.0))
      throw InputError(fmt::format("the elastic modulus {}is {} Pa; it must be above 0",
                                   m->name.empty() ? "" : "of " + m->name + " ",
                                   m->elastic_modulus));
    if (!(m->poisson_ratio > -1.0 && m->poisson_ratio <= 0.5))
      throw InputError(fmt::format("Poisson's ratio {}is {}; it must be above -1 and at most 0.5",
                                   m->name.empty() ? "" : "of " + m->name + " ", m->poisson_ratio));
  }
  const double compliance = (1.0 - a.poisson_ratio * a.poisson_ratio) / a.elastic_modulus +
                            (1.0 - b.poisson_ratio * b.poisson_ratio) / b.elastic_modulus;
  return 1.0 / compliance;
}

}  // namespace adore::bearing
