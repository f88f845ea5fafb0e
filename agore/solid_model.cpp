#include "agore/solid_model.hpp"

namespace adore::agore {

using Point = DepthCanvas::Point;

void add_ring(SolidPainter& m, const std::vector<RingRadii>& profile, const Vec3& shift,
              double begin, double end, const Shades& shades) {
  const int parts = std::max(8, static_cast<int>(std::ceil((end - begin) / (2.0 * kPi) * 150.0)));
  const auto place = [&](double x, double r, double azimuth) {
    return Vec3(Vec3(x, 0.0, 0.0) + r * outward_direction(azimuth) + shift);
  };
  for (int i = 0; i < parts; ++i) {
    const double a = begin + (end - begin) * i / parts, b = begin + (end - begin) * (i + 1) / parts;
    for (std::size_t j = 1; j < profile.size(); ++j) {
      const RingRadii &p = profile[j - 1], &q = profile[j];
      const auto surface = [&](double rp, double rq) {
        const double dx = q.x - p.x, dr = rq - rp, size = std::hypot(dx, dr);
        if (!(size > 0.0)) return;
        const auto normal = [&](double azimuth) {
          return Vec3((Vec3(-dr, 0.0, 0.0) + dx * outward_direction(azimuth)) / size);
        };
        m.canvas().quad(m.at(place(p.x, rp, a), normal(a)), m.at(place(q.x, rq, a), normal(a)),
                        m.at(place(q.x, rq, b), normal(b)), m.at(place(p.x, rp, b), normal(b)),
                        shades);
      };
      surface(p.near, q.near);
      surface(p.far, q.far);
    }
    for (const RingRadii& face : {profile.front(), profile.back()})
      m.flat(place(face.x, face.near, a), place(face.x, face.far, a), place(face.x, face.far, b),
             place(face.x, face.near, b), shades);
  }
  if (end - begin > 2.0 * kPi - 1e-9) return;
  for (const double cut : {begin, end})
    for (std::size_t j = 1; j < profile.size(); ++j)
      m.flat(place(profile[j - 1].x, profile[j - 1].near, cut),
             place(profile[j].x, profile[j].near, cut), place(profile[j].x, profile[j].far, cut),
             place(profile[j - 1].x, profile[j - 1].far, cut), shades);
}

void add_land_surface(SolidPainter& m, const LandSection& land, const Vec3& shift,
                      std::pair<double, double> arc, const Shades& shades, double proud) {
  const double way = land.race == 0 ? -1.0 : 1.0, radius = land.on_race + way * proud;
  constexpr int kParts = 150;
  const auto at = [&](double x, int i) {
    const double azimuth = arc.first + (arc.second - arc.first) * i / kParts;
    return m.at(Vec3(Vec3(x, 0.0, 0.0) + radius * outward_direction(azimuth) + shift),
                outward_direction(azimuth));
  };
  for (int i = 0; i < kParts; ++i)
    m.canvas().quad(at(land.low, i), at(land.high, i), at(land.high, i + 1), at(land.low, i + 1),
                    shades);
}

std::vector<RimPoint> pocket_rim(const CageProfile& cage, double pitch_radius,
                                 const PocketMesh& pocket, int arc, int straight) {
  const auto count = static_cast<std::size_t>(2 * (arc + straight));
  std::vector<RimPoint> rim(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    double a = 0.0, b = 0.0;
    auto step = static_cast<int>(i % count);
    if (step < straight) {
      a = 1.0, b = 2.0 * step / straight - 1.0;
    } else if ((step -= straight) < arc) {
      a = 1.0 - 2.0 * step / arc, b = 1.0;
    } else if ((step -= arc) < straight) {
      a = -1.0, b = 1.0 - 2.0 * step / straight;
    } else {
      step -= straight;
      a = 2.0 * step / arc - 1.0, b = -1.0;
    }
    RimPoint& r = rim[i];
    r.edge_angle = a * pocket.half_angle;
    r.edge_u = b * cage.half_width;
    const double size = pocket.round ? std::hypot(a, b) : 1.0;
    r.hole_u = b / size * (cage.hole + cage.leaning[b < 0.0 ? 0 : 1]);
    const double limit = 0.96 * pocket.half_angle * pitch_radius;
    r.hole_angle =
        std::min(limit, pocket.half_round + pocket.taper * r.hole_u) * a / size / pitch_radius;
  }
  return rim;
}

std::vector<CagePocket> cage_pockets(const Animation& animation, double pocket_radius,
                                     CageProfile& profile) {
  const auto n = animation.pocket_angle.size();
  const PocketMesh pocket{kPi / static_cast<double>(std::max<std::size_t>(n, 1)), pocket_radius,
                          animation.file.bearing_type == 1, roller_profile(animation).slope};
  if (pocket.round) profile.hole = std::min(pocket_radius, 0.96 * profile.half_width);
  constexpr double kGap = 0.006;  // between segments [rad]
  std::vector<CagePocket> out;
  for (std::size_t k = 0; k < n; ++k) {
    const int part = animation.pocket_part[k];
    out.push_back({part,
                   animation.pocket_angle[k],
                   pocket,
                   {animation.pocket_part[(k + n - 1) % n] != part,
                    animation.pocket_part[(k + 1) % n] != part}});
    if (out.back().open_end[0] || out.back().open_end[1]) out.back().mesh.half_angle -= kGap;
  }
  return out;
}

Mat3 cage_attitude(const Animation& animation, std::size_t frame, int part, double factor) {
  constexpr double kMost = 0.3;  // of tilts [rad]
  const auto& body = animation.part(frame, part);
  const auto tilt = [&](double angle) {
    return std::clamp(factor * std::remainder(angle, kPi), -kMost, kMost);
  };
  return rotation(
      {animation.cage_part_angle(frame, part), tilt(body.angles[1]), tilt(body.angles[2])});
}

void add_pocket_sector(SolidPainter& m, const CageProfile& cage, double pitch_radius,
                       double azimuth, const PocketMesh& pocket, const Mat3& turn,
                       const Vec3& shift, const std::array<bool, 2>& open_end,
                       const Shades& shades) {
  // Coordinates on the cage: s around it (an angle at the pitch radius), along u, across v.
  const auto place = [&](double angle, double u, double v) {
    const QPointF p = tilted_point(0.0, pitch_radius, cage.lean, u, v);
    return Vec3(turn * Vec3(Vec3(p.x(), 0.0, 0.0) + p.y() * outward_direction(azimuth + angle)) +
                shift);
  };
  const auto across = [&](double angle) {
    return Vec3(turn * Vec3(Vec3(-std::sin(cage.lean), 0.0, 0.0) +
                            std::cos(cage.lean) * outward_direction(azimuth + angle)));
  };
  // Points around a square, including its corners: around the bearing (`along` and back), and
  // straight along it, where only round holes need points.
  constexpr int kMost = 10;
  const int round = 2 * m.parts(pocket.half_round, 1.0);
  const int arc = std::min(
      kMost, std::max(m.parts(pitch_radius, 2.0 * pocket.half_angle), pocket.round ? round : 1));
  const int straight = pocket.round ? arc : 1;
  const auto count = static_cast<std::size_t>(2 * (arc + straight));
  const std::vector<RimPoint> rim = pocket_rim(cage, pitch_radius, pocket, arc, straight);
  // Each point of the mesh once: at the hole and at the edge, below and above.
  struct Corner {
    std::array<Vec3, 2> hole, edge;
    std::array<Point, 2> lit_hole, lit_edge;
  };
  std::array<Corner, 4 * kMost + 1> corner;
  const std::array<double, 2> heights{cage.low, cage.high};
  for (std::size_t i = 0; i <= count; ++i) {
    const RimPoint& r = rim[i];
    Corner& c = corner[i];
    const Vec3 hole_normal = across(r.hole_angle), edge_normal = across(r.edge_angle);
    for (std::size_t v = 0; v < 2; ++v) {
      c.hole[v] = place(r.hole_angle, r.hole_u, heights[v]);
      c.edge[v] = place(r.edge_angle, r.edge_u, heights[v]);
      c.lit_hole[v] = m.at(c.hole[v], hole_normal);
      c.lit_edge[v] = m.at(c.edge[v], edge_normal);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const RimPoint &p = rim[i], &q = rim[i + 1];
    const Corner &c = corner[i], &d = corner[i + 1];
    m.canvas().front_quad(c.lit_hole[0], c.lit_edge[0], d.lit_edge[0], d.lit_hole[0], shades);
    m.canvas().front_quad(d.lit_hole[1], d.lit_edge[1], c.lit_edge[1], c.lit_hole[1], shades);
    m.front_flat(d.hole[0], d.hole[1], c.hole[1], c.hole[0], shades);
    const bool side_face = p.edge_u == q.edge_u;
    const bool left = p.edge_angle < 0.0;
    if (side_face || open_end[left ? 0 : 1])
      m.front_flat(c.edge[0], c.edge[1], d.edge[1], d.edge[0], shades);
  }
}

void add_roller(SolidPainter& m, const RollerProfile& shape, const Vec3& middle, const Vec3& axis,
                const Vec3& first, const Shades& shades, const Shades& mark) {
  const Vec3 second = axis.cross(first);
  constexpr int kSides = 28, kPainted = 2;  // on each side of the mark's middle: 64 degrees
  const int parts = shape.crown > 0.0 ? 10 : 1;
  // Corners are chamfers here.
  std::vector<double> stations;
  if (shape.corner[0] > 0.0) stations.push_back(-shape.half);
  const double first_u = shape.corner[0] - shape.half, last_u = shape.half - shape.corner[1];
  for (int j = 0; j <= parts; ++j) stations.push_back(first_u + (last_u - first_u) * j / parts);
  if (shape.corner[1] > 0.0) stations.push_back(shape.half);
  const auto n = stations.size();
  struct Line {  // along the roller
    std::vector<Point> points;
    Vec3 outward;
  };
  const auto line_at = [&](int i) {
    const double a = 2.0 * kPi * (i - 0.5) / kSides;
    Line out{std::vector<Point>(n), std::cos(a) * first + std::sin(a) * second};
    const float lit = m.light(out.outward);
    for (std::size_t j = 0; j < n; ++j) {
      out.points[j] = m.at(middle + stations[j] * axis + shape.side(stations[j]) * out.outward);
      out.points[j].light = lit;
    }
    return out;
  };
  const std::array<Point, 2> centres{m.at(middle - shape.half * axis, axis),
                                     m.at(middle + shape.half * axis, axis)};
  const auto on_end = [&](Point p, std::size_t end) {
    p.light = centres[end].light;
    return p;
  };
  Line from = line_at(0);
  for (int i = 0; i < kSides; ++i) {
    const bool painted = std::min(i, kSides - i) <= kPainted && first.squaredNorm() > 0.0;
    const Shades& colour = painted ? mark : shades;
    Line to = line_at(i + 1);
    for (std::size_t j = 1; j < n; ++j)
      m.canvas().front_quad(from.points[j - 1], from.points[j], to.points[j], to.points[j - 1],
                            colour);
    m.canvas().front_triangle(centres[0], on_end(from.points[0], 0), on_end(to.points[0], 0),
                              colour);
    m.canvas().front_triangle(centres[1], on_end(to.points[n - 1], 1),
                              on_end(from.points[n - 1], 1), colour);
    from = std::move(to);
  }
}

}  // namespace adore::agore
