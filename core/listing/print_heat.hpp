#pragma once

#include "listing/report.hpp"
#include "results/static_tables.hpp"
#include "statics/friction.hpp"
#include "thermal/steady_state.hpp"
#include "thermal/time_line.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// Friction and temperatures: pages of PRINT.txt, tables of RUN.json, lines for the terminal.
namespace adore::listing {

/// @param element "ball", "roller"
void print_friction(Report& report, const statics::FrictionEstimate& friction,
                    const std::string& element);
void print_steady_state(Report& report, const thermal::SteadyState& steady);
/// @param geometry it changes with this step
void print_thermal_step(Report& report, const thermal::BearingHeat& heat, long step, double time,
                        bool geometry);

/// "friction": a row for each cause, power and torque.
[[nodiscard]] StaticTable friction_table(const statics::FrictionEstimate& friction);
/// Columns of "elements": heat of each contact by cause.
void add_friction_columns(StaticTable& elements, const statics::FrictionEstimate& friction);
/// "thermal network": one row; temperatures of the nodes, heat flows between them.
[[nodiscard]] StaticTable thermal_network_table(const thermal::BearingHeat& heat);
/// "thermal time line": a row for each step.
[[nodiscard]] StaticTable time_line_table(const thermal::ThermalTransient& line);
void print_time_line(Report& report, const thermal::ThermalTransient& line);

/// Friction torque and, with a thermal analysis, temperatures: a line each.
[[nodiscard]] std::vector<std::string> heat_lines(const statics::FrictionEstimate& friction,
                                                  const thermal::SteadyState* steady,
                                                  UnitSystem units);

}  // namespace adore::listing
