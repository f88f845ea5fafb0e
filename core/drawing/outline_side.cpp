#include "drawing/outline_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

/// The bearing seen along its axis, and the base frame with what acts on the bearing.
namespace adore::drawing {
namespace {

using deck::Deck;

constexpr int kMostElements = 400;  // more would be a black ring

Shape circles(Part part, Shape::Style style, std::string name, std::initializer_list<double> radii,
              std::vector<std::string> shows = {}) {
  Shape shape;
  shape.part = part;
  shape.style = style;
  shape.name = std::move(name);
  for (const double r : radii)
    if (r > 0.0) shape.circles.push_back({{0.0, 0.0}, r});
  shape.shows = std::move(shows);
  return shape;
}

/// Part of the cage between two azimuths at its outer and inner radius.
Path bar(const OutlineCage& cage, std::array<double, 2> outer, std::array<double, 2> inner) {
  constexpr int kParts = 8;
  Path path;
  for (int i = 0; i <= kParts; ++i)
    path.push_back(
        point_at_azimuth(0.5 * cage.outer_diameter, outer[0] + (outer[1] - outer[0]) * i / kParts));
  for (int i = kParts; i >= 0; --i)
    path.push_back(
        point_at_azimuth(0.5 * cage.inner_diameter, inner[0] + (inner[1] - inner[0]) * i / kParts));
  return path;
}

/// Elements at which a segment starts, cut just before them (through the bar).
std::vector<int> cut_bars(const Deck& deck, int segments) {
  std::vector<int> out;
  for (int i = 1; i <= segments && segments > 1; ++i) {
    const auto at = static_cast<int>(deck.integer("lSeg", i));
    if (at > 0) out.push_back(at);
  }
  return out;
}

void add_cage(const Deck& deck, const OutlineModel& m, Drawing& out, Pane& pane) {
  if (!m.cage || m.count < 1 || m.count > kMostElements) return;
  const OutlineCage& cage = *m.cage;
  Shape shape;
  shape.part = Part::Cage;
  shape.style = Shape::Style::Cut;
  shape.name = "cage";
  const double top = 0.5 * (cage.outer_diameter - m.pitch),
               low = 0.5 * (cage.inner_diameter - m.pitch);
  const double half_top = pocket_half_circumferential(m, top),
               half_low = pocket_half_circumferential(m, low);
  const double spacing = kTurn / m.count;
  const std::vector<int> cuts = cut_bars(deck, cage.segments);
  const double at_top = std::asin(std::min(half_top / (0.5 * cage.outer_diameter), 1.0));
  const double at_low = std::asin(std::min(half_low / (0.5 * cage.inner_diameter), 1.0));
  if (2.0 * std::max(at_top, at_low) >= spacing) {
    out.remarks.emplace_back("The cage is not drawn because its pockets overlap.");
    return;
  }
  for (int k = 0; k < m.count; ++k) {
    const double a = k * spacing, b = a + spacing;
    const double middle = 0.5 * (a + b), cut = 0.5 * cage.cut;
    const bool is_cut = cut > 0.0 && std::find(cuts.begin(), cuts.end(), k + 2) != cuts.end();
    const bool first_cut =
        cut > 0.0 && k + 1 == m.count && std::find(cuts.begin(), cuts.end(), 1) != cuts.end();
    if (is_cut || first_cut) {
      if (middle - cut > a + std::max(at_top, at_low)) {
        shape.paths.push_back(bar(cage, {a + at_top, middle - cut}, {a + at_low, middle - cut}));
        shape.paths.push_back(bar(cage, {middle + cut, b - at_top}, {middle + cut, b - at_low}));
      }
    } else {
      shape.paths.push_back(bar(cage, {a + at_top, b - at_top}, {a + at_low, b - at_low}));
    }
  }
  shape.shows = {"cageDia1", "cageDia2", "nCseg", "lSeg", "cageAngCut"};
  pane.shapes.push_back(std::move(shape));
}

void add_elements(const Deck& deck, const OutlineModel& m, Drawing& out, Pane& pane) {
  if (m.count < 1) {
    out.remarks.emplace_back("No elements are drawn because their number nRe is below 1.");
    return;
  }
  const int drawn = std::min(m.count, kMostElements);
  if (drawn < m.count)
    out.remarks.push_back(
        fmt::format("Only the first {1} of {0} elements are drawn.", m.count, drawn));
  std::vector<int> stored;
  for (int i = 1; i <= std::min(static_cast<int>(deck.integer("kNumPltElem")), 1000); ++i)
    stored.push_back(static_cast<int>(deck.integer("kPltElemInd", i)));
  const bool captions = drawn <= 60;
  for (int k = 0; k < drawn; ++k) {
    Shape shape;
    shape.part = Part::Element;
    shape.style = Shape::Style::Body;
    shape.name = fmt::format("element {}", k + 1);
    const Point at = point_at_azimuth(m.pitch_radius(), kTurn * k / m.count);
    shape.circles.push_back({at, 0.5 * m.diameter});
    shape.shows = {"nRe"};
    if (std::find(stored.begin(), stored.end(), k + 1) != stored.end())
      shape.shows.insert(shape.shows.end(), {"kPltElemInd", "kNumPltElem"});
    pane.shapes.push_back(std::move(shape));
    if (captions) pane.captions.push_back({at, std::to_string(k + 1), 0.9 * m.diameter});
  }
}

bool held(const Deck& deck, int direction) {
  return deck.integer(fmt::format("kFS{}", direction)) == 1;
}

/// Loads, displacements, moments and speeds of a deck as arrows. `along` maps a vector of the base
/// frame to the plane of the drawing.
class Actions {
 public:
  using Map = Point (*)(double x, double y, double z);
  Actions(const Deck& deck, Pane& pane, Map map, double size)
      : deck_(deck), pane_(pane), map_(map), size_(size) {}

