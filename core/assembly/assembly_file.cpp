#include "assembly/assembly_file.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_members.hpp"
#include "base/json_text.hpp"
#include "deck/quantity.hpp"
#include "results/quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::assembly {
namespace {

namespace fs = std::filesystem;
namespace unit = results::unit;
using Json = nlohmann::ordered_json;

constexpr double kFarthest = 10.0, kLongest = 10.0;  // position, spacer [m]
constexpr double kLargestOffset = 0.01;              // [m]
constexpr double kLargestForce = 1e8, kLargestMoment = 1e8;
constexpr double kSoftest = 1e3, kStiffest = 1e15;  // [N/m]
constexpr std::array<const char*, 5> kLoads{"x", "y", "z", "about_y", "about_z"};

struct Bounds {
  double least, most;
};

/// A quantity in SI. @throws InputError
double quantity(const JsonMembers& in, std::string_view name, const nlohmann::json& value,
                const deck::UnitPair& unit, Bounds bounds) {
  double out = 0.0;
  if (value.is_number()) {
    out = value.get<double>();
  } else if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (const auto problem = deck::parse_quantity(text, unit, deck::UnitSystem::SI, out))
      in.reject(fmt::format("{} = \"{:.40}\": {}{}{}", name, text, problem.message,
                            problem.remedy.empty() ? "" : "; ", problem.remedy));
  } else {
    in.reject(fmt::format("{} must be a number [{}] or a string with a unit", name, unit.si));
  }
  if (!(out >= bounds.least && out <= bounds.most))
    in.reject(fmt::format("{} = {:g} {}: out of range; enter {:g} to {:g} {}", name, out, unit.si,
                          bounds.least, bounds.most, unit.si));
  return out;
}

double quantity(JsonMembers& in, std::string_view name, const deck::UnitPair& unit, Bounds bounds,
                std::optional<double> fallback = std::nullopt) {
  const nlohmann::json* value = fallback ? in.find(name) : &in.at(name);
  return value == nullptr ? *fallback : quantity(in, name, *value, unit, bounds);
}

/// The deck must be below the folder of the assembly.
std::string deck_name(JsonMembers& in) {
  std::string out = in.text("deck");
  const fs::path path(out);
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
    in.reject(fmt::format(
        "deck = \"{:.80}\": not inside the folder of the assembly. Enter a path from that folder",
        out));
  return out;
}

RowPlacement row_of(JsonMembers& in, bool custom) {
  RowPlacement out;
  out.deck = deck_name(in);
  if (in.find("position") != nullptr)
    out.position = quantity(in, "position", unit::kLength, {-kFarthest, kFarthest});
  out.offset = quantity(in, "offset", unit::kLength, {-kLargestOffset, kLargestOffset}, 0.0);
  const bool given = in.find("orientation") != nullptr;
  if (custom != given)
    in.reject(custom ? "orientation is missing; the arrangement \"custom\" needs \"+\" or \"-\""
                     : "orientation is given by the arrangement. Remove it, or set arrangement to "
                       "\"custom\"");
  if (given) {
    const std::string sign = in.text("orientation");
    if (sign != "+" && sign != "-")
      in.reject(fmt::format("orientation = \"{:.20}\": must be \"+\" or \"-\"", sign));
    out.orientation = sign == "+" ? 1 : -1;
  }
  in.finish();
  return out;
}

Spacer spacer_of(JsonMembers& in) {
  Spacer out;
  out.inner = quantity(in, "inner", unit::kLength, {0.0, kLongest});
  out.outer = quantity(in, "outer", unit::kLength, {0.0, kLongest});
  if (std::abs(out.inner - out.outer) > kLargestOffset)
    in.reject(fmt::format("inner and outer differ by {:g} mm; the largest difference is {:g} mm",
                          1e3 * std::abs(out.inner - out.outer), 1e3 * kLargestOffset));
  if (in.find("stiffness") != nullptr)
    out.stiffness = quantity(in, "stiffness", unit::kStiffness, {kSoftest, kStiffest});
  in.finish();
  return out;
}

