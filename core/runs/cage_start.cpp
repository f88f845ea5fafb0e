#include "runs/cage_start.hpp"

#include "contact/ball_pocket.hpp"
#include "contact/roller_pocket_play.hpp"
#include "contact/roller_shape.hpp"
#include "results/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace adore::runs {
namespace {

/// Overlaps below this share of the element's radius are rounding.
constexpr double kOverlapRounding = 1e-6;

/// Angle by which the round pockets of a cage lean against its rollers, which then do not fit at
/// all; 0: they do, or the pockets are not round.
double misfit_angle(const bearing::Bearing& bearing) {
  const bearing::Cage& cage = *bearing.cage;
  const bearing::RollerGeometry* rollers = bearing.rollers();
  if (rollers == nullptr || cage.pocket != bearing::PocketShape::Cylindrical ||
      !cage.pocket_faces.empty() || !(cage.pocket_clearance_1 > 0.0))
    return 0.0;
  const double lean = cage.cone_angle - rollers->axis_angle;
  const auto [low, high] = contact::pocket_wall_limits(cage.outer_diameter, cage.inner_diameter,
                                                       rollers->pitch_diameter);
  contact::RoundPocket pocket;
  pocket.radius = 0.5 * (rollers->diameter + cage.pocket_clearance_1);
  pocket.z_low = low;
  pocket.z_high = high;
  pocket.taper = std::tan(rollers->half_angle);
  pocket.cosine = std::cos(rollers->half_angle);
  const bool fits =
      contact::round_pocket_clearance(pocket, contact::roller_profile(*rollers), lean) > 0.0;
  return fits ? 0.0 : lean;
}

/// Whether record 9.6 moves and turns the cage, or one of its segments.
std::pair<bool, bool> cage_displacement(const bearing::Cage& cage, std::size_t segments) {
  bool moved = false, turned = false;
  for (std::size_t k = 0; k < segments; ++k) {
    moved = moved || !cage.start_of(k).start_offset.isZero(0.0);
    turned = turned || !cage.start_of(k).start_angles.isZero(0.0);
  }
  return {moved, turned};
}

}  // namespace

void reject_cage_start(const Prepared& prepared, const SolverError& error) {
  const auto& cage = prepared.bearing.cage;
  const std::string why = error.what();
  if (!cage || why.find("outside its cage pocket") == std::string::npos) throw;
  const auto segments =
      static_cast<std::size_t>(std::max(1LL, prepared.input.deck.integer("nCseg")));
  const auto [moved, turned] = cage_displacement(*cage, segments);
  if (!moved && !turned) throw;
  Issue issue;
  issue.file = prepared.input.path.string();
  issue.record = segments > 1 ? "9.6.k" : "9.6";
  issue.variable = turned ? "cageAngPos" : "cageGcPos";
  issue.message = "moves the cage away from its elements: " + why;
  issue.remedy = "enter smaller offsets and angles (0: centered cage)";
  throw InputError(std::vector<Issue>{issue});
}

