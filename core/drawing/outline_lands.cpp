#include "contact/guide_land.hpp"
#include "drawing/outline_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

/// Guide lands of the cage: section with exaggerated clearances, and out-of-round lands around the
/// axis.
namespace adore::drawing {
namespace {

using bearing::GuideLand;
using deck::Deck;

constexpr double kShownGap = 0.35;  // of the cage's thickness, for the largest clearance

/// 1, 2 or 5 times a power of ten, not above.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0})
    if (value >= step * power) return step * power;
  return power;
}

void add_land(const Deck& deck, const OutlineCage& cage, std::size_t index, double factor,
              Pane& pane) {
  const GuideLand& land = cage.lands[index];
  const int i = static_cast<int>(index) + 1;
  const double thick = 0.5 * (cage.outer_diameter - cage.inner_diameter),
               mid = 0.25 * (cage.outer_diameter + cage.inner_diameter);
  const bool inner = land.guide == GuideLand::Guide::Inner;
  const double sigma = inner ? -1.0 : 1.0;
  const double inside = land.edge - std::copysign(land.width, land.edge);
  const double left = std::min(land.edge, inside), right = std::max(land.edge, inside);
  const double y = std::clamp(0.5 * land.diameter - mid, -2.0 * thick, 2.0 * thick);
  const double surface = sigma * 0.5 * thick;
  if (sigma * (y - surface) > 1e-6 * thick)
    pane.shapes.push_back(shape_of(Part::Cage, Shape::Style::Cut, "raised land",
                                   rectangle(left, surface, right, y), {"cageGsDia"}));
  pane.shapes.push_back(shape_of(Part::Cage, Shape::Style::Strong,
                                 fmt::format("land {} of the cage", i), {{left, y}, {right, y}},
                                 {"cageGsDia", "cageGsWidth", "cageGsPos", "cageGsRadVar1",
                                  "cageGsRadVar2", "cageGsRadVar3"}));
  DimensionCollector put(deck, pane);
  const double step = 0.3 * thick;
  if (land.guide != GuideLand::Guide::None) {
    const double race = y + sigma * 0.5 * factor * land.clearance;
    const double back = race + sigma * 0.7 * thick;
    const double margin = 0.04 * cage.width;
    pane.shapes.push_back(shape_of(
        inner ? Part::InnerRing : Part::OuterRing, Shape::Style::Cut,
        inner ? "inner race" : "outer race", rectangle(left - margin, race, right + margin, back),
        {"iCageGuide", "raceGsRadVar1", "raceGsRadVar2", "raceGsRadVar3"}));
    put.vertical("cageGsCls", y, race, 0.5 * (left + right), {left, y}, {left, race}, i);
    put.horizontal("cageGsWidth", left, right, back + sigma * step, {left, y}, {right, y}, i);
  } else {
    put.horizontal("cageGsWidth", left, right, y + sigma * step, {left, y}, {right, y}, i);
  }
  const double below = -sigma * (0.5 * thick + (1.0 + static_cast<double>(index)) * step);
  put.horizontal("cageGsPos", 0.0, land.edge, below, {0.0, 0.0}, {land.edge, y}, i);
  put.leader("cageGsDia", {0.5 * (left + inside) * 0.5, y - sigma * 0.6 * thick},
             {0.5 * (left + right), y}, i);
  pane.captions.push_back(
      {{0.5 * (left + right), y - sigma * 0.25 * thick}, std::to_string(i), right - left});
}

/// Lands around the axis, deviations from the circle exaggerated; empty when all are ideal.
void add_round_lands(const Deck& deck, const OutlineCage& cage, Drawing& out) {
  const long long cage_code = deck.integer("kCageGsImp"), race_code = deck.integer("kRaceGsImp");
  if (cage_code < 1 && race_code < 1) return;
  struct Ring {
    Part part;
    contact::LandProfile profile;
    Path path;
    int land;
  };
  std::vector<Ring> rings;
  constexpr int kParts = 180;
  double largest = 0.0;
  for (std::size_t i = 0; i < cage.lands.size(); ++i) {
    const GuideLand& land = cage.lands[i];
    const int number = static_cast<int>(i) + 1;
    const double r = 0.5 * land.diameter;
    if (!(r > 0.0)) continue;
    const bool inner = land.guide == GuideLand::Guide::Inner;
    rings.push_back({Part::Cage, contact::land_profile(r, land.of_cage), {}, number});
    rings.push_back({inner ? Part::InnerRing : Part::OuterRing,
                     contact::land_profile(r + (inner ? -0.5 : 0.5) * land.clearance, land.of_race),
                     {},
                     number});
  }
  for (const Ring& ring : rings)
    for (int k = 0; k < kParts; ++k)
      largest =
          std::max(largest, std::abs(ring.profile.at(kTurn * k / kParts)[0] - ring.profile.radius));
  if (rings.empty() || !(largest > 0.0)) return;
  const double size = rings.front().profile.radius;
  const double factor = std::max(round_down(0.14 * size / largest), 1.0);
  Pane pane;
  pane.title = fmt::format("Guide lands seen from +X, form errors enlarged × {:g}", factor);
  for (const Ring& ring : rings) {
    // Cage inside, race outside, so that their lines stay apart; inner guidance the other way.
    const double base = size * (ring.part == Part::Cage        ? 1.0
                                : ring.part == Part::OuterRing ? 1.35
                                                               : 0.65);
    const double aside = 3.2 * size * (ring.land - 1);
    Shape shape;
    shape.part = ring.part;
    shape.style = Shape::Style::Line;
    const char* stem = ring.part == Part::Cage ? "cage" : "race";
    shape.name = fmt::format("{} land {}", stem, ring.land);
    Path path;
    for (int k = 0; k <= kParts; ++k) {
      const double psi = kTurn * k / kParts;
      const double r = base + factor * (ring.profile.at(psi)[0] - ring.profile.radius);
      const Point p = point_at_azimuth(r, psi);
      path.push_back({p.x + aside, p.y});
    }
    shape.paths.push_back(std::move(path));
    for (int k = 1; k <= 3; ++k) shape.shows.push_back(fmt::format("{}GsRadVar{}", stem, k));
    pane.shapes.push_back(std::move(shape));
    Shape ideal;
    ideal.style = Shape::Style::Dashed;
    ideal.name = "ideal land";
    ideal.circles.push_back({{aside, 0.0}, base});
    pane.shapes.push_back(std::move(ideal));
    DimensionCollector put(deck, pane);
    for (int k = 1; k <= 3; ++k)
      put.note(fmt::format("{}GsRadVar{}", stem, k), {aside, 0.0},
               {aside - 0.7071 * base, 0.7071 * base}, ring.land);
    pane.captions.push_back({{aside, -0.25 * size}, fmt::format("land {}", ring.land), 0.0});
  }
  out.panes.push_back(std::move(pane));
}

}  // namespace

