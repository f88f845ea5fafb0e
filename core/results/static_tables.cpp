#include "results/static_tables.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::results {
namespace {

using Json = nlohmann::ordered_json;

/// Every unit that a column may have; a name of the SI system means one of them.
constexpr std::array kUnits{&unit::kPure,
                            &unit::kAngle,
                            &unit::kLength,
                            &unit::kForce,
                            &unit::kMoment,
                            &unit::kPressure,
                            &unit::kSpeed,
                            &unit::kRadian,
                            &unit::kRotation,
                            &unit::kStiffness,
                            &unit::kPower,
                            &unit::kLife,
                            &unit::kRotationalStiffness,
                            &unit::kCoupledStiffness,
                            &unit::kTemperature};

const UnitPair* unit_named(std::string_view si) {
  for (const UnitPair* unit : kUnits)
    if (unit->si == si) return unit;
  return nullptr;
}

}  // namespace

const StaticColumn* StaticTable::find(const std::string& column) const {
  for (const StaticColumn& candidate : columns)
    if (candidate.name == column) return &candidate;
  return nullptr;
}

void StaticTable::add(std::string column, const UnitPair& unit, std::vector<double> values) {
  columns.push_back({std::move(column), &unit, std::move(values)});
}

const StaticTable* StaticTables::find(const std::string& table) const {
  for (const StaticTable& candidate : tables)
    if (candidate.name == table) return &candidate;
  return nullptr;
}

Json to_json(const StaticTables& tables) {
  Json out;
  out["bearing"] = tables.bearing;
  out["units"] = tables.units == UnitSystem::SI ? "SI" : "English";
  for (const StaticTable& table : tables.tables) {
    Json columns = Json::object();
    for (const StaticColumn& column : table.columns) {
      Json values = Json::array();
      for (const double value : column.values) {
        const double shown = from_si(value, *column.unit, UnitSystem::SI);
        values.push_back(std::isfinite(shown) ? Json(shown) : Json());
      }
      columns[fmt::format("{} [{}]", column.name, column.unit->si)] = std::move(values);
    }
    out["tables"][table.name] = std::move(columns);
  }
  return out;
}

StaticTables read_static_tables(const std::filesystem::path& run_json) {
  const auto refuse = [&](const std::string& why) -> InputError {
    return InputError(fmt::format("{}: {}", run_json.string(), why));
  };
  const Json json = parse_json<Json>(read_text_file(run_json), run_json.string());
  try {
    if (!json.is_object() || !(json.contains("quasi_static") || json.contains("thermal_network")))
      throw refuse(
          "contains no quasi-static solution and no thermal network. Plots of static results need "
          "the RUN.json of a run with mode -1, or of a dynamic run with kTherm = 1 after a thermal "
          "step");
    const Json& section =
        json.at(json.contains("quasi_static") ? "quasi_static" : "thermal_network");
    StaticTables out;
    out.run_id = json.value("run", "");
    out.bearing = section.at("bearing").get<std::string>();
    out.units = section.at("units") == "SI" ? UnitSystem::SI : UnitSystem::English;
    for (const auto& [name, columns] : section.at("tables").items()) {
      StaticTable& table = out.tables.emplace_back(StaticTable{name, {}});
      for (const auto& [title, values] : columns.items()) {
        const std::size_t bracket = title.rfind(" [");
        if (bracket == std::string::npos || title.back() != ']')
          throw refuse(fmt::format("column \"{}\" has no unit", title));
        const std::string unit = title.substr(bracket + 2, title.size() - bracket - 3);
        const UnitPair* pair = unit_named(unit);
        if (pair == nullptr) throw refuse(fmt::format("unit \"{}\" is not known", unit));
        std::vector<double> numbers;
        for (const Json& value : values)
          numbers.push_back(value.is_null() ? kNaN
                                            : to_si(value.get<double>(), *pair, UnitSystem::SI));
        table.add(title.substr(0, bracket), *pair, std::move(numbers));
      }
    }
    return out;
  } catch (const nlohmann::json::exception& error) {
    throw refuse(fmt::format("is not a RUN.json that this version reads ({})", error.what()));
  }
}

}  // namespace adore::results
