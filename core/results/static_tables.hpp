#pragma once

#include "results/quantities.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// The quasi-static solution as named columns: what RUN.json keeps of it under "quasi_static", and
/// what the plots of a quasi-static run are drawn from. One description serves both ways.
namespace adore::results {

struct StaticColumn {
  std::string name;                ///< "outer load"
  const UnitPair* unit = nullptr;  ///< of the quantity
  std::vector<double> values;      ///< SI (angles in rad); NaN where there is none
};

struct StaticTable {
  std::string name;  ///< "elements": one row per rolling element, in their order
  std::vector<StaticColumn> columns;

  /// nullptr when there is no such column.
  [[nodiscard]] const StaticColumn* find(const std::string& column) const;
  void add(std::string column, const UnitPair& unit, std::vector<double> values);
};

struct StaticTables {
  std::string run_id;
  std::string bearing;                ///< "ball", "cylindrical", ...
  UnitSystem units = UnitSystem::SI;  ///< of the deck: what pictures are drawn in
  std::vector<StaticTable> tables;

  [[nodiscard]] const StaticTable* find(const std::string& table) const;
};

/// SI, each column as "name [unit]"; a value that does not exist is null.
[[nodiscard]] nlohmann::ordered_json to_json(const StaticTables& tables);

/// Reads the output of `to_json` from a RUN.json. @throws InputError for another file, or for a run
/// without a quasi-static solution and without a thermal network.
[[nodiscard]] StaticTables read_static_tables(const std::filesystem::path& run_json);

}  // namespace adore::results
