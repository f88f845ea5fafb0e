#include "drawing/outline_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

/// The rolling element alone, and in its pocket.
namespace adore::drawing {
namespace {

using bearing::PocketShape;
using deck::Deck;

void draw_ball(const Deck& deck, const OutlineModel& m, Pane& pane) {
  pane.title = "Ball between the race grooves, to scale";
  const double r = 0.5 * m.diameter;
  Shape ball;
  ball.part = Part::Element;
  ball.style = Shape::Style::Body;
  ball.name = "ball";
  ball.circles.push_back({{0.0, 0.0}, r});
  DimensionCollector put(deck, pane);
  for (const int race : {0, 1}) {
    const auto j = static_cast<std::size_t>(race);
    const double sigma = race == 0 ? 1.0 : -1.0, groove = m.groove.groove_radius[j];
    const Point centre{m.groove.centre_x[j], m.groove.centre_radius[j] - m.pitch_radius()};
    const double middle = sigma * 0.25 * kTurn;
    Path face = arc(centre, groove, middle - 0.9, middle + 0.9, 48);
    Shape body = shape_of(race == 0 ? Part::OuterRing : Part::InnerRing, Shape::Style::Cut,
                          race == 0 ? "outer groove" : "inner groove", face,
                          {race == 0 ? "raceCurFac1" : "raceCurFac2"});
    const double back = sigma * 1.5 * r;
    body.paths.front().push_back({face.back().x, back});
    body.paths.front().push_back({face.front().x, back});
    pane.shapes.push_back(std::move(body));
    const double a = middle + 0.45 * (race == 0 ? 1.0 : -1.0) * sigma;
    put.radius(race == 0 ? "raceCurFac1" : "raceCurFac2", centre,
               {centre.x + groove * std::cos(a), centre.y + groove * std::sin(a)});
  }
  pane.shapes.push_back(std::move(ball));
  put.horizontal("bReDia", -r, r, 0.0, {-r, 0.0}, {r, 0.0});
  put.note("reDiaVar", {0.5 * r, -0.5 * r}, {0.8 * r, -0.6 * r});
  for (const char* name : {"bReGeoCenX", "bReGeoCenY", "bReGeoCenZ", "bReMass"})
    put.note(name, {0.4 * r, 0.35 * r}, {0.0, 0.0});
}

void draw_roller(const Deck& deck, const OutlineModel& m, Pane& pane) {
  pane.title = "Roller, to scale; -x end on the left";
  const contact::RollerProfile& p = m.profile;
  const double half = 0.5 * p.length, r = 0.5 * p.diameter;
  const double step = 0.08 * p.diameter;
  pane.shapes.push_back(
      shape_of(Part::Element, Shape::Style::Body, "roller", roller_outline(p), {"bReLen"}));
  pane.shapes.push_back(shape_of(Part::Construction, Shape::Style::Dashed, "roller axis",
                                 {{-half - step, 0.0}, {half + step, 0.0}}));
  const auto edge = [&](double s) { return Point{s, contact::roller_radius(p, s)}; };
  const auto surface = [&](double from, double to) {
    Path path;
    for (int i = 0; i <= 24; ++i) path.push_back(edge(from + (to - from) * i / 24));
    return path;
  };
  const double left = -half + p.corner_radius[0], right = half - p.corner_radius[1];
  const double land = 0.5 * std::min(p.central_length, p.length);
  if (p.kind == contact::RollerProfile::Kind::Crowned) {
    if (land > 0.0)
      pane.shapes.push_back(shape_of(Part::Construction, Shape::Style::Strong, "central land",
                                     surface(std::max(-land, left), std::min(land, right)),
                                     {"bReCenLen", "reCLVar", "reCLOffset"}));
    if (land < right)
      for (const double side : {-1.0, 1.0})
        pane.shapes.push_back(shape_of(Part::Element, Shape::Style::Strong, "crown",
                                       side < 0 ? surface(left, -land) : surface(land, right),
                                       {"bReCrn", "reCrnVar"}));
  } else {
    pane.shapes.push_back(shape_of(Part::Element, Shape::Style::Strong, "crown",
                                   surface(left, right), {"bReCrn", "reCrnVar"}));
  }
  DimensionCollector put(deck, pane);
  const double widest = std::max(contact::roller_radius(p, left), r);
  put.vertical("bReDia", -r, r, 0.0, {0.0, -r}, {0.0, r});
  put.horizontal("bReLen", -half, half, -widest - 1.5 * step, {-half, 0.0}, {half, 0.0});
  put.horizontal("bReCenLen", -land, land, widest + 1.5 * step, edge(-land), edge(land));
  const double crown_s = 0.5 * (land + right);
  const Point crown = edge(crown_s);
  put.leader("bReCrn", {crown.x + step, crown.y + 2.5 * step}, crown);
  put.note("reCrnVar", {crown.x + step, crown.y + 2.5 * step}, crown);
  for (const int e : {0, 1}) {
    const contact::RollerEnd end = contact::roller_end(p, e);
    const std::string code = std::to_string(e + 1);
    const double c = 0.7071 * end.corner_radius;
    const Point corner{end.sign * (end.ring + c), end.ring_radius + c};
    put.leader("bReCorRad" + code, {corner.x + end.sign * 2.0 * step, corner.y + 2.0 * step},
               corner);
    put.leader("bReEndRad" + code, {end.sign * (half + 2.5 * step), -0.35 * r},
               {end.sign * half, -0.05 * r});
  }
  for (const char* name : {"reDiaVar", "reLenVar", "reCLVar", "reCLOffset"})
    put.note(name, {-0.4 * half, widest + 2.5 * step}, edge(-0.3 * half));
  for (const char* name : {"bReGeoCenX", "bReGeoCenY", "bReGeoCenZ", "bReMass"})
    put.note(name, {0.3 * half, 0.5 * r}, {0.0, 0.0});
}

/// Depth of the profile below the straight roller, on separate scales.
Pane profile_pane(const Deck& deck, const OutlineModel& m) {
  const contact::RollerProfile& p = m.profile;
  const bool english = deck.units() == deck::UnitSystem::English;
  Pane pane;
  pane.title = "Profile drop of the roller, exaggerated";
  pane.share = 0.75;
  const double half = 0.5 * p.length;
  const double left = -half + p.corner_radius[0], right = half - p.corner_radius[1];
  Path path;
  double deepest = 0.0;
  constexpr int kParts = 120;
  for (int i = 0; i <= kParts; ++i) {
    const double s = left + (right - left) * i / kParts;
    const double drop = contact::profile_drop(p, s);
    deepest = std::max(deepest, drop);
    path.push_back({s, -drop});
  }
  const double low = deepest > 0.0 ? -1.15 * deepest : -1e-6;
  pane.axes = {{"axial position", english ? "in" : "mm", english ? 0.0254 : 1e-3, -half, half},
               {"drop", english ? "10⁻³ in" : "µm", english ? 25.4e-6 : 1e-6, low, -0.25 * low}};
  pane.shapes.push_back(shape_of(Part::Curve, Shape::Style::Line, "profile", std::move(path),
                                 {"bReCrn", "reCrnVar", "bReLen"}));
  DimensionCollector put(deck, pane);
  if (p.kind == contact::RollerProfile::Kind::Crowned && p.central_length > 0.0) {
    const double land = 0.5 * std::min(p.central_length, p.length);
    put.horizontal("bReCenLen", -land, land, -0.1 * low, {-land, 0.0}, {land, 0.0});
  }
  put.leader("bReCrn", {0.2 * right, 0.55 * low},
             {0.85 * right, -contact::profile_drop(p, 0.85 * right)});
  return pane;
}

/// Outline of a pocket seen from outside: circumference to the right, bearing axis upwards.
Shape pocket_hole(const OutlineModel& m, double z, Shape::Style style) {
  Shape hole;
  hole.part = Part::Cage;
  hole.style = style;
  hole.name = "pocket";
  hole.shows = {"kPocType", "bPocCls1", "bPocCls2"};
  const double around = pocket_half_circumferential(m, z), axial = pocket_half_axial(m, z);
  if (m.rollers || m.cage->pocket == PocketShape::Rectangular) {
    Path path = rectangle(-around, -axial, around, axial);
    path.push_back(path.front());
    hole.paths.push_back(std::move(path));
  } else if (m.cage->pocket == PocketShape::Elongated && around > axial) {
    Path path = arc({around - axial, 0.0}, axial, -0.25 * kTurn, 0.25 * kTurn);
    append(path, arc({axial - around, 0.0}, axial, 0.25 * kTurn, 0.75 * kTurn));
    path.push_back(path.front());
    hole.paths.push_back(std::move(path));
  } else {
    hole.circles.push_back({{0.0, 0.0}, axial});
  }
  return hole;
}

Pane pocket_from_outside(const Deck& deck, const OutlineModel& m, Point push) {
  const OutlineCage& cage = *m.cage;
  Pane pane;
  pane.title = "Pocket seen from outside (bearing axis points up), to scale";
  const double top = 0.5 * (cage.outer_diameter - m.pitch),
               low = 0.5 * (cage.inner_diameter - m.pitch);
  const double around =
      std::max(pocket_half_circumferential(m, 0.0), pocket_half_circumferential(m, top));
  const double room = m.count > 1 ? std::numbers::pi * m.pitch / m.count : 2.0 * around;
  const double half = 0.5 * cage.width, wide = std::clamp(room, 1.15 * around, 1.6 * around);
  Shape wall = pocket_hole(m, 0.0, Shape::Style::Cut);
  wall.name = "cage around the pocket";
  wall.shows.clear();
  wall.paths.push_back(rectangle(-wide, -half, wide, half));
  pane.shapes.push_back(std::move(wall));
  if (cage.pocket == PocketShape::Conical || cage.pocket == PocketShape::Spherical)
    for (const double z : {low, top})
      pane.shapes.push_back(pocket_hole(m, z, Shape::Style::Dashed));
  Shape element;
  element.part = Part::Element;
  element.style = Shape::Style::Body;
  if (m.rollers) {
    element.name = "roller";
    Path path = roller_outline(m.profile);
    for (Point& p : path) p = {p.y + push.x, p.x};
    element.paths.push_back(std::move(path));
  } else {
    element.name = "ball";
    element.circles.push_back({push, 0.5 * m.diameter});
  }
  pane.shapes.push_back(std::move(element));
  DimensionCollector put(deck, pane);
  const double r = 0.5 * m.diameter, step = 0.12 * m.diameter;
  const double axial = pocket_half_axial(m, 0.0);
  const double edge = pocket_half_circumferential(m, 0.0);
  put.horizontal("bReDia", push.x - r, push.x + r, 0.0, {push.x - r, 0.0}, {push.x + r, 0.0});
  if (cage.pocket == PocketShape::Elongated) {
    put.vertical("bPocCls1", push.y + r, axial, 0.0, {0.0, push.y + r}, {0.0, axial});
    const double c = 0.5 * cage.pocket_clearance_2;
    put.horizontal("bPocCls2", -c, c, -half - step, {-c, 0.0}, {c, 0.0});
  } else if (cage.pocket == PocketShape::Conical) {
    const double inner = pocket_half_axial(m, low), outer = pocket_half_axial(m, top);
    put.leader("bPocCls1", {0.8 * wide, -half - step}, {0.7071 * inner, -0.7071 * inner});
    put.leader("bPocCls2", {0.8 * wide, half + step}, {0.7071 * outer, 0.7071 * outer});
  } else {
    put.horizontal("bPocCls1", push.x + r, edge, 0.25 * axial, {push.x + r, 0.25 * axial},
                   {edge, 0.25 * axial});
    if (cage.pocket == PocketShape::Rectangular && !m.rollers)
      put.vertical("bPocCls2", push.y + r, axial, 0.0, {0.0, push.y + r}, {0.0, axial});
    else  // it has no meaning for this shape
      put.note("bPocCls2", {0.8 * wide, half + step}, {0.0, axial});
  }
  put.vertical("cageWidth", -half, half, wide + step, {wide, -half}, {wide, half});
  put.note("bPocCenVar1", {-0.5 * wide, half + step}, {0.0, 0.0});
  return pane;
}

Pane pocket_across(const Deck& deck, const OutlineModel& m, Point push) {
  const OutlineCage& cage = *m.cage;
  Pane pane;
  pane.title = "Pocket in the plane normal to the bearing axis";
  pane.share = 0.7;
  const double top = 0.5 * (cage.outer_diameter - m.pitch),
               low = 0.5 * (cage.inner_diameter - m.pitch);
  constexpr int kParts = 20;
  double widest = 0.0;
  for (const double side : {-1.0, 1.0}) {
    Path wall;
    for (int i = 0; i <= kParts; ++i) {
      const double z = low + (top - low) * i / kParts;
      wall.push_back({side * pocket_half_circumferential(m, z), z});
      widest = std::max(widest, std::abs(wall.back().x));
    }
    const double back = side * std::max(1.4 * widest, 0.7 * m.diameter);
    wall.push_back({back, top});
    wall.push_back({back, low});
    pane.shapes.push_back(shape_of(Part::Cage, Shape::Style::Cut, "cage bar", std::move(wall),
                                   {"kPocType", "cageDia1", "cageDia2"}));
  }
  Shape element;
  element.part = Part::Element;
  element.style = Shape::Style::Body;
  element.name = m.rollers ? "roller" : "ball";
  element.circles.push_back({{push.x, 0.0}, 0.5 * m.diameter});
  pane.shapes.push_back(std::move(element));
  pane.shapes.push_back(shape_of(Part::Construction, Shape::Style::Dashed, "pitch circle",
                                 {{-1.4 * widest, 0.0}, {1.4 * widest, 0.0}}));
  DimensionCollector put(deck, pane);
  put.note("bPocThknsVar", {1.2 * widest, top + 0.15 * m.diameter}, {1.2 * widest, top});
  for (const char* name : {"bPocAngVar1", "bPocAngVar2", "bPocAngVar3", "bPocCenVar2"})
    put.note(name, {-0.8 * widest, top + 0.2 * m.diameter}, {0.0, 0.0});
  for (int i = 1; i <= cage.face_pairs; ++i) {
    const auto value = [&](const char* name) { return value_or_zero(deck, name, i); };
    const double angle = value("bPocGsAng1"), half = 0.5 * value("bPocGsLen1");
    const double y = value("bPocGsCen2"), z = value("bPocGsCen3");
    // +y of the pocket is to the left here: y = z × x with x towards the viewer's up.
    for (const double side : {-1.0, 1.0}) {
      const Point mid{side * y, z}, along{side * -std::sin(angle), std::cos(angle)};
      pane.shapes.push_back(shape_of(Part::Construction, Shape::Style::Strong,
                                     fmt::format("guide surface {}", i),
                                     {{mid.x - half * along.x, mid.y - half * along.y},
                                      {mid.x + half * along.x, mid.y + half * along.y}},
                                     {"bPocGsAng1", "bPocGsAng2", "bPocGsAng3", "bPocGsCen1",
                                      "bPocGsCen2", "bPocGsCen3", "bPocGsLen1", "bPocGsLen2"}));
    }
    const Point mid{-y, z};
    const Point along{std::sin(angle), std::cos(angle)};
    put.between("bPocGsLen1", {mid.x - half * along.x, mid.y - half * along.y},
                {mid.x + half * along.x, mid.y + half * along.y}, i);
    put.horizontal("bPocGsCen2", -y, 0.0, z, mid, {0.0, z}, i);
    put.vertical("bPocGsCen3", 0.0, z, -y, {-y, 0.0}, mid, i);
    put.angle("bPocGsAng1", mid, {mid.x, mid.y + half},
              {mid.x + half * along.x, mid.y + half * along.y}, i);
    for (const char* name : {"bPocGsAng2", "bPocGsAng3", "bPocGsCen1", "bPocGsLen2"})
      put.note(name, {mid.x - 0.1 * m.diameter, top + 0.15 * m.diameter}, mid, i);
  }
  return pane;
}

}  // namespace

Drawing draw_element(const Deck& deck) {
  const OutlineModel m = outline_model(deck);
  Drawing out;
  Pane pane;
  if (m.balls) {
    draw_ball(deck, m, pane);
    out.panes.push_back(std::move(pane));
  } else {
    draw_roller(deck, m, pane);
    out.panes.push_back(std::move(pane));
    out.panes.push_back(profile_pane(deck, m));
    if (m.profile.kind == contact::RollerProfile::Kind::Crowned && m.profile.crown_radius > 1e9)
      out.remarks.emplace_back(
          "The roller has no crown, because the crown radius bReCrn is above 1e9 m.");
  }
  return out;
}

Drawing draw_pocket(const Deck& deck) {
  const OutlineModel m = outline_model(deck);
  if (deck.integer("nCseg") < 1) throw InputError("This bearing has no cage (nCseg = 0).");
  if (!m.cage) throw InputError(m.remarks.back());
  Drawing out;
  // The element is at one wall, so that the whole clearance shows at the other.
  const double wall = pocket_half_circumferential(m, 0.0) - 0.5 * m.diameter;
  const Point push{-std::max(wall, 0.0),
                   m.rollers ? 0.0
                             : -std::max(m.cage->pocket == PocketShape::Elongated ||
                                                 m.cage->pocket == PocketShape::Rectangular
                                             ? pocket_half_axial(m, 0.0) - 0.5 * m.diameter
                                             : 0.0,
                                         0.0)};
  if (wall < 0.0)
    out.remarks.emplace_back(
        "The pocket is smaller than the element. Check the pocket clearance bPocCls1.");
  if (m.rollers)
    out.remarks.emplace_back(
        "The deck does not define the axial clearance of roller pockets. The drawn clearance is an "
        "assumption.");
  out.panes.push_back(pocket_from_outside(deck, m, push));
  out.panes.push_back(pocket_across(deck, m, push));
  return out;
}

}  // namespace adore::drawing
