#pragma once

#include "bearing/bearing.hpp"
#include "results/quantities.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"
#include "statics/stiffness_table.hpp"

#include <nlohmann/json.hpp>

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

/// Tables of a ball bearing: "elements" with azimuth, and per race load, contact angle, pressure
/// and the angles between which the contact ellipse lies, and, where the deck gives a shoulder, the
/// angle at which the groove ends.
[[nodiscard]] StaticTables static_tables(const statics::StaticSolution& solution,
                                         const bearing::Bearing& bearing, UnitSystem units);

/// Tables of a roller bearing: "elements" with azimuth, tilt, and per race load, moment, contact
/// angle, largest pressure, flange loads; "slices" along the most loaded roller.
[[nodiscard]] StaticTables static_tables(const statics::RollerSolution& solution,
                                         const bearing::Bearing& bearing, UnitSystem units);

/// "stiffness over speed": one row per speed with the speeds, the displacement, the largest contact
/// load and, as "Fx/x", "My/rot y" ..., every entry of the stiffness, with " by difference" behind
/// where that was computed; NaN at speeds without an equilibrium.
[[nodiscard]] StaticTable stiffness_over_speed(const std::vector<statics::StiffnessRow>& rows);

/// SI, each column as "name [unit]"; a value that does not exist is null.
[[nodiscard]] nlohmann::ordered_json to_json(const StaticTables& tables);

/// What `to_json` wrote into a RUN.json. @throws InputError when the file is none, or is of a run
/// without a quasi-static solution.
[[nodiscard]] StaticTables read_static_tables(const std::filesystem::path& run_json);

}  // namespace adore::results
