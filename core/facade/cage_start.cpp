#include "facade/cage_start.hpp"

#include "results/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::facade {
namespace {

/// Overlaps below this share of the element's radius are rounding.
constexpr double kRounding = 1e-6;

}  // namespace

void check_cage_start(const Prepared& prepared, const scene::Snapshot& start) {
  if (start.cages.empty() || !prepared.bearing.cage) return;
  const bearing::Cage& cage = *prepared.bearing.cage;
  const deck::Deck& deck = prepared.input.deck;
  const double rounding = kRounding * 0.5 * prepared.bearing.element_diameter();
  const auto length = [&](double metres) {
    return fmt::format("{:.4g} {}", results::from_si(metres, results::unit::kLength, deck.units()),
                       results::unit_name(results::unit::kLength, deck.units()));
  };
  const auto clamp = [](double clearance) { return std::max(0.0, -0.5 * clearance); };

  double worst = rounding;
  std::string where;
  const auto look = [&](double overlap, const std::string& name) {
    if (overlap <= worst) return;
    worst = overlap;
    where = name;
  };
  const double pocket = clamp(std::min(cage.pocket_clearance_1, cage.pocket_clearance_2));
  for (std::size_t i = 0; i < start.elements.size(); ++i)
    for (const auto& wall : start.elements[i].pocket)
      look(-wall.gap - pocket, fmt::format("element {} in its pocket", i + 1));
  const auto& lands = start.cages.front().lands;
  for (std::size_t i = 0; i < lands.size() && i < cage.lands.size(); ++i)
    look(-lands[i].gap - clamp(cage.lands[i].clearance), fmt::format("guide land {}", i + 1));
  if (where.empty()) return;

  const auto triple = [&](const char* variable) {
    return fmt::format("{} {:g}, {:g}, {:g}", variable, deck.real(variable, 1, 1),
                       deck.real(variable, 1, 2), deck.real(variable, 1, 3));
  };
  Issue issue;
  issue.file = prepared.input.path.string();
  issue.record = "9.6";
  issue.variable = cage.start_angles.isZero(0.0) ? "cageGcPos" : "cageAngPos";
  issue.message =
      fmt::format("the cage starts {} inside other bodies (the worst: {}), where {} and {} put it",
                  length(worst), where, triple("cageGcPos"), triple("cageAngPos"));
  issue.remedy =
      "start it within its clearances: smaller offsets and angles, or 0 for the centred cage";
  throw InputError(std::vector<Issue>{issue});
}

}  // namespace adore::facade
