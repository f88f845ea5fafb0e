#include "facade/cage_start.hpp"

#include "results/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
  const scene::PocketContactSnapshot* wall_of_worst = nullptr;
  const auto look = [&](double overlap, auto&& name,
                        const scene::PocketContactSnapshot* wall = nullptr) {
    if (overlap <= worst) return;
    worst = overlap;
    where = name();
    wall_of_worst = wall;
  };
  const double pocket = clamp(std::min(cage.pocket_clearance_1, cage.pocket_clearance_2));
  for (std::size_t i = 0; i < start.elements.size(); ++i)
    for (const auto& wall : start.elements[i].pocket)
      look(
          -wall.gap - pocket, [&] { return fmt::format("element {} in its pocket", i + 1); },
          &wall);
  for (std::size_t k = 0; k < start.cages.size(); ++k) {
    const std::string of = segments ? fmt::format(" of segment {}", k + 1) : std::string();
    for (const auto& wall : start.cages[k].last_half)
      look(
          -wall.gap - pocket, [&] { return "an element in the half pocket at the end" + of; },
          &wall);
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
  // Is it the record that puts the cage there, or are the elements where pockets do not reach?
  const bool axial = wall_of_worst != nullptr && prepared.bearing.rollers() == nullptr &&
                     std::abs(std::sin(wall_of_worst->theta)) > 0.7;
  const bool faces = wall_of_worst != nullptr && !cage.pocket_faces.empty();
  bool by_record = moved || turned;
  if (axial && !turned) {
    by_record = false;
    for (std::size_t k = 0; k < start.cages.size(); ++k)
      by_record = by_record || cage.start_of(k).start_offset.x() != 0.0;
  }
  if (by_record) {
    issue.message = segments ? found + ", where cageGcPos and cageAngPos of its segments put it"
                             : fmt::format("{}, where {} and {} put it", found, triple("cageGcPos"),
                                           triple("cageAngPos"));
    issue.remedy =
        "start it within its clearances: smaller offsets and angles, or 0 for the centred cage";
  } else {
    const bool second = axial && (cage.pocket == bearing::PocketShape::Rectangular);
    const bool land = wall_of_worst == nullptr;
    issue.record = faces ? "7.3.i" : land ? "7.2.i" : "7.1";
    issue.variable = faces ? "bPocGsCen2" : land ? "cageGsCls" : second ? "bPocCls2" : "bPocCls1";
    issue.message = fmt::format(
        "{}{}: the static solution has shifted or tilted the elements further than there is room",
        found,
        moved || turned ? ", which is not the doing of record 9.6" : " although it is centred");
    issue.remedy = faces ? fmt::format("put the guide faces at least {} further from the rollers",
                                       length(worst))
                         : fmt::format("give at least {} more clearance", length(2.0 * worst));
  }
  throw InputError(std::vector<Issue>{issue});
}

}  // namespace adore::facade
