#include "facade/equilibrium.hpp"

#include "facade/key_results.hpp"
#include "listing/print_heat.hpp"
#include "listing/solution_tables.hpp"
#include "listing/static_cut.hpp"
#include "listing/static_summary.hpp"

#include <utility>

namespace adore::facade {
namespace {

results::StaticTables tables_of(const Prepared& prepared, deck::UnitSystem units) {
  results::StaticTables tables =
      prepared.rollers ? listing::static_tables(*prepared.rollers, prepared.bearing, units)
                       : listing::static_tables(prepared.statics, prepared.bearing, units);
  if (prepared.rollers)
    listing::add_cut(tables, *prepared.rollers, prepared.bearing);
  else
    listing::add_cut(tables, prepared.statics, prepared.bearing);
  if (!prepared.stiffness.empty())
    tables.tables.push_back(listing::stiffness_over_speed(prepared.stiffness));
  if (prepared.friction) {
    listing::add_friction_columns(tables.tables.front(), *prepared.friction);
    tables.tables.push_back(listing::friction_table(*prepared.friction));
  }
  if (prepared.thermal) tables.tables.push_back(listing::network_table(prepared.thermal->heat));
  return tables;
}

std::vector<std::string> lines_of(const Prepared& prepared, deck::UnitSystem units) {
  std::vector<std::string> lines =
      prepared.rollers
          ? listing::summary_lines(listing::summarise(*prepared.rollers, prepared.bearing),
                                   prepared.bearing, prepared.life, units)
          : listing::summary_lines(listing::summarise(prepared.statics, prepared.bearing),
                                   prepared.bearing, prepared.life, units);
  if (prepared.friction)
    for (std::string& line : listing::heat_lines(
             *prepared.friction, prepared.thermal ? &*prepared.thermal : nullptr, units))
      lines.push_back(std::move(line));
  return lines;
}

}  // namespace

Equilibrium equilibrium_of(const Prepared& prepared) {
  const deck::UnitSystem units = prepared.input.deck.units();
  Equilibrium out;
  const statics::RaceResult& race = prepared.race_result();
  out.displacement = race.displacement;
  out.load = race.load;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      out.stiffness[i][j] = race.stiffness(static_cast<int>(i), static_cast<int>(j));
  out.results = static_results(prepared);
  add_heat(out.results, prepared);
  if (prepared.bearing.operating) add_fits(out.results, *prepared.bearing.operating);
  add_lives(out.results, prepared.life);
  out.tables = tables_of(prepared, units);
  out.lines = lines_of(prepared, units);
  out.seconds = prepared.solve_seconds;
  return out;
}

Equilibrium solve_equilibrium(const DeckRequest& request, std::stop_token stop) {
  const Prepared prepared = prepare(request, std::move(stop));
  Equilibrium out = equilibrium_of(prepared);
  out.remarks = prepared.input.warnings;
  for (Issue& note : solution_notes(prepared)) out.remarks.push_back(std::move(note));
  return out;
}

}  // namespace adore::facade
