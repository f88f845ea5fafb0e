#include "runs/solution_tables.hpp"

#include "listing/print_heat.hpp"
#include "listing/solution_tables.hpp"
#include "listing/static_cut.hpp"

#include <utility>

namespace adore::runs {

results::StaticTables solution_tables(const Prepared& prepared) {
  const deck::UnitSystem units = prepared.input.deck.units();
  results::StaticTables tables =
      prepared.rollers ? listing::static_tables(*prepared.rollers, prepared.bearing, units)
                       : listing::static_tables(prepared.statics, prepared.bearing, units);
  if (prepared.rollers)
    listing::add_radial_section(tables, *prepared.rollers, prepared.bearing);
  else
    listing::add_radial_section(tables, prepared.statics, prepared.bearing);
  if (!prepared.stiffness.empty())
    tables.tables.push_back(listing::stiffness_over_speed(prepared.stiffness));
  if (prepared.friction) {
    listing::add_friction_columns(tables.tables.front(), *prepared.friction);
    tables.tables.push_back(listing::friction_table(*prepared.friction));
  }
  if (prepared.thermal)
    tables.tables.push_back(listing::thermal_network_table(prepared.thermal->heat));
  if (prepared.time_line) tables.tables.push_back(listing::time_line_table(*prepared.time_line));
  return tables;
}

}  // namespace adore::runs