void read_class(JsonMembers& in, Preload& out) {
  out.name = in.text("class");
  const nlohmann::json& table = in.at("classes");
  if (!table.is_object() || table.empty())
    in.reject(
        "classes must be an object of class names and forces, such as {\"light\": \"211 N\"}");
  std::string names;
  for (const auto& [name, value] : table.items()) {
    out.classes.emplace_back(
        name, quantity(in, "classes." + name, value, unit::kForce, {1e-3, kLargestForce}));
    names += (names.empty() ? "" : ", ") + name;
  }
  const auto found = std::find_if(out.classes.begin(), out.classes.end(),
                                  [&](const auto& one) { return one.first == out.name; });
  if (found == out.classes.end())
    in.reject(fmt::format("class = \"{:.40}\": not one of the classes {:.200}", out.name, names));
  out.force = found->second;
  out.kind = PreloadKind::Force;
  out.source = in.text("source");
}

Preload preload_of(JsonMembers& in) {
  Preload out;
  int given = 0;
  for (const char* name : {"force", "offset", "class"}) given += in.find(name) != nullptr ? 1 : 0;
  if (given != 1) in.reject("give exactly one of force, offset and class");
  if (in.find("force") != nullptr) {
    out.force = quantity(in, "force", unit::kForce, {1e-3, kLargestForce});
    out.kind = PreloadKind::Force;
  } else if (in.find("offset") != nullptr) {
    out.offset = quantity(in, "offset", unit::kLength, {-kLargestOffset, kLargestOffset});
    out.kind = PreloadKind::Offset;
  } else {
    read_class(in, out);
  }
  if (out.source.empty()) out.source = in.text("source", "");
  if (out.kind == PreloadKind::Force) {
    const std::string state = in.text("state", "unmounted");
    if (state != "unmounted" && state != "operation")
      in.reject(fmt::format("state = \"{:.40}\": must be \"unmounted\" or \"operation\"", state));
    out.in_operation = state == "operation";
  }
  in.finish();
  return out;
}

void read_load(JsonMembers& in, Assembly& out) {
  for (std::size_t k = 0; k < 5; ++k) {
    const double most = k < 3 ? kLargestForce : kLargestMoment;
    out.load[k] = quantity(in, kLoads[k], k < 3 ? unit::kForce : unit::kMoment, {-most, most}, 0.0);
  }
  out.load_position = quantity(in, "position", unit::kLength, {-kFarthest, kFarthest}, 0.0);
  in.finish();
}

void check_order(const JsonMembers& in, const Assembly& out) {
  const auto given = static_cast<std::size_t>(
      std::count_if(out.rows.begin(), out.rows.end(),
                    [](const RowPlacement& row) { return row.position.has_value(); }));
  if (given != 0 && given != out.rows.size())
    in.reject("rows: position is missing in some rows. Enter it in all rows or in none");
  for (std::size_t k = 1; k < out.rows.size() && given > 0; ++k)
    if (!(*out.rows[k].position > *out.rows[k - 1].position))
      in.reject(
          fmt::format("row {}: position = {:g} m is not above that of row {}. List the rows "
                      "in order of their positions",
                      k + 1, *out.rows[k].position, k));
}

std::string text_in(double value, const deck::UnitPair& unit, std::string_view wanted) {
  return fmt::format("{} {}", deck::number_in_unit(value, unit, deck::UnitSystem::SI, wanted),
                     wanted);
}

Json preload_json(const Preload& preload) {
  Json out;
  if (preload.kind == PreloadKind::Offset) {
    out["offset"] = text_in(preload.offset, unit::kLength, "um");
  } else if (!preload.name.empty()) {
    out["class"] = preload.name;
    for (const auto& [name, force] : preload.classes)
      out["classes"][name] = text_in(force, unit::kForce, "N");
  } else {
    out["force"] = text_in(preload.force, unit::kForce, "N");
  }
  if (preload.kind == PreloadKind::Force)
    out["state"] = preload.in_operation ? "operation" : "unmounted";
  if (!preload.source.empty()) out["source"] = preload.source;
  return out;
}

}  // namespace