  /// Straight arrow from the center along an axis (0 x, 1 y, 2 z); its length is the value's share
  /// of `largest`.
  void force(const std::string& variable, int axis, double largest, Arrow::Kind kind, bool rules,
             Point foot = {}) {
    const double value = rules ? value_or_zero(deck_, variable) : 0.0;
    const double share = value == 0.0 || largest == 0.0
                             ? 0.45
                             : std::copysign(std::max(std::abs(value) / largest, 0.25), value);
    std::array<double, 3> tip{};
    tip[static_cast<std::size_t>(axis)] =
        share * (kind == Arrow::Kind::Gravity ? 0.35 : 1.0) * size_;
    add(variable, value, kind,
        {map_(0.0, foot.x, foot.y), map_(tip[0], foot.x + tip[1], foot.y + tip[2])});
  }
  /// Turning arrow about an axis, at a distance along it, in the sense of the right hand.
  void turn(const std::string& variable, int axis, double distance, double radius, Arrow::Kind kind,
            bool rules = true) {
    const double value = rules ? value_or_zero(deck_, variable) : 0.0;
    const double sense = value < 0.0 ? -1.0 : 1.0;
    Path path;
    constexpr int kParts = 28;
    for (int i = 0; i <= kParts; ++i) {
      const double a = sense * (-0.75 * std::numbers::pi + 1.5 * std::numbers::pi * i / kParts);
      const double u = radius * std::cos(a), v = radius * std::sin(a);
      if (axis == 0) path.push_back(map_(distance, -v, u));  // from z, towards -y
      if (axis == 1) path.push_back(map_(u, distance, -v));  // from x, towards -z
      if (axis == 2) path.push_back(map_(u, v, distance));   // from x, towards y
    }
    add(variable, value, kind, std::move(path));
  }