Drawing draw_lands(const Deck& deck) {
  const std::optional<OutlineCage> cage = outline_cage(deck);
  if (deck.integer("nCseg") < 1) throw InputError("This bearing has no cage (nCseg = 0).");
  if (!cage)
    throw InputError(
        "The cage cannot be drawn. cageDia1 must be larger than cageDia2, and cageWidth must be "
        "above 0.");
  if (cage->lands.empty()) throw InputError("The cage has no guide land (nGL = 0).");
  Drawing out;
  Pane pane;
  const double thick = 0.5 * (cage->outer_diameter - cage->inner_diameter),
               half = 0.5 * cage->width;
  double largest = 0.0;
  for (const GuideLand& land : cage->lands) largest = std::max(largest, land.clearance);
  const double factor =
      largest > 0.0 ? std::max(round_down(2.0 * kShownGap * thick / largest), 1.0) : 1.0;
  pane.title = factor > 1.0 ? fmt::format("Section of the cage, clearances enlarged × {:g}", factor)
                            : "Section of the cage, to scale";
  pane.shapes.push_back(shape_of(Part::Cage, Shape::Style::Cut, "cage",
                                 rectangle(-half, -0.5 * thick, half, 0.5 * thick), {"nGL"}));
  for (std::size_t i = 0; i < cage->lands.size(); ++i) {
    if (!(cage->lands[i].width > 0.0) || !(cage->lands[i].diameter > 0.0)) {
      out.remarks.push_back(
          fmt::format("Land {} is not drawn: its width or its diameter is 0.", i + 1));
      continue;
    }
    add_land(deck, *cage, i, factor, pane);
    if (cage->lands[i].guide == GuideLand::Guide::None)
      out.remarks.push_back(fmt::format("Land {} has no guiding race (iCageGuide = 0).", i + 1));
    if (cage->lands[i].clearance < 0.0)
      out.remarks.push_back(fmt::format("Land {} overlaps its race.", i + 1));
  }
  pane.shapes.push_back(shape_of(Part::Construction, Shape::Style::Dashed, "mid-plane of the cage",
                                 {{0.0, -1.1 * thick}, {0.0, 1.1 * thick}}, {}));
  out.panes.push_back(std::move(pane));
  add_round_lands(deck, *cage, out);
  return out;
}

}  // namespace adore::drawing