Assembly read_assembly(std::string_view json, std::string_view name) {
  const nlohmann::json file = parse_json(json, name);
  JsonMembers in(file, std::string(name));
  if (const int version = in.integer("version"); version != kFormatVersion)
    in.reject(fmt::format("version = {}: this program reads version {}", version, kFormatVersion));
  Assembly out;
  out.name = in.text("name", "assembly");
  out.arrangement = in.text("arrangement");
  const auto& names = arrangement_names();
  if (std::find(names.begin(), names.end(), out.arrangement) == names.end())
    in.reject(fmt::format("arrangement = \"{:.40}\": unknown; enter one of {}", out.arrangement,
                          fmt::join(names, ", ")));
  const bool custom = out.arrangement == "custom";
  for (JsonMembers& row : in.objects("rows", "row")) out.rows.push_back(row_of(row, custom));
  if (out.rows.empty() || out.rows.size() > kMaxRows)
    in.reject(fmt::format("rows: {}; enter 1 to {}", counted(out.rows.size(), "row"), kMaxRows));
  const std::vector<int> signs = orientations(out.arrangement);
  if (!custom && signs.size() != out.rows.size())
    in.reject(fmt::format("arrangement {} has {}, but rows lists {}", out.arrangement,
                          counted(signs.size(), "row"), out.rows.size()));
  for (std::size_t k = 0; k < signs.size(); ++k) out.rows[k].orientation = signs[k];
  for (JsonMembers& spacer : in.objects("spacers", "spacer"))
    out.spacers.push_back(spacer_of(spacer));
  if (!out.spacers.empty() && out.spacers.size() + 1 != out.rows.size())
    in.reject(fmt::format("spacers: {} for {}; enter one less than rows, or none",
                          counted(out.spacers.size(), "entry", "entries"),
                          counted(out.rows.size(), "row")));
  check_order(in, out);
  const auto object = [&](const char* member) -> std::optional<JsonMembers> {
    const nlohmann::json* value = in.find(member);
    if (value == nullptr) return std::nullopt;
    return JsonMembers(*value, fmt::format("{}, {}", name, member));
  };
  if (auto preload = object("preload")) out.preload = preload_of(*preload);
  const auto opposed = std::any_of(out.rows.begin(), out.rows.end(), [&](const RowPlacement& row) {
    return row.orientation != out.rows.front().orientation;
  });
  if (out.preload.kind != PreloadKind::None && !opposed)
    in.reject(
        "preload: all rows have the same orientation and cannot preload each other. Enter "
        "the preload as axial load of the set (load.x)");
  if (auto load = object("load")) read_load(*load, out);
  in.finish();
  return out;
}

Assembly read_assembly_file(const fs::path& folder) {
  const fs::path file = assembly_folder(folder) / kFileName;
  constexpr std::size_t kLargest = 1 << 20;
  return read_assembly(read_text_file(file, kLargest), file.string());
}

std::string assembly_text(const Assembly& assembly) {
  Json out;
  out["version"] = kFormatVersion;
  out["name"] = assembly.name;
  out["arrangement"] = assembly.arrangement;
  out["rows"] = Json::array();
  for (const RowPlacement& row : assembly.rows) {
    Json one;
    one["deck"] = row.deck;
    if (assembly.arrangement == "custom") one["orientation"] = row.orientation > 0 ? "+" : "-";
    if (row.position) one["position"] = text_in(*row.position, unit::kLength, "mm");
    if (row.offset != 0.0) one["offset"] = text_in(row.offset, unit::kLength, "um");
    out["rows"].push_back(std::move(one));
  }
  for (const Spacer& spacer : assembly.spacers) {
    Json one{{"inner", text_in(spacer.inner, unit::kLength, "mm")},
             {"outer", text_in(spacer.outer, unit::kLength, "mm")}};
    if (std::isfinite(spacer.stiffness))
      one["stiffness"] = text_in(spacer.stiffness, unit::kStiffness, "N/um");
    out["spacers"].push_back(std::move(one));
  }
  if (assembly.preload.kind != PreloadKind::None) out["preload"] = preload_json(assembly.preload);
  Json load;
  for (std::size_t k = 0; k < 5; ++k)
    load[kLoads[k]] =
        text_in(assembly.load[k], k < 3 ? unit::kForce : unit::kMoment, k < 3 ? "N" : "N.m");
  load["position"] = text_in(assembly.load_position, unit::kLength, "mm");
  out["load"] = std::move(load);
  return dump_json(out, 2) + "\n";
}

bool is_assembly(const fs::path& path) {
  std::error_code error;
  if (path.filename() == kFileName) return fs::exists(path, error);
  return fs::is_directory(path, error) && fs::exists(path / kFileName, error);
}

fs::path assembly_folder(const fs::path& path) {
  if (path.filename() != kFileName) return path;
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace adore::assembly
