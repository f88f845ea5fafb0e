#include "drawing/outline_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// The meridian half section, and the flanges as a closer look at it.
namespace adore::drawing {
namespace {

using deck::Deck;

Point offset(Point p, double x, double y) { return {p.x + x, p.y + y}; }

/// Reach of the drawing to both sides of the ball plane.
double reach_of(const OutlineModel& m) {
  return 0.62 *
         std::max({m.ring_width[0], m.ring_width[1], m.length, m.cage ? m.cage->width : 0.0});
}

/// Direction from an element's center to its contact with a race.
Point contact_direction(const OutlineModel& m, int race) {
  const double sigma = race == 0 ? 1.0 : -1.0;
  return {sigma * std::sin(m.angle), sigma * std::cos(m.angle)};
}

Point contact_point(const OutlineModel& m, int race) {
  const Point d = contact_direction(m, race);
  return {0.5 * m.diameter * d.x, m.pitch_radius() + 0.5 * m.diameter * d.y};
}

/// Direction of a raceway's generator towards +x.
Point along_raceway(const OutlineModel& m, int race) {
  const double a = m.rollers->race_angle[static_cast<std::size_t>(race)];
  return {std::cos(a), -std::sin(a)};
}

void add_land_lines(const OutlineModel& m, Pane& pane) {
  if (!m.cage) return;
  for (const bearing::GuideLand& land : m.cage->lands) {
    if (!(land.diameter > 0.0) || !(land.width > 0.0) ||
        land.guide == bearing::GuideLand::Guide::None)
      continue;
    const bool outer = land.guide == bearing::GuideLand::Guide::Outer;
    const double inside = land.edge - std::copysign(land.width, land.edge);
    const double r = 0.5 * land.diameter;
    const double race_r = r + (outer ? 0.5 : -0.5) * land.clearance;
    pane.shapes.push_back(shape_of(Part::Cage, Shape::Style::Strong, "guide land of the cage",
                                   {{land.edge, r}, {inside, r}},
                                   {"cageGsDia", "cageGsWidth", "cageGsPos", "iCageGuide", "nGL"}));
    pane.shapes.push_back(shape_of(
        outer ? Part::OuterRing : Part::InnerRing, Shape::Style::Strong, "guide land of the race",
        {{land.edge, race_r}, {inside, race_r}}, {"cageGsCls", "iCageGuide"}));
  }
}

void add_bodies(const OutlineModel& m, Pane& pane) {
  const double reach = reach_of(m);
  if (m.ring_radius[1] > 0.0)
    pane.shapes.push_back(shape_of(Part::Shaft, Shape::Style::Cut, "shaft",
                                   rectangle(-reach, m.shaft_bore, reach, m.ring_radius[1]),
                                   {"shftID"}));
  if (m.housing > 0.0)
    pane.shapes.push_back(shape_of(Part::Housing, Shape::Style::Cut, "housing",
                                   rectangle(-reach, m.ring_radius[0], reach, m.housing),
                                   {"hsngOD"}));
  for (const int race : {0, 1}) pane.shapes.push_back(ring_section(m, race));
  std::vector<Shape> cage = cage_section(m);
  if (!cage.empty()) pane.shapes.push_back(cage.front());  // behind the element
  pane.shapes.push_back(element_section(m));
  if (cage.size() > 1) pane.shapes.push_back(cage.back());
  add_land_lines(m, pane);
  pane.shapes.push_back(shape_of(Part::Construction, Shape::Style::Dashed, "bearing axis",
                                 {{-reach, 0.0}, {reach, 0.0}}));
}

/// Line through both contacts, or across the roller; and the axis of a roller.
void add_contact_line(const OutlineModel& m, Pane& pane) {
  const Point centre{0.0, m.pitch_radius()};
  const Point d = contact_direction(m, 0);
  const double l = 0.68 * m.diameter;
  pane.shapes.push_back(
      shape_of(Part::Construction, Shape::Style::Dashed, "contact line",
               {offset(centre, -l * d.x, -l * d.y), offset(centre, l * d.x, l * d.y)},
               {"freeConAng", "freeIntCls"}));
  if (!m.rollers) return;
  const double a = 0.62 * m.length;
  pane.shapes.push_back(
      shape_of(Part::Construction, Shape::Style::Dashed, "roller axis",
               {offset(centre, -a * d.y, a * d.x), offset(centre, a * d.y, -a * d.x)}));
}

void measure_envelope(const OutlineModel& m, DimensionCollector& put, double reach, double step) {
  const double bore = m.ring_radius[1], outside = m.ring_radius[0];
  put.half_diameter("brgBore", bore, -reach - step, -reach);
  put.half_diameter("brgOD", outside, reach + step, reach);
  put.half_diameter("hsngOD", m.housing, reach + 2.0 * step, reach);
  put.half_diameter("shftID", m.shaft_bore, -reach - 2.0 * step, -reach);
  const double top = std::max(m.housing, outside);
  const double w1 = 0.5 * m.ring_width[0], w2 = 0.5 * m.ring_width[1];
  put.horizontal("raceWidth1", -w1, w1, top + step, {-w1, outside}, {w1, outside});
  put.horizontal("raceWidth2", -w2, w2, bore - step, {-w2, bore}, {w2, bore});
  put.leader("raceFit1", {0.5 * w1, outside + 1.5 * step}, {0.5 * w1, outside});
  put.leader("raceFit2", {0.5 * w2, bore - 1.5 * step}, {0.5 * w2, bore});
}

void measure_balls(const OutlineModel& m, DimensionCollector& put, double reach, double step) {
  const Point centre{0.0, m.pitch_radius()};
  const double r = 0.5 * m.diameter;
  put.horizontal("bReDia", -r, r, centre.y, {-r, centre.y}, {r, centre.y});
  const Point d = contact_direction(m, 0);
  const double l = 0.62 * m.diameter;
  put.angle("freeConAng", centre, offset(centre, 0.0, l), offset(centre, l * d.x, l * d.y));
  const Point outer = contact_point(m, 0), inner = contact_point(m, 1);
  put.leader("freeIntCls", offset(outer, 0.35 * reach, 2.0 * step), outer);
  for (const int race : {0, 1}) {
    const auto j = static_cast<std::size_t>(race);
    const std::string code = race == 0 ? "1" : "2";
    const double sigma = race == 0 ? 1.0 : -1.0;
    const double radius = m.groove.groove_radius[j];
    const Point from{m.groove.centre_x[j], m.groove.centre_radius[j]};
    const double side = race == 0 ? -0.6 : 0.6;  // away from the contact
    put.radius("raceCurFac" + code, from, {from.x + radius * side, from.y + sigma * radius * 0.8});
    const double shoulder = 0.5 * m.balls->shoulder_diameter[j];
    const double w = 0.5 * m.ring_width[j];
    put.half_diameter("shoulderDia" + code, shoulder, reach + step * (race + 1.0), w);
    const double split = m.groove.centre_x[j] + sigma * 0.5 * m.balls->shim[j];
    const double bottom = m.raceway(race);
    put.note("shimThickness" + code, {split, bottom + sigma * 2.0 * step}, {split, bottom});
    const Point at = race == 0 ? outer : inner;
    put.note("rmsAspHt" + code,
             offset(at, sigma * 2.0 * step * (d.x + 0.6), sigma * 2.0 * step * d.y), at);
  }
}

void measure_rollers(const OutlineModel& m, DimensionCollector& put, double step) {
  const Point centre{0.0, m.pitch_radius()};
  const Point across = contact_direction(m, 0), axis{across.y, -across.x};
  const double r = 0.5 * m.diameter, half = 0.5 * m.length;
  put.between("bReDia", offset(centre, -r * across.x, -r * across.y),
              offset(centre, r * across.x, r * across.y));
  put.between("bReLen", offset(centre, -half * axis.x, -half * axis.y),
              offset(centre, half * axis.x, half * axis.y));
  put.angle("freeConAng", centre, offset(centre, 0.0, 0.8 * m.diameter),
            offset(centre, 0.8 * m.diameter * across.x, 0.8 * m.diameter * across.y));
  const Point outer = contact_point(m, 0);
  put.leader("freeIntCls", offset(outer, 0.3 * m.length, 2.0 * step), outer);
  for (const int race : {0, 1}) {
    const std::string code = race == 0 ? "1" : "2";
    const double sigma = race == 0 ? 1.0 : -1.0;
    const Point g = along_raceway(m, race);
    const Point mid{m.races[static_cast<std::size_t>(race)].mid_x, m.raceway(race)};
    const Point into{sigma * step * -g.y, sigma * step * g.x};  // normal, into the race
    const double land = 0.5 * m.rollers->land_width[static_cast<std::size_t>(race)];
    const Point p = offset(mid, into.x, into.y);
    put.between("raceLandLmt" + code, offset(p, -land * g.x, -land * g.y),
                offset(p, land * g.x, land * g.y));
    for (const char* stem : {"raceCenLen", "raceCrn", "raceCurFac", "rmsAspHt"})
      put.note(stem + code, offset(mid, 0.25 * m.length, 2.5 * into.y), mid);
    const double l = 0.5 * m.length;
    const Point end = offset(mid, l * g.x, l * g.y);
    put.angle("raceTaper" + code, end, offset(end, -1.6 * l, 0.0),
              offset(end, -1.6 * l * g.x, -1.6 * l * g.y));
  }
}

void measure_cage(const Deck& deck, const OutlineModel& m, DimensionCollector& put, double reach,
                  double step) {
  if (!m.cage) return;
  const OutlineCage& cage = *m.cage;
  const double half = 0.5 * cage.width;
  put.half_diameter("cageDia1", 0.5 * cage.outer_diameter, -reach - step, -half);
  put.half_diameter("cageDia2", 0.5 * cage.inner_diameter, -reach - 2.0 * step, -half);
  const double y = m.ring_radius[0] + step;
  put.horizontal("cageWidth", -half, half, y, {-half, cage.outer_radius(-half)},
                 {half, cage.outer_radius(half)});
  const double x = 0.9 * half;
  const double top = cage.outer_radius(x), low = cage.inner_radius(x);
  const double c1 = value_or_zero(deck, "cageCls1"), c2 = value_or_zero(deck, "cageCls2");
  put.vertical("cageCls1", top, top + 0.5 * c1, x, {x, top}, {x, top + 0.5 * c1});
  put.vertical("cageCls2", low - 0.5 * c2, low, x, {x, low - 0.5 * c2}, {x, low});
  const Point end{half, cage.outer_radius(half)};
  put.angle("cageConeAng", end, {end.x - cage.width, end.y}, {-half, cage.outer_radius(-half)});
}

void measure_flange(const OutlineModel& m, const statics::FlangeEndPair& pair,
                    DimensionCollector& put) {
  const auto race = static_cast<std::size_t>(pair.race), side = static_cast<std::size_t>(pair.side);
  const std::string code = fmt::format("{}{}", pair.side + 1, pair.race + 1);
  const contact::FlangeFace& f = pair.face;
  const Point root{f.root_x, f.root_r};
  const double layback = m.rollers->flange[race][side]->layback;
  const double height = f.reach * std::cos(layback);
  // Across the raceway, out of the race: the face turned back by the layback.
  const double c = std::cos(layback), s = std::sin(layback);
  const Point n{c * f.t_x + s * f.m_x, c * f.t_r + s * f.m_r};
  const double away = (pair.side == 0 ? -0.3 : 0.3) * f.reach;
  const Point base = offset(root, away, 0.0);
  put.between("flngHt" + code, base, offset(base, height * n.x, height * n.y));
  const double l = 1.25 * f.reach;
  put.angle("flngAng" + code, root, offset(root, l * n.x, l * n.y),
            offset(root, l * f.t_x, l * f.t_r));
  const Point gap = offset(root, 0.7 * f.reach * f.t_x, 0.7 * f.reach * f.t_r);
  if (m.rollers->flange[race][0] && m.rollers->flange[race][1])
    put.leader(fmt::format("flngCls{}", pair.race + 1),
               offset(gap, -2.5 * away, 0.25 * f.reach * n.y), gap);
}

/// The flange and the roller's corner before it, as large as they go.
Pane flange_pane(const Deck& deck, const OutlineModel& m, const statics::FlangeEndPair& pair) {
  Pane pane;
  pane.title = fmt::format("Flange {}{}: {} race, {} side, to scale", pair.side + 1, pair.race + 1,
                           pair.race == 0 ? "outer" : "inner", pair.side == 0 ? "-x" : "+x");
  add_bodies(m, pane);
  DimensionCollector put(deck, pane);
  measure_flange(m, pair, put);
  const contact::FlangeFace& f = pair.face;
  const double half = 1.1 * f.reach;
  const Point middle{f.root_x + 0.5 * f.reach * f.t_x, f.root_r + 0.5 * f.reach * f.t_r};
  pane.window = {offset(middle, -half, -half), offset(middle, half, half)};
  return pane;
}

}  // namespace

Drawing draw_cross_section(const Deck& deck) {
  const OutlineModel m = outline_model(deck);
  Drawing out;
  Pane pane;
  pane.title = "Section through the bearing, to scale";
  add_bodies(m, pane);
  add_contact_line(m, pane);
  const double reach = reach_of(m);
  const double step = 0.045 * std::max(m.housing, m.ring_radius[0]);
  DimensionCollector put(deck, pane);
  measure_envelope(m, put, reach, step);
  put.half_diameter("pitchDia", m.pitch_radius(), -reach - step, 0.0);
  if (m.balls)
    measure_balls(m, put, reach, step);
  else
    measure_rollers(m, put, step);
  measure_cage(deck, m, put, reach, step);
  if (m.balls) {
    const Point centre{0.0, m.pitch_radius()};
    const double a = value_or_zero(deck, "angVelOrient"), l = 0.7 * m.diameter;
    put.angle("angVelOrient", centre, {l, centre.y}, {l * std::cos(a), centre.y + l * std::sin(a)});
  }
  out.remarks = m.remarks;
  out.panes.push_back(std::move(pane));
  return out;
}

Drawing draw_flanges(const Deck& deck) {
  const OutlineModel m = outline_model(deck);
  if (m.flanges.empty())
    throw InputError(m.rollers && !m.remarks.empty() ? m.remarks.front()
                                                     : "This bearing has no race flanges.");
  Drawing out;
  Pane pane;
  pane.title = "Flanges and roller ends, to scale";
  add_bodies(m, pane);
  add_contact_line(m, pane);
  const double step = 0.06 * m.diameter;
  // Two flanges can be enlarged separately; more are measured in place.
  const bool closer = m.flanges.size() <= 2;
  DimensionCollector put(deck, pane);
  double half = 0.62 * m.length;
  for (const statics::FlangeEndPair& pair : m.flanges) {
    half = std::max(half, std::abs(pair.face.root_x) + 3.0 * step);
    if (!closer) measure_flange(m, pair, put);
  }
  const double height = 0.5 * m.diameter + 0.5 * m.length * std::sin(m.angle) + 5.0 * step;
  pane.window = {{-half, m.pitch_radius() - height}, {half, m.pitch_radius() + height}};
  out.remarks = m.remarks;
  out.panes.push_back(std::move(pane));
  if (closer)
    for (const statics::FlangeEndPair& pair : m.flanges)
      out.panes.push_back(flange_pane(deck, m, pair));
  return out;
}

}  // namespace adore::drawing
