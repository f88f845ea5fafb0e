#include "deck/catalogue_parts.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "deck/number.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::deck {

using Json = nlohmann::json;

const Json& catalogue_table() {
  static const Json json = parse_json(resources::get("catalogue.json"), "catalogue.json");
  return json;
}

const BearingTypeInfo& bearing_type_info(BearingType type) {
  return *std::find_if(kTypes.begin(), kTypes.end(),
                       [&](const BearingTypeInfo& info) { return info.type == type; });
}

std::string_view bearing_type_keyword(BearingType type) { return bearing_type_info(type).word; }

std::string_view type_name(BearingType type) { return bearing_type_info(type).name; }

const std::vector<std::string>& bearing_type_keywords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> out;
    for (const BearingTypeInfo& info : kTypes) out.emplace_back(info.word);
    return out;
  }();
  return words;
}

BearingType parse_bearing_type(std::string_view word) {
  for (const BearingTypeInfo& info : kTypes)
    if (info.word == word) return info.type;
  std::string known;
  for (const std::string& one : bearing_type_keywords()) known += (known.empty() ? "" : ", ") + one;
  throw InputError(fmt::format("unknown bearing type \"{}\"; the types are {}", word, known));
}

double default_contact_angle(BearingType type, const Envelope& envelope) {
  switch (type) {
    case BearingType::AngularContact:
      return 40.0;
    case BearingType::Tapered:
      return 14.0361;             // of most sizes of the series 302
    case BearingType::Spherical:  // rows a little less than half the width apart
      return std::atan(0.245 * envelope.width / (0.25 * (envelope.bore + envelope.outside))) /
             kDegree;
    default:
      return 0.0;
  }
}

namespace {

/// Key of the table; empty: no group of radial clearance.
std::string_view clearance_kind(BearingType type) {
  switch (type) {
    case BearingType::DeepGroove:
      return "ball";
    case BearingType::Cylindrical:
      return "cylindrical";
    case BearingType::Spherical:
      return "spherical";
    default:
      return "";
  }
}

}  // namespace

bool has_clearance_group(BearingType type, std::string_view group) {
  const std::string_view kind = clearance_kind(type);
  const auto at = std::find(kGroups.begin(), kGroups.end(), group);
  return !kind.empty() && at != kGroups.end() &&
         static_cast<std::size_t>(at - kGroups.begin()) + 2 <
             catalogue_table()["clearance"][std::string(kind)][0].size();
}

double clearance_group_mean(BearingType type, std::string_view group, double bore,
                            bool tapered_bore) {
  if (!has_clearance_group(type, group))
    throw InputError(fmt::format("there is no clearance group {} for a {}", group,
                                 bearing_type_info(type).name));
  const bool of_taper = tapered_bore && type == BearingType::Spherical;  // of others none is known
  const Json& rows = catalogue_table()["clearance"][std::string(clearance_kind(type)) +
                                                    (of_taper ? ", tapered bore" : "")];
  const auto column = static_cast<std::size_t>(
      2 + (std::find(kGroups.begin(), kGroups.end(), group) - kGroups.begin()));
  const auto middle = [&](const Json& row) {
    return 0.5 * (row[column][0].get<double>() + row[column][1].get<double>()) * kMicron;
  };
  const double size = bore / kMm;
  for (const Json& row : rows)
    if (size <= row[1].get<double>()) return middle(row);
  return middle(rows.back()) * size / rows.back()[1].get<double>();
}

double real(const std::string& text) {
  double value = 0.0;
  demand(!parse_real(text, value), "a proposed value is a number");
  return value;
}

double number(const ProposedInternalGeometry& inner, std::string_view name) {
  for (const auto& [variable, value] : inner.sets)
    if (variable == name) return real(value);
  return 0.0;
}

}  // namespace adore::deck
