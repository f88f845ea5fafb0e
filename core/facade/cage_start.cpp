#include "facade/cage_start.hpp"

#include "results/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

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
  const bool segments = start.cages.size() > 1;
  const auto length = [&](double metres) {
    return fmt::format("{:.4g} {}", results::from_si(metres, results::unit::kLength, deck.units()),
                       results::unit_name(results::unit::kLength, deck.units()));
  };
  const auto clamp = [](double clearance) { return std::max(0.0, -0.5 * clearance); };

  double worst = rounding;
  std::string where;
  const auto look = [&](double overlap, auto&& name) {
    if (overlap <= worst) return;
    worst = overlap;
    where = name();
  };
  const double pocket = clamp(std::min(cage.pocket_clearance_1, cage.pocket_clearance_2));
  for (std::size_t i = 0; i < start.elements.size(); ++i)
    for (const auto& wall : start.elements[i].pocket)
      look(-wall.gap - pocket, [&] { return fmt::format("element {} in its pocket", i + 1); });
  for (std::size_t k = 0; k < start.cages.size(); ++k) {
    const std::string of = segments ? fmt::format(" of segment {}", k + 1) : std::string();
    for (const auto& wall : start.cages[k].last_half)
      look(-wall.gap - pocket, [&] { return "an element in the half pocket at the end" + of; });
    const auto& lands = start.cages[k].lands;
    for (std::size_t i = 0; i < lands.size() && i < cage.lands.size(); ++i)
      look(-lands[i].gap - clamp(cage.lands[i].clearance),
           [&] { return fmt::format("guide land {}{}", i + 1, of); });
    if (segments)
      look(-start.cages[k].to_next, [&] {
        return fmt::format("segments {} and {}", k + 1, (k + 1) % start.cages.size() + 1);
      });
  }
  if (where.empty()) return;

  bool moved = false, turned = false;
  for (std::size_t k = 0; k < start.cages.size(); ++k) {
    moved = moved || !cage.start_of(k).start_offset.isZero(0.0);
    turned = turned || !cage.start_of(k).start_angles.isZero(0.0);
  }
  const auto triple = [&](const char* variable) {
    return fmt::format("{} {:g}, {:g}, {:g}", variable, deck.real(variable, 1, 1),
                       deck.real(variable, 1, 2), deck.real(variable, 1, 3));
  };
  Issue issue;
  issue.file = prepared.input.path.string();
  issue.record = segments ? "9.6.k" : "9.6";
  issue.variable = turned ? "cageAngPos" : "cageGcPos";
  const std::string found =
      fmt::format("the cage starts {} inside other bodies (the worst: {})", length(worst), where);
  if (moved || turned) {
    issue.message = segments ? found + ", where cageGcPos and cageAngPos of its segments put it"
                             : fmt::format("{}, where {} and {} put it", found, triple("cageGcPos"),
                                           triple("cageAngPos"));
    issue.remedy =
        "start it within its clearances: smaller offsets and angles, or 0 for the centred cage";
  } else {
    // Elements stand elsewhere than their pockets: the equilibrium has shifted them.
    issue.record = "7.1";
    issue.variable = "bPocCls1";
    issue.message = found +
                    ", although record 9.6 puts it in the middle: the static solution has " +
                    "shifted or tilted the elements further than their pockets allow";
    issue.remedy = fmt::format(
        "give pockets and lands {} more clearance, or start the cage beside the middle, where the "
        "elements are (cageGcPos, cageAngPos)",
        length(2.0 * worst));
  }
  throw InputError(std::vector<Issue>{issue});
}

}  // namespace adore::facade
