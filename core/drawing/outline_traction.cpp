#include "drawing/outline_parts.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

/// The traction curves of a deck, each by the law that a run uses.
namespace adore::drawing {
namespace {

using deck::Deck;

struct Pair {
  const char* stem;
  const char* type;
  const char* name;
};
constexpr std::array<Pair, 5> kPairs = {{{"reRaceTC", "kTracType", "element and race"},
                                         {"reFlngTC", "kRFTracType", "roller and flange"},
                                         {"reCageTC", "kCPTracType", "element and cage"},
                                         {"cageRaceTC", "kCRTracType", "cage and race"},
                                         {"reReTC", "kRRTracType", "element and element"}}};

struct Curve {
  const Pair* pair = nullptr;
  int type = 0;
  std::array<double, 4> tc{};
  bearing::TractionCurve law;
};

/// Slip over which the law shows what it does [m/s].
double range_of(const Curve& c) {
  using Form = bearing::TractionCurve::Form;
  if (c.type == 1) return 4.0 * c.tc[3];
  if (c.law.form == Form::TwoSlope) return c.law.u0 > 0.0 ? 2.5 * c.law.u0 : 0.0;
  return c.law.C > 0.0 ? 5.0 / c.law.C : 0.0;
}

void measure(const Deck& deck, const Curve& c, double range, Pane& pane) {
  const std::string stem = c.pair->stem;
  const auto at = [&](double u) { return Point{u, tribology::traction_coefficient(c.law, u)}; };
  DimensionCollector put(deck, pane);
  const Point start = at(0.0), far = at(range);
  const double height = std::max(at(0.2 * range).y, at(range).y);
  put.leader(stem + "1", {0.22 * range, start.y + 0.12 * height}, start);
  const auto tangent = [&](const char* name, double from) {
    const double slope = tribology::traction_slope(c.law, from * 1.000001);
    const double rise = 0.9 * height;
    const double to = from + (slope > 0.0 ? std::min(0.15 * range, rise / slope) : 0.15 * range);
    const Point a = at(from), b{to, a.y + slope * (to - from)};
    put.between(name, a, b);
  };
  switch (c.type) {
    case 0: {
      const double u0 = c.law.u0;
      put.between(stem + "2", start, at(u0));
      put.between(stem + "3", at(u0), far);
      put.horizontal(stem + "4", 0.0, u0, 0.0, {0.0, 0.0}, at(u0));
      break;
    }
    case 1: {
      const Point top = at(c.tc[3]);
      put.vertical(stem + "2", 0.0, top.y, top.x, {top.x, 0.0}, top);
      put.leader(stem + "3", {0.8 * range, 0.6 * c.tc[2]}, {0.97 * range, c.tc[2]});
      put.horizontal(stem + "4", 0.0, top.x, 0.25 * top.y, {0.0, 0.0}, top);
      break;
    }
    case 2:
      put.leader(stem + "2", {0.8 * range, 0.6 * c.tc[1]}, {0.97 * range, c.tc[1]});
      tangent((stem + "3").c_str(), 0.0);
      break;
    default:
      put.leader(stem + "2", {0.3 * range, at(0.06 * range).y}, at(0.06 * range));
      put.leader(stem + "3", {0.5 * range, at(0.3 * range).y}, at(0.3 * range));
      put.leader(stem + "4", {0.8 * range, 0.6 * far.y}, {0.97 * range, far.y});
  }
}

}  // namespace

Drawing draw_traction(const Deck& deck) {
  Drawing out;
  std::vector<Curve> curves;
  std::string refused;
  for (const Pair& pair : kPairs) {
    const std::string stem = pair.stem;
    if (!deck.has(stem + "1")) continue;
    Curve c;
    c.pair = &pair;
    c.type = static_cast<int>(deck.integer(pair.type));
    for (std::size_t k = 0; k < 4; ++k)
      c.tc[k] = value_or_zero(deck, fmt::format("{}{}", stem, k + 1));
    try {
      c.law = tribology::traction_curve(c.type, c.tc);
      curves.push_back(c);
    } catch (const InputError& error) {
      refused += fmt::format("{}The traction curve for {} cannot be drawn: {}.",
                             refused.empty() ? "" : " ", pair.name, error.what());
    }
  }
  if (curves.empty())
    throw InputError(refused.empty() ? "The deck does not have a traction record yet." : refused);
  if (!refused.empty()) out.remarks.push_back(refused);
  double range = 0.0, top = 0.0, low = 0.0;
  for (const Curve& c : curves) range = std::max(range, range_of(c));
  if (!(range > 0.0)) range = 1.0;
  range = std::min(range, tribology::kLargestSlip);
  constexpr int kParts = 240;
  Pane pane;
  pane.title = "Traction coefficient versus slip speed";
  for (const Curve& c : curves) {
    Shape shape;
    shape.part = Part::Curve;
    shape.style = Shape::Style::Line;
    shape.name = c.pair->name;
    Path path;
    for (int i = 0; i <= kParts; ++i) {
      const double t = static_cast<double>(i) / kParts;
      const double u = range * t * t;  // denser where the law starts
      path.push_back({u, tribology::traction_coefficient(c.law, u)});
      top = std::max(top, path.back().y);
      low = std::min(low, path.back().y);
    }
    shape.paths.push_back(std::move(path));
    for (int k = 1; k <= 4; ++k) shape.shows.push_back(fmt::format("{}{}", c.pair->stem, k));
    shape.shows.emplace_back(c.pair->type);
    pane.shapes.push_back(std::move(shape));
    measure(deck, c, range, pane);
  }
  if (!(top > low)) {
    top = 0.1;
    out.remarks.emplace_back("All traction coefficients of this deck are zero.");
  }
  const bool english = deck.units() == deck::UnitSystem::English;
  pane.axes = {{"slip speed", english ? "in/s" : "m/s", english ? 0.0254 : 1.0, 0.0, range},
               {"traction coefficient", "", 1.0, low, 1.12 * top}};
  if (deck.integer("kTrac") > 0)
    out.remarks.emplace_back(
        "This traction curve applies only to contacts with a film thinner than reRaceFilm "
        "(critical film thickness). All "
        "other contacts use the lubricant model of kTrac.");
  out.panes.push_back(std::move(pane));
  return out;
}

}  // namespace adore::drawing