 private:
  void add(const std::string& variable, double value, Arrow::Kind kind, Path path) {
    pane_.arrows.push_back({kind, variable, value, std::move(path), label_of(deck_, variable)});
  }
  const Deck& deck_;
  Pane& pane_;
  Map map_;
  double size_;
};

double largest_of(const Deck& deck, std::initializer_list<const char*> names) {
  double out = 0.0;
  for (const char* name : names) out = std::max(out, std::abs(value_or_zero(deck, name)));
  return out;
}

void add_actions(const Deck& deck, Actions& act, double rim, bool along_axis) {
  constexpr std::array<const char*, 3> kLoads = {"appLoadX", "appLoadY", "appLoadZ"};
  constexpr std::array<const char*, 3> kMoves = {"appDispX", "appDispY", "appDispZ"};
  constexpr std::array<const char*, 3> kGravity = {"gravityVecX", "gravityVecY", "gravityVecZ"};
  double load = 0.0, move = 0.0;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!held(deck, i + 1)) load = std::max(load, std::abs(value_or_zero(deck, kLoads[k])));
    if (held(deck, i + 1)) move = std::max(move, std::abs(value_or_zero(deck, kMoves[k])));
  }
  for (int i = along_axis ? 0 : 1; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    // The one that is a result, or a first guess, shows only while somebody works on it.
    act.force(kMoves[k], i, move, Arrow::Kind::Displacement, held(deck, i + 1));
    act.force(kLoads[k], i, load, Arrow::Kind::Load, !held(deck, i + 1));
    if (deck.has(kGravity[k]))
      act.force(kGravity[k], i, largest_of(deck, {"gravityVecX", "gravityVecY", "gravityVecZ"}),
                Arrow::Kind::Gravity, true, {-1.2 * rim, 1.2 * rim});
  }
  const double r = 0.22 * rim;
  act.turn("appMis12", 1, 0.78 * rim, r, Arrow::Kind::Displacement, held(deck, 4));
  act.turn("appMomY", 1, 0.78 * rim, r, Arrow::Kind::Moment, !held(deck, 4));
  act.turn("appMis11", 1, 1.12 * rim, r, Arrow::Kind::Displacement);
  act.turn("appMis22", 2, 0.78 * rim, r, Arrow::Kind::Displacement, held(deck, 5));
  act.turn("appMomZ", 2, 0.78 * rim, r, Arrow::Kind::Moment, !held(deck, 5));
  act.turn("appMis21", 2, 1.12 * rim, r, Arrow::Kind::Displacement);
}

/// Seen from +X, a little from above and from the side, so that turns about y and z show.
Point seen_from_x(double x, double y, double z) { return {y - 0.22 * x, z - 0.3 * x}; }

/// Base frame with all three axes: x towards the viewer and to the left.
Point seen_askew(double x, double y, double z) {
  return {0.9 * y - 0.66 * x, z - 0.42 * x - 0.14 * y};
}

Path askew_circle(double x, double radius) {
  Path path;
  constexpr int kParts = 96;
  for (int i = 0; i < kParts; ++i) {
    const Point p = point_at_azimuth(radius, kTurn * i / kParts);
    path.push_back(seen_askew(x, p.x, p.y));
  }
  path.push_back(path.front());
  return path;
}

}  // namespace

Drawing draw_side_view(const Deck& deck) {
  const OutlineModel m = outline_model(deck);
  Drawing out;
  Pane pane;
  pane.title = "Side view from +X, to scale";
  const double outside = m.ring_radius[0], bore = m.ring_radius[1];
  if (m.housing > 0.0)
    pane.shapes.push_back(
        circles(Part::Housing, Shape::Style::Cut, "housing", {m.housing, outside}, {"hsngOD"}));
  pane.shapes.push_back(
      circles(Part::Shaft, Shape::Style::Cut, "shaft", {bore, m.shaft_bore}, {"shftID"}));
  pane.shapes.push_back(circles(Part::OuterRing, Shape::Style::Cut, "outer ring",
                                {outside, m.raceway(0)}, {"brgOD", "kRaceGeoImp1"}));
  pane.shapes.push_back(circles(Part::InnerRing, Shape::Style::Cut, "inner ring",
                                {m.raceway(1), bore}, {"brgBore", "kRaceGeoImp2"}));
  add_elements(deck, m, out, pane);
  add_cage(deck, m, out, pane);
  pane.shapes.push_back(circles(Part::Construction, Shape::Style::Dashed, "pitch circle",
                                {m.pitch_radius()}, {"pitchDia"}));
  DimensionCollector put(deck, pane);
  const auto diameter = [&](const char* name, double r, double azimuth) {
    const Point a = point_at_azimuth(r, azimuth);
    put.between(name, {-a.x, -a.y}, a);
  };
  diameter("pitchDia", m.pitch_radius(), 0.9);
  diameter("brgBore", bore, 0.9);
  diameter("brgOD", outside, 0.9);
  if (m.cage) {
    diameter("cageDia1", 0.5 * m.cage->outer_diameter, 2.2);
    diameter("cageDia2", 0.5 * m.cage->inner_diameter, 2.2);
    if (m.cage->cut > 0.0 && m.cage->segments > 1) {
      const double at = kTurn * (std::abs(static_cast<double>(deck.integer("lSeg", 1))) - 1.5) /
                        std::max(m.count, 1);
      put.angle("cageAngCut", {0.0, 0.0},
                point_at_azimuth(0.5 * m.cage->outer_diameter, at - 0.5 * m.cage->cut),
                point_at_azimuth(0.5 * m.cage->outer_diameter, at + 0.5 * m.cage->cut));
    }
  }
  if (m.count > 1) {
    const double r = 0.5 * (m.raceway(0) + outside);
    put.angle("nRe", {0.0, 0.0}, point_at_azimuth(r, kTurn / m.count), point_at_azimuth(r, 0.0));
  }
  Actions act(deck, pane, &seen_from_x, m.pitch_radius());
  add_actions(deck, act, outside, false);
  act.turn("rpm2", 0, 0.0, 0.45 * bore, Arrow::Kind::Speed);
  act.turn("rpm1", 0, 0.0, 0.5 * (outside + m.raceway(0)), Arrow::Kind::Speed);
  out.remarks = [&] {
    std::vector<std::string> all = m.remarks;
    all.insert(all.end(), out.remarks.begin(), out.remarks.end());
    return all;
  }();
  out.panes.push_back(std::move(pane));
  return out;
}

