#include "drawing/outline_parts.hpp"

#include <algorithm>
#include <cmath>

namespace adore::drawing {
namespace {

using bearing::PocketShape;

constexpr int kRacewayParts = 48;
constexpr double kSmallestPocket = 0.05;  // of the element diameter: what is still drawn

/// A raceway with its limits to both sides, from -x to +x.
struct Raceway {
  Path points;
  double left = 0.0, right = 0.0;  ///< position of the ring's faces
};

/// Groove of a ball bearing between the shoulders; a split ring has two arcs with their own
/// centers.
Raceway ball_raceway(const OutlineModel& m, int race) {
  const auto j = static_cast<std::size_t>(race);
  const double sigma = race == 0 ? 1.0 : -1.0;
  const double half = 0.5 * m.ring_width[j];
  const double radius = m.groove.groove_radius[j], centre_r = m.groove.centre_radius[j];
  const double shim = m.balls->shim[j];
  // The arc that the ball touches is the one that contact geometry knows; its split plane and the
  // other arc lie one half and one whole shim further.
  const double touched = m.groove.centre_x[j], split = touched + sigma * 0.5 * shim,
               other = touched + sigma * shim;
  const double left_centre = race == 0 ? other : touched,
               right_centre = race == 0 ? touched : other;
  const double bottom = m.raceway(race);
  double shoulder = 0.5 * m.balls->shoulder_diameter[j];
  const double fallback = m.pitch_radius() + sigma * 0.3 * m.diameter;
  if (!(shoulder > 0.0) || sigma * (bottom - shoulder) <= 0.0 ||
      sigma * (shoulder - centre_r) < 0.0)
    shoulder = fallback;
  const double depth = std::clamp(sigma * (shoulder - centre_r) / radius, -0.999, 0.999);
  const double reach = radius * std::sqrt(1.0 - depth * depth);
  Raceway out{{}, -half, half};
  const double first = std::max(left_centre - reach, -half),
               last = std::min(right_centre + reach, half);
  if (left_centre - reach > -half) out.points.push_back({-half, shoulder});
  for (int i = 0; i <= kRacewayParts; ++i) {
    const double x = first + (last - first) * i / kRacewayParts;
    const double from = x - (x < split ? left_centre : right_centre);
    out.points.push_back(
        {x, centre_r + sigma * std::sqrt(std::max(radius * radius - from * from, 0.0))});
  }
  if (right_centre + reach < half) out.points.push_back({half, shoulder});
  return out;
}

/// Radius of a roller's raceway at x, inside what the ring has.
double roller_raceway(const OutlineModel& m, int race, double x) {
  const contact::RaceSurface& surface = m.races[static_cast<std::size_t>(race)];
  double r = 0.0;
  if (surface.shape == contact::RaceSurface::Shape::Cone) {
    r = surface.radius - x * surface.sin_angle / surface.cos_angle;
  } else {
    const double from = std::clamp(x - surface.groove_x, -0.999 * surface.groove_radius,
                                   0.999 * surface.groove_radius);
    r = surface.groove_centre_radius +
        surface.sigma() * std::sqrt(surface.groove_radius * surface.groove_radius - from * from);
  }
  const double skin = 0.02 * m.diameter;
  return race == 0 ? std::min(r, m.ring_radius[0] - skin) : std::max(r, m.ring_radius[1] + skin);
}

Raceway roller_raceway(const OutlineModel& m, int race) {
  const double half = 0.5 * m.ring_width[static_cast<std::size_t>(race)];
  Raceway out{{}, -half, half};
  double first = -half, last = half;
  Path left_flange, right_flange;
  for (const statics::FlangeEndPair& pair : m.flanges) {
    if (pair.race != race) continue;
    const contact::FlangeFace& f = pair.face;
    const Point root{f.root_x, f.root_r};
    const Point lip{f.root_x + f.reach * f.t_x, f.root_r + f.reach * f.t_r};
    const double thickness = 0.1 * m.diameter;
    if (pair.side == 0) {
      out.left = std::min(out.left, std::min(root.x, lip.x) - thickness);
      first = root.x;
      left_flange = {{out.left, lip.y}, lip, root};
    } else {
      out.right = std::max(out.right, std::max(root.x, lip.x) + thickness);
      last = root.x;
      right_flange = {root, lip, {out.right, lip.y}};
    }
  }
  append(out.points, left_flange);
  for (int i = 0; i <= kRacewayParts; ++i) {
    const double x = first + (last - first) * i / kRacewayParts;
    out.points.push_back({x, roller_raceway(m, race, x)});
  }
  append(out.points, right_flange);
  return out;
}

/// Half sizes of a pocket in the deck; too small a clearance makes them meaningless.
double axial_half(const OutlineModel& m, double z) {
  const OutlineCage& cage = *m.cage;
  const double radius = 0.5 * (m.diameter + cage.pocket_clearance_1);
  if (m.rollers) return 0.5 * m.length;
  switch (cage.pocket) {
    case PocketShape::Spherical:
      return std::sqrt(std::max(radius * radius - z * z, 0.0));
    case PocketShape::Rectangular:
      return 0.5 * (m.diameter + cage.pocket_clearance_2);
    case PocketShape::Conical: {
      const double low = 0.5 * (cage.inner_diameter - m.pitch),
                   high = 0.5 * (cage.outer_diameter - m.pitch);
      const double t = (z - low) / (high - low);
      return 0.5 * (m.diameter + cage.pocket_clearance_1 +
                    t * (cage.pocket_clearance_2 - cage.pocket_clearance_1));
    }
    default:
      return radius;
  }
}

double around_half(const OutlineModel& m, double z) {
  const OutlineCage& cage = *m.cage;
  if (m.rollers) {
    const double radius = 0.5 * (m.diameter + cage.pocket_clearance_1);
    if (cage.pocket == PocketShape::Cylindrical)
      return std::sqrt(std::max(radius * radius - z * z, 0.0));
    return radius;
  }
  if (cage.pocket == PocketShape::Elongated)
    return 0.5 * (m.diameter + cage.pocket_clearance_1) +
           0.5 * std::max(cage.pocket_clearance_2, 0.0);
  if (cage.pocket == PocketShape::Rectangular) return 0.5 * (m.diameter + cage.pocket_clearance_1);
  return axial_half(m, z);
}

}  // namespace

Shape shape_of(Part part, Shape::Style style, std::string name, Path path,
               std::vector<std::string> shows) {
  Shape shape;
  shape.part = part;
  shape.style = style;
  shape.name = std::move(name);
  shape.paths.push_back(std::move(path));
  shape.shows = std::move(shows);
  return shape;
}

Path arc(Point centre, double radius, double from, double to, int parts) {
  Path out;
  out.reserve(static_cast<std::size_t>(parts) + 1);
  for (int i = 0; i <= parts; ++i) {
    const double a = from + (to - from) * i / parts;
    out.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
  }
  return out;
}

void append(Path& path, const Path& more) { path.insert(path.end(), more.begin(), more.end()); }

Path rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Point point_at_azimuth(double radius, double azimuth) {
  return {-radius * std::sin(azimuth), radius * std::cos(azimuth)};
}

Shape ring_section(const OutlineModel& m, int race) {
  const auto j = static_cast<std::size_t>(race);
  Raceway way = m.balls ? ball_raceway(m, race) : roller_raceway(m, race);
  Shape ring;
  ring.part = race == 0 ? Part::OuterRing : Part::InnerRing;
  ring.style = Shape::Style::Cut;
  ring.name = race == 0 ? "outer ring" : "inner ring";
  Path path = way.points;
  path.push_back({way.right, m.ring_radius[j]});
  path.push_back({way.left, m.ring_radius[j]});
  ring.paths.push_back(std::move(path));
  return ring;
}

Path roller_outline(const contact::RollerProfile& p) {
  // From the middle of end 1 over its corner, along the upper side, to the middle of end 2.
  const contact::RollerEnd one = contact::roller_end(p, 0), two = contact::roller_end(p, 1);
  const auto end = [](const contact::RollerEnd& e) {  // from the axis to the side
    Path path;
    double cap_angle = 0.0;  // of the normal from the axis where the face passes into the corner
    if (e.flat()) {
      path.push_back({e.sign * e.vertex, 0.0});
      path.push_back({e.sign * e.vertex, e.cap_radius});
    } else {
      cap_angle = std::asin(std::clamp(e.cap_radius / e.end_radius, -1.0, 1.0));
      for (int i = 0; i <= 12; ++i) {
        const double a = cap_angle * i / 12;
        path.push_back(
            {e.sign * (e.dome_centre + e.end_radius * std::cos(a)), e.end_radius * std::sin(a)});
      }
    }
    if (e.corner_radius > 0.0)
      for (int i = 1; i <= 8; ++i) {
        const double a = cap_angle + (e.side_angle - cap_angle) * i / 8;
        path.push_back({e.sign * (e.ring + e.corner_radius * std::cos(a)),
                        e.ring_radius + e.corner_radius * std::sin(a)});
      }
    return path;
  };
  Path upper = end(one);
  const double from = -one.side_v, to = two.side_v;
  constexpr int kSide = 40;
  for (int i = 0; i <= kSide; ++i) {
    const double s = from + (to - from) * i / kSide;
    upper.push_back({s, contact::roller_radius(p, s)});
  }
  Path right = end(two);
  std::reverse(right.begin(), right.end());
  append(upper, right);
  Path out = upper;
  for (auto point = upper.rbegin(); point != upper.rend(); ++point)
    out.push_back({point->x, -point->y});
  return out;
}

Shape element_section(const OutlineModel& m) {
  Shape shape;
  shape.part = Part::Element;
  shape.style = Shape::Style::Body;
  if (m.balls) {
    shape.name = "ball";
    shape.circles.push_back({{0.0, m.pitch_radius()}, 0.5 * m.diameter});
    return shape;
  }
  shape.name = "roller";
  Path path = roller_outline(m.profile);
  const double c = std::cos(m.angle), s = std::sin(m.angle);
  for (Point& p : path) p = {p.x * c + p.y * s, m.pitch_radius() - p.x * s + p.y * c};
  shape.paths.push_back(std::move(path));
  return shape;
}

double pocket_half_axial(const OutlineModel& m, double z) {
  return std::max(axial_half(m, z), kSmallestPocket * m.diameter);
}

double pocket_half_circumferential(const OutlineModel& m, double z) {
  return std::max(around_half(m, z), kSmallestPocket * m.diameter);
}

std::vector<Shape> cage_section(const OutlineModel& m) {
  std::vector<Shape> out;
  if (!m.cage) return out;
  const OutlineCage& cage = *m.cage;
  const double half = 0.5 * cage.width;
  Shape far;
  far.part = Part::Cage;
  far.style = Shape::Style::Behind;
  far.name = "cage bar behind the element";
  far.paths.push_back({{-half, cage.inner_radius(-half)},
                       {half, cage.inner_radius(half)},
                       {half, cage.outer_radius(half)},
                       {-half, cage.outer_radius(-half)}});
  out.push_back(far);
  Shape rails;
  rails.part = Part::Cage;
  rails.style = Shape::Style::Cut;
  rails.name = "cage";
  rails.shows = {"cageDia1", "cageDia2", "cageWidth", "cageConeAng"};
  for (const double side : {-1.0, 1.0}) {
    Path path{{side * half, cage.inner_radius(side * half)},
              {side * half, cage.outer_radius(side * half)}};
    constexpr int kWall = 16;
    double largest = 0.0;
    for (int i = 0; i <= kWall; ++i) {
      const double t = 1.0 - static_cast<double>(i) / kWall;  // from outside to inside
      const double z = 0.5 * (cage.inner_diameter - m.pitch) +
                       0.5 * t * (cage.outer_diameter - cage.inner_diameter);
      const double x = side * std::min(pocket_half_axial(m, z), half);
      largest = std::max(largest, std::abs(x));
      path.push_back({x, m.pitch_radius() + z - x * std::tan(cage.cone_angle)});
    }
    if (largest < half) rails.paths.push_back(std::move(path));
  }
  if (!rails.paths.empty()) out.push_back(std::move(rails));
  return out;
}

void DimensionCollector::add(Dimension d, std::string_view variable, int instance, int index) {
  d.variable = variable;
  d.instance = instance;
  d.index = index;
  d.label = label_of(deck_, variable, instance, index);
  pane_.dimensions.push_back(std::move(d));
}

void DimensionCollector::horizontal(std::string_view variable, double x1, double x2, double y,
                                    Point edge1, Point edge2, int instance, int index) {
  Dimension d;
  d.from = {x1, y};
  d.to = {x2, y};
  d.from_edge = edge1;
  d.to_edge = edge2;
  add(std::move(d), variable, instance, index);
}

void DimensionCollector::vertical(std::string_view variable, double y1, double y2, double x,
                                  Point edge1, Point edge2, int instance, int index) {
  Dimension d;
  d.from = {x, y1};
  d.to = {x, y2};
  d.from_edge = edge1;
  d.to_edge = edge2;
  add(std::move(d), variable, instance, index);
}

void DimensionCollector::half_diameter(std::string_view variable, double radius, double x,
                                       double body) {
  Dimension d;
  d.from = {x, 0.0};
  d.to = {x, radius};
  d.from_edge = {body, 0.0};
  d.to_edge = {body, radius};
  d.half = true;
  add(std::move(d), variable, 1, 1);
}

void DimensionCollector::between(std::string_view variable, Point from, Point to, int instance,
                                 int index) {
  Dimension d;
  d.from = d.from_edge = from;
  d.to = d.to_edge = to;
  add(std::move(d), variable, instance, index);
}

void DimensionCollector::radius(std::string_view variable, Point centre, Point on_arc) {
  leader(variable, centre, on_arc);
  pane_.dimensions.back().kind = Dimension::Kind::Radius;
}

void DimensionCollector::leader(std::string_view variable, Point from, Point to, int instance,
                                int index) {
  Dimension d;
  d.kind = Dimension::Kind::Leader;
  d.from = d.from_edge = from;
  d.to = d.to_edge = to;
  add(std::move(d), variable, instance, index);
}

void DimensionCollector::note(std::string_view variable, Point from, Point to, int instance,
                              int index) {
  leader(variable, from, to, instance, index);
  pane_.dimensions.back().minor = true;
}

void DimensionCollector::angle(std::string_view variable, Point centre, Point from, Point to,
                               int instance, int index) {
  Dimension d;
  d.kind = Dimension::Kind::Angle;
  d.centre = centre;
  d.from = d.from_edge = from;
  d.to = d.to_edge = to;
  add(std::move(d), variable, instance, index);
}

}  // namespace adore::drawing
