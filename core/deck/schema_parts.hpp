#pragma once

#include "base/constants.hpp"
#include "deck/schema.hpp"
#include "deck/units.hpp"

#include <string>
#include <vector>

/// Building blocks of the schema tables; only schema_*.cpp include this.
namespace adore::deck {

/// Keeps a composed string alive for the whole run and returns a view of it.
std::string_view intern_string(std::string text);

namespace range {
inline constexpr Range kAny{-kInfinity, kInfinity, false};
inline constexpr Range kPositive{0.0, kInfinity, true};
inline constexpr Range kNotNegative{0.0, kInfinity, false};
inline constexpr Range kTilt{-90.0, 90.0, false};         ///< deg
inline constexpr Range kContactAngle{0.0, 89.99, false};  ///< deg; rows of barrels
inline constexpr Range kBallAngle{0.0, 90.0, false};      ///< deg; 90: a thrust bearing
inline constexpr Range kConeAngle{0.0, 89.9, true};       ///< deg
inline constexpr Range kTaper{-0.1, 0.1, false};          ///< rad; small turns of a profile
inline constexpr Range kProbability{0.0, 1.0, true, true};
inline constexpr Range kPoisson{0.0, 0.5, false};
inline constexpr Range kGroove{0.5, 10.0, true, true};  ///< groove radius over ball diameter
inline constexpr Range kConformity{0.5, 100.0,
                                   true};             ///< groove radius over twice the crown radius
inline constexpr Range kRockwell{0.0, 100.0, false};  ///< HRC
// Physical limits of bearings, in SI units. A value beyond them would fail far from its origin.
inline constexpr Range kSize{1e-6, 1e3, false};        ///< m; of bodies. A value in mm is reported
inline constexpr Range kPlay{-0.1, 0.1, false};        ///< m; plays and fits of rings
inline constexpr Range kShift{-1.0, 1.0, false};       ///< m; of a ring
inline constexpr Range kLean{-1.0, 1.0, false};        ///< rad; of a ring
inline constexpr Range kSpeed{-1e7, 1e7, false};       ///< rpm
inline constexpr Range kLoad{-5e8, 5e8, false};        ///< N, or N m
inline constexpr Range kHeat{0.0, 5000.0, true};       ///< K
inline constexpr Range kSpeedRatio{-1e6, 1e6, false};  ///< to another speed
constexpr Range between(double min, double max) { return {min, max, false}; }
}  // namespace range

/// Condition: a race has a flange.
inline constexpr std::string_view kAnyFlange =
    "(kFlngInd11 > 0 || kFlngInd21 > 0 || kFlngInd12 > 0 || kFlngInd22 > 0)";

VariableSpec record_label();
VariableSpec text(std::string_view name, int max_length, std::string_view help,
                  std::string_view default_value = {});
/// Integer with a closed list of codes.
VariableSpec choice(std::string_view name, std::vector<OptionSpec> options, std::string_view help,
                    std::string_view default_value = {});
/// Integer that counts something.
VariableSpec integer(std::string_view name, Range range, std::string_view help,
                     std::string_view default_value = {});
/// The same, where some counts have special meanings; the last option is "n".
VariableSpec counted(std::string_view name, Range range, std::vector<OptionSpec> options,
                     std::string_view help, std::string_view default_value = {});
VariableSpec real(std::string_view name, const UnitPair& unit, Range range, std::string_view help,
                  std::string_view default_value = {});
/// The same variable as an array; `length` is a number or the name of an integer variable.
VariableSpec array(VariableSpec variable, std::string_view length);
VariableSpec with_option_table(VariableSpec variable, std::string_view option_table);

/// A record that occurs once. The record label is put in front of the variables.
RecordSpec record(std::string_view id, std::string_view title, std::string_view condition,
                  std::vector<VariableSpec> variables);
/// A record that occurs as often as the integer variable `repeat` says.
RecordSpec repeated_record(std::string_view id, std::string_view title, std::string_view condition,
                           std::string_view repeat, std::vector<VariableSpec> variables);

/// The ten variables of an inertia record; names are prefix + "Mass" + suffix and so on.
std::vector<VariableSpec> inertia_variables(std::string_view prefix, std::string_view suffix,
                                            std::string_view body, std::string_view frame);

/// Record groups, in deck order.
void add_control_records(std::vector<RecordSpec>& out);       // 1 to 3.5
void add_geometry_records(std::vector<RecordSpec>& out);      // 4 to 5F
void add_imperfection_records(std::vector<RecordSpec>& out);  // 5G
void add_inertia_records(std::vector<RecordSpec>& out);       // 6
void add_cage_records(std::vector<RecordSpec>& out);          // 7
void add_material_records(std::vector<RecordSpec>& out);      // 8
void add_operation_records(std::vector<RecordSpec>& out);     // 9
void add_lubrication_records(std::vector<RecordSpec>& out);   // 10
void add_final_records(std::vector<RecordSpec>& out);         // 11, 12
void add_extension_records(std::vector<RecordSpec>& out);     // X

}  // namespace adore::deck