Drawing draw_loads(const Deck& deck) {
  const OutlineModel m = outline_model(deck);
  Drawing out;
  Pane pane;
  pane.title = "Loads on the inner race";
  const double outside = m.ring_radius[0], bore = m.ring_radius[1];
  const auto ring = [&](Part part, const char* name, double r1, double r2,
                        std::vector<std::string> shows) {
    Shape shape;
    shape.part = part;
    shape.style = Shape::Style::Behind;
    shape.name = name;
    shape.paths = {askew_circle(0.0, r1), askew_circle(0.0, r2)};
    shape.shows = std::move(shows);
    pane.shapes.push_back(std::move(shape));
  };
  ring(Part::OuterRing, "outer ring", outside, m.raceway(0), {"rpm1", "appMis11", "appMis21"});
  ring(Part::InnerRing, "inner ring", m.raceway(1), bore,
       {"rpm2", "appMis12", "appMis22", "appMomY", "appMomZ"});
  const double reach = 1.3 * outside;
  constexpr std::array<const char*, 3> kNames = {"X", "Y", "Z"};
  for (int i = 0; i < 3; ++i) {
    std::array<double, 3> tip{};
    tip[static_cast<std::size_t>(i)] = reach;
    Shape axis;
    axis.part = Part::Construction;
    axis.style = Shape::Style::Dashed;
    axis.name = fmt::format("{} axis", kNames[static_cast<std::size_t>(i)]);
    axis.paths = {{seen_askew(0, 0, 0), seen_askew(tip[0], tip[1], tip[2])}};
    pane.shapes.push_back(std::move(axis));
    for (double& t : tip) t *= 1.08;
    pane.captions.push_back(
        {seen_askew(tip[0], tip[1], tip[2]), kNames[static_cast<std::size_t>(i)], 0.0});
  }
  Actions act(deck, pane, &seen_askew, 1.15 * outside);
  add_actions(deck, act, outside, true);
  act.turn("rpm2", 0, 0.0, 0.5 * (bore + m.raceway(1)), Arrow::Kind::Speed);
  act.turn("rpm1", 0, 0.0, 0.5 * (outside + m.raceway(0)), Arrow::Kind::Speed);
  out.remarks = m.remarks;
  for (int i = 0; i < 3; ++i)
    if (held(deck, i + 1))
      out.remarks.push_back(
          fmt::format("kFS{} = 1: the deck specifies the displacement along {}. The force along "
                      "this axis is computed.",
                      i + 1, static_cast<char>('x' + i)));
  out.panes.push_back(std::move(pane));
  return out;
}

}  // namespace adore::drawing