void check_cage_start(const Prepared& prepared, const scene::Snapshot& start) {
  if (start.cages.empty() || !prepared.bearing.cage) return;
  const bearing::Cage& cage = *prepared.bearing.cage;
  const deck::Deck& deck = prepared.input.deck;
  const double rounding = kOverlapRounding * 0.5 * prepared.bearing.element_diameter();
  const bool segments = start.cages.size() > 1;
  const auto length = [&](double metres) {
    return fmt::format("{:.4g} {}", results::from_si(metres, results::unit::kLength, deck.units()),
                       results::unit_name(results::unit::kLength, deck.units()));
  };
  const auto clamp = [](double clearance) { return std::max(0.0, -0.5 * clearance); };

  double worst = rounding;
  std::string where;
  const scene::PocketContactSnapshot* worst_pocket_wall = nullptr;
  const auto look = [&](double overlap, auto&& name,
                        const scene::PocketContactSnapshot* wall = nullptr) {
    if (overlap <= worst) return;
    worst = overlap;
    where = name();
    worst_pocket_wall = wall;
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

  const auto [moved, turned] = cage_displacement(cage, start.cages.size());
  const auto triple = [&](const char* variable) {
    return fmt::format("{} {:g}, {:g}, {:g}", variable, deck.real(variable, 1, 1),
                       deck.real(variable, 1, 2), deck.real(variable, 1, 3));
  };
  Issue issue;
  issue.file = prepared.input.path.string();
  issue.record = segments ? "9.6.k" : "9.6";
  issue.variable = turned ? "cageAngPos" : "cageGcPos";
  const std::string found =
      fmt::format("the cage overlaps other bodies by {} at the start (largest overlap: {})",
                  length(worst), where);
  // Is it the record that puts the cage there, or are the elements where pockets do not reach?
  const bool axial = worst_pocket_wall != nullptr && prepared.bearing.rollers() == nullptr &&
                     std::abs(std::sin(worst_pocket_wall->theta)) > 0.7;
  const bool faces = worst_pocket_wall != nullptr && !cage.pocket_faces.empty();
  bool by_record = moved || turned;
  if (axial && !turned) {
    by_record = false;
    for (std::size_t k = 0; k < start.cages.size(); ++k)
      by_record = by_record || cage.start_of(k).start_offset.x() != 0.0;
  }
  if (by_record) {
    issue.message = segments ? found + ", because of cageGcPos and cageAngPos of the cage segments"
                             : fmt::format("{}, because of {} and {}", found, triple("cageGcPos"),
                                           triple("cageAngPos"));
    issue.remedy = fmt::format(
        "enter smaller offsets and angles (0: centered cage), or a larger clearance ({})",
        worst_pocket_wall != nullptr ? "bPocCls1" : "cageGsCls");
  } else if (const double lean = misfit_angle(prepared.bearing);
             lean != 0.0 && worst_pocket_wall != nullptr) {
    constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
    issue.record = "7.1";
    issue.variable = "cageConeAng";
    issue.message = fmt::format(
        "{}: with a cone angle of {:.4g} degrees, the round pockets are inclined by {:.4g} "
        "degrees to the rollers and do not fit",
        found, prepared.bearing.cage->cone_angle * kDegreesPerRadian,
        std::abs(lean) * kDegreesPerRadian);
    issue.remedy = fmt::format(
        "enter a cone angle of {:.6g} degrees (the angle of the rollers), or a larger bPocCls1",
        prepared.bearing.rollers()->axis_angle * kDegreesPerRadian);
  } else {
    const bool second = axial && (cage.pocket == bearing::PocketShape::Rectangular);
    const bool land = worst_pocket_wall == nullptr;
    const bool uneven = std::any_of(cage.lands.begin(), cage.lands.end(),
                                    [](const bearing::GuideLand& one) { return !one.ideal(); });
    issue.record = faces ? "7.3.i" : land ? "7.2.i" : "7.1";
    issue.variable = faces ? "bPocGsCen2" : land ? "cageGsCls" : second ? "bPocCls2" : "bPocCls1";
    issue.message = fmt::format(
        "{}{}{}: {}", found,
        pocket > 0.0 && worst_pocket_wall != nullptr
            ? fmt::format(", more than the interference of the pockets ({})", length(pocket))
            : std::string(),
        moved || turned ? ". Record 9.6 is not the cause" : ", although the cage is centered",
        !land ? "the static solution shifted or tilted the elements by more than the clearance"
        : uneven
            ? "the shape errors of records 7.5.i and 7.6.i exceed the clearance left by the "
              "static solution"
            : "the static solution moved the elements toward the race by more than the clearance");
    issue.remedy =
        faces ? fmt::format("move the guide faces at least {} further away from the rollers",
                            length(worst))
              : fmt::format("give at least {} more clearance", length(2.0 * worst));
  }
  throw InputError(std::vector<Issue>{issue});
}

}  // namespace adore::runs
