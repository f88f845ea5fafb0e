#include "runs/equilibrium.hpp"

#include "listing/print_heat.hpp"
#include "listing/static_summary.hpp"
#include "runs/fault_frequencies.hpp"
#include "runs/key_results.hpp"
#include "runs/solution_tables.hpp"

#include <utility>

namespace adore::runs {
namespace {

std::vector<std::string> lines_of(const Prepared& prepared, deck::UnitSystem units) {
  std::vector<std::string> lines =
      prepared.rollers
          ? listing::summary_lines(listing::summarize(*prepared.rollers, prepared.bearing),
                                   prepared.bearing, prepared.life, units)
          : listing::summary_lines(listing::summarize(prepared.statics, prepared.bearing),
                                   prepared.bearing, prepared.life, units);
  if (prepared.friction)
    for (std::string& line : listing::heat_lines(
             *prepared.friction, prepared.thermal ? &*prepared.thermal : nullptr, units))
      lines.push_back(std::move(line));
  for (std::string& line : fault_frequency_lines(prepared, equilibrium_fault_frequencies(prepared)))
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
  out.results = equilibrium_results(prepared);
  out.tables = solution_tables(prepared);
  out.lines = lines_of(prepared, units);
  out.seconds = prepared.solve_seconds;
  return out;
}

Equilibrium solve_equilibrium(const DeckRequest& request, std::stop_token stop) {
  const Prepared prepared = prepare(request, std::move(stop));
  Equilibrium out = equilibrium_of(prepared);
  out.remarks = prepared.input.warnings;
  for (Finding& note : solution_notes(prepared)) out.remarks.push_back(std::move(note));
  return out;
}

}  // namespace adore::runs
