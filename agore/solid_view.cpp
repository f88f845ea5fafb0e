#include "agore/solid_view.hpp"

#include "agore/view_layout.hpp"
#include "agore/ways.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace adore::agore {

Eye::Eye(double yaw, double elevation) {
  const double a = yaw * kPi / 180.0, e = elevation * kPi / 180.0;
  toward = {std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)};
  right = {-std::sin(a), std::cos(a), 0.0};
  up = toward.cross(right);
}

namespace {

using Point = DepthCanvas::Point;

/// Directions at an azimuth: outwards and of increasing azimuth.
Vec3 outwards(double azimuth) { return {0.0, -std::sin(azimuth), std::cos(azimuth)}; }
Vec3 onwards(double azimuth) { return {0.0, -std::cos(azimuth), -std::sin(azimuth)}; }

/// Half of what is cut out of the outer race, about the viewer's side [rad].
constexpr double kOpen = 70.0 * kPi / 180.0;

double viewers_azimuth(const Eye& eye) { return std::atan2(-eye.toward.y(), eye.toward.z()); }

/// Is the spot of the outer race on metal that is drawn?
bool outer_spot_shown(const Scene& s, const Eye& eye) {
  const double from =
      std::remainder(s.animation.race_angle[0][s.index] - viewers_azimuth(eye), 2.0 * kPi);
  return std::abs(from) > kOpen;
}

/// Bodies as triangles on a canvas.
class Modeller {
 public:
  Modeller(DepthCanvas& canvas, const Eye& eye, double scale, QPointF middle)
      : canvas_(canvas), eye_(eye), scale_(scale), middle_(middle) {}

  [[nodiscard]] Point at(const Vec3& p) const {
    return {static_cast<float>(middle_.x() + scale_ * p.dot(eye_.right)),
            static_cast<float>(middle_.y() - scale_ * p.dot(eye_.up)),
            static_cast<float>(scale_ * p.dot(eye_.toward)), 0.0F};
  }
  /// Of a surface seen from either side.
  [[nodiscard]] float light(const Vec3& normal) const {
    const double z = normal.dot(eye_.toward), side = z < 0.0 ? -1.0 : 1.0;
    return light_of(static_cast<float>(side * normal.dot(eye_.right)),
                    static_cast<float>(side * normal.dot(eye_.up)), static_cast<float>(side * z));
  }
  [[nodiscard]] Point at(const Vec3& p, const Vec3& normal) const {
    Point out = at(p);
    out.light = light(normal);
    return out;
  }
  void flat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Shades& shades) {
    const auto lit = lit_corners(a, b, c, d);
    if (lit) canvas_.quad((*lit)[0], (*lit)[1], (*lit)[2], (*lit)[3], shades);
  }
  /// Of a closed body, its corners clockwise where they are seen.
  void front_flat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                  const Shades& shades) {
    if (!((c - a).cross(d - b).dot(eye_.toward) < 0.0)) return;
    const auto lit = lit_corners(a, b, c, d);
    if (lit) canvas_.quad((*lit)[0], (*lit)[1], (*lit)[2], (*lit)[3], shades);
  }
  void sphere(const Vec3& centre, double radius, const Vec3& pole, const Shades& shades,
              const Shades& mark) {
    canvas_.sphere(at(centre), static_cast<float>(scale_ * radius),
                   {static_cast<float>(pole.dot(eye_.right)), static_cast<float>(pole.dot(eye_.up)),
                    static_cast<float>(pole.dot(eye_.toward))},
                   shades, mark);
  }
  [[nodiscard]] DepthCanvas& canvas() { return canvas_; }
  /// Parts into which an arc [rad] of a radius is cut, so that its chords leave it by a quarter of
  /// a pixel at most: as fine as it is seen.
  [[nodiscard]] int parts(double radius, double arc) const {
    constexpr double kSeen = 0.25, kMost = 1000.0;
    return static_cast<int>(
        std::clamp(std::ceil(arc / std::sqrt(8.0 * kSeen / (scale_ * radius))), 1.0, kMost));
  }

 private:
  [[nodiscard]] std::optional<std::array<Point, 4>> lit_corners(const Vec3& a, const Vec3& b,
                                                                const Vec3& c,
                                                                const Vec3& d) const {
    Vec3 normal = (c - a).cross(d - b);
    const double size = normal.norm();
    if (!(size > 0.0)) return std::nullopt;
    normal /= size;
    const float lit = light(normal);
    std::array<Point, 4> out{at(a), at(b), at(c), at(d)};
    for (Point& p : out) p.light = lit;
    return out;
  }
  DepthCanvas& canvas_;
  const Eye& eye_;
  double scale_;
  QPointF middle_;
};

/// A ring over the azimuths from `begin` to `end`.
void add_ring(Modeller& m, const std::vector<RingColumn>& profile, const Vec3& shift, double begin,
              double end, const Shades& shades) {
  const int parts = std::max(8, static_cast<int>(std::ceil((end - begin) / (2.0 * kPi) * 150.0)));
  const auto place = [&](double x, double r, double azimuth) {
    return Vec3(Vec3(x, 0.0, 0.0) + r * outwards(azimuth) + shift);
  };
  for (int i = 0; i < parts; ++i) {
    const double a = begin + (end - begin) * i / parts, b = begin + (end - begin) * (i + 1) / parts;
    for (std::size_t j = 1; j < profile.size(); ++j) {
      const RingColumn &p = profile[j - 1], &q = profile[j];
      const auto surface = [&](double rp, double rq) {
        const double dx = q.x - p.x, dr = rq - rp, size = std::hypot(dx, dr);
        if (!(size > 0.0)) return;
        const auto normal = [&](double azimuth) {
          return Vec3((Vec3(-dr, 0.0, 0.0) + dx * outwards(azimuth)) / size);
        };
        m.canvas().quad(m.at(place(p.x, rp, a), normal(a)), m.at(place(q.x, rq, a), normal(a)),
                        m.at(place(q.x, rq, b), normal(b)), m.at(place(p.x, rp, b), normal(b)),
                        shades);
      };
      surface(p.near, q.near);
      surface(p.far, q.far);
    }
    for (const RingColumn& face : {profile.front(), profile.back()})
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

/// What a guide land faces on its race, over the ring's surface by `proud`.
void add_strip(Modeller& m, const LandPlace& land, const Vec3& shift, std::pair<double, double> arc,
               const Shades& shades, double proud) {
  const double way = land.race == 0 ? -1.0 : 1.0, radius = land.on_race + way * proud;
  constexpr int kParts = 150;
  const auto at = [&](double x, int i) {
    const double azimuth = arc.first + (arc.second - arc.first) * i / kParts;
    return m.at(Vec3(Vec3(x, 0.0, 0.0) + radius * outwards(azimuth) + shift), outwards(azimuth));
  };
  for (int i = 0; i < kParts; ++i)
    m.canvas().quad(at(land.low, i), at(land.high, i), at(land.high, i + 1), at(land.low, i + 1),
                    shades);
}

/// Where the sector of one pocket of the cage is, and its hole, as drawn.
struct PocketMesh {
  double half_angle, half_round;  ///< of the sector [rad]; of the hole, length the way round
  bool round;                     ///< hole: an ellipse, or a window
  double taper = 0.0;             ///< of a window, as its roller
};

void add_cage_part(Modeller& m, const CageProfile& cage, double pitch_radius, double azimuth,
                   const PocketMesh& pocket, const Mat3& turn, const Vec3& shift,
                   const std::array<bool, 2>& open_end, const Shades& shades) {
  // On the cage: the way round s (an angle at the pitch radius), along u, across v.
  const auto place = [&](double angle, double u, double v) {
    const QPointF p = leaned(0.0, pitch_radius, cage.lean, u, v);
    return Vec3(turn * Vec3(Vec3(p.x(), 0.0, 0.0) + p.y() * outwards(azimuth + angle)) + shift);
  };
  const auto across = [&](double angle) {
    return Vec3(turn * Vec3(Vec3(-std::sin(cage.lean), 0.0, 0.0) +
                            std::cos(cage.lean) * outwards(azimuth + angle)));
  };
  // A square's way round, so that corners are points of it: about the bearing (`along` and back),
  // and straight along it, where only round holes need points.
  constexpr int kMost = 10;
  const int round = 2 * m.parts(pocket.half_round, 1.0);
  const int arc = std::min(
      kMost, std::max(m.parts(pitch_radius, 2.0 * pocket.half_angle), pocket.round ? round : 1));
  const int straight = pocket.round ? arc : 1;
  const auto count = static_cast<std::size_t>(2 * (arc + straight));
  struct Rim {
    double hole_angle, hole_u, edge_angle, edge_u;
  };
  std::array<Rim, 4 * kMost + 1> rim{};
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
    Rim& r = rim[i];
    r.edge_angle = a * pocket.half_angle;
    r.edge_u = b * cage.half_width;
    const double size = pocket.round ? std::hypot(a, b) : 1.0;
    r.hole_u = b / size * (cage.hole + cage.leaning[b < 0.0 ? 0 : 1]);
    const double limit = 0.96 * pocket.half_angle * pitch_radius;
    r.hole_angle =
        std::min(limit, pocket.half_round + pocket.taper * r.hole_u) * a / size / pitch_radius;
  }
  // Each point of the mesh once: at the hole and at the edge, below and above.
  struct Corner {
    std::array<Vec3, 2> hole, edge;
    std::array<Point, 2> lit_hole, lit_edge;
  };
  std::array<Corner, 4 * kMost + 1> corner;
  const std::array<double, 2> heights{cage.low, cage.high};
  for (std::size_t i = 0; i <= count; ++i) {
    const Rim& r = rim[i];
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
    const Rim &p = rim[i], &q = rim[i + 1];
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

void add_roller(Modeller& m, const RollerProfile& shape, const Vec3& middle, const Vec3& axis,
                const Vec3& first, const Shades& shades, const Shades& mark) {
  const Vec3 second = axis.cross(first);
  constexpr int kSides = 28;
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
    const Shades& colour = i == 0 && first.squaredNorm() > 0.0 ? mark : shades;
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

/// Centre as drawn: the clearances magnified across the axis, to scale along it.
Vec3 element_place(const Scene& s, std::size_t k) {
  const QPointF centre = element_centre(s, k);
  return {s.frame.elements.at(k).x, centre.x(), centre.y()};
}

/// Axis of a roller as drawn, its skew and tilt magnified.
Vec3 roller_axis(const results::Sol8Element& e, double nominal, double factor) {
  constexpr double kMost = 0.6;  // [rad]
  const AxisAngles angles = axis_angles(e);
  const double lean = nominal + std::clamp(factor * (angles.lean - nominal), -kMost, kMost);
  const double skew = std::clamp(factor * angles.skew, -kMost, kMost);
  return Vec3(Vec3(1.0, 0.0, 0.0) + std::tan(lean) * outwards(e.theta) +
              std::tan(skew) * onwards(e.theta))
      .normalized();
}

/// Of the marks that turn with elements: with light and shade of their own, for a flat dark one
/// looks like a hole. On an element that the scale colours a grey, which is none of its colours,
/// pale on dark ones and dark on pale ones.
QColor mark_colour(const QColor& tint) {
  if (!tint.isValid()) return QColor("#7a3fa0");
  return qGray(tint.rgb()) < 120 ? QColor("#e8e8e8") : QColor("#3a3a3a");
}

void add_elements(Modeller& m, const Scene& s, double roller_factor) {
  const Colouring colours = colouring(s.animation, s.index, s.options.colour, s.options.scale);
  const desktop::Theme& t = s.sketch.theme();
  const bool balls = s.animation.file.bearing_type == 1;
  const Shades steel = shades_of(t.steel_light), plain_mark = shades_of(mark_colour({}));
  const double nominal = nominal_lean(s.animation);
  const RollerProfile roller = roller_profile(s.animation);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    const auto& e = s.frame.elements[k];
    const QColor tint = colours.of(k);
    const Shades shades = tint.isValid() ? shades_of(tint) : steel;
    const Shades paint = tint.isValid() ? shades_of(mark_colour(tint)) : plain_mark;
    const bool followed = e.angles != std::array<double, 3>{};
    const Mat3 attitude = rotation(e.angles);
    const Vec3 centre = element_place(s, k);
    if (balls) {
      m.sphere(centre, s.geometry().element_radius,
               followed ? Vec3(attitude.col(2)) : Vec3(Vec3::Zero()), shades, paint);
      continue;
    }
    const Vec3 axis = roller_axis(e, nominal, roller_factor);
    Vec3 first = attitude.col(2) - attitude.col(2).dot(axis) * axis;
    if (!(first.norm() > 1e-6)) first = outwards(e.theta);
    add_roller(m, roller, centre - roller.mass_centre * axis, axis, first.normalized(), shades,
               followed ? paint : shades);
  }
}

void add_cage(Modeller& m, const Scene& s) {
  if (!s.animation.has_cage) return;
  const Shades shades = shades_of(s.sketch.theme().cage);
  const CageProfile profile = cage_profile(s.animation);
  const RollerProfile roller = roller_profile(s.animation);
  const auto n = s.animation.pocket_angle.size();
  PocketMesh pocket{kPi / static_cast<double>(std::max<std::size_t>(n, 1)), s.pocket_radius(),
                    s.animation.file.bearing_type == 1, roller.slope};
  CageProfile drawn = profile;
  if (pocket.round) drawn.hole = std::min(s.pocket_radius(), 0.96 * profile.half_width);
  constexpr double kGap = 0.006, kMost = 0.3;  // between segments, of tilts [rad]
  for (std::size_t k = 0; k < n; ++k) {
    const int part = s.animation.pocket_part[k];
    const auto& body = s.animation.part(s.index, part);
    const QPointF across = s.place(body);
    const Vec3 shift(body.position[0], across.x(), across.y());
    const auto tilt = [&](double angle) {
      return std::clamp(s.factor * std::remainder(angle, kPi), -kMost, kMost);
    };
    const Mat3 turn = rotation(
        {s.animation.part_angle(s.index, part), tilt(body.angles[1]), tilt(body.angles[2])});
    const bool before = s.animation.pocket_part[(k + n - 1) % n] != part,
               after = s.animation.pocket_part[(k + 1) % n] != part;
    PocketMesh mesh = pocket;
    if (before || after) mesh.half_angle -= kGap;
    add_cage_part(m, drawn, s.pitch_radius(), s.animation.pocket_angle[k], mesh, turn, shift,
                  {before, after}, shades);
  }
}

}  // namespace

double SolidLayer::roller_factor(const Animation& animation) {
  if (roller_factor_) return *roller_factor_;
  double largest = 0.0;
  const double nominal = nominal_lean(animation);
  if (animation.file.bearing_type != 1) {
    constexpr std::size_t kLooks = 200;
    const std::size_t every = std::max<std::size_t>(1, animation.frames() / kLooks);
    for (std::size_t i = 0; i < animation.frames(); i += every)
      for (const auto& e : animation.frame(i).elements) {
        const AxisAngles angles = axis_angles(e);
        largest = std::max({largest, std::abs(angles.lean - nominal), std::abs(angles.skew)});
      }
  }
  constexpr double kShown = 0.12, kRounding = 1e-9;  // [rad]
  double factor = largest > kRounding ? 1.0 : 0.0;
  if (largest > kRounding)
    for (const double candidate : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0})
      if (candidate * largest <= kShown) factor = candidate;
  roller_factor_ = factor;
  return factor;
}

void SolidLayer::draw(const Scene& s, int oversample, double pixel_ratio) {
  const double pixel = oversample * pixel_ratio;
  const QRectF& area = s.sketch.area();
  const QSize size(
      (QSizeF(std::round(area.width() * pixel_ratio), std::round(area.height() * pixel_ratio)) *
       oversample)
          .toSize());
  const Eye eye(s.options.yaw, s.options.elevation);
  const double scale = s.sketch.scale() * pixel;
  const QPointF middle = (s.sketch.at(0, 0) - area.topLeft()) * pixel;
  const auto shift = [&](std::size_t race) {
    const auto& p = s.frame.races.at(race).position;
    return Vec3(p[0], p[1], p[2]);
  };
  const desktop::Theme& t = s.sketch.theme();
  Key key{size,     scale, s.options.yaw,  s.options.elevation, middle.x(), middle.y(),
          s.factor, {},    s.options.dark, &s.animation};
  constexpr double kFar = 1e6;
  for (std::size_t race = 0; race < 2; ++race)
    for (int c = 0; c < 3; ++c)
      key.shift[3 * race + static_cast<std::size_t>(c)] =
          static_cast<int>(std::lround(std::clamp(2.0 * scale * shift(race)[c], -kFar, kFar)));
  if (!(key == key_)) {
    races_.reset(size, t.surface.rgb());
    canvas_ = DepthCanvas();
    Modeller m(races_, eye, scale, middle);
    const Shades steel = shades_of(t.steel_dark);
    const double towards = viewers_azimuth(eye);
    const std::array<std::pair<double, double>, 2> arcs{
        {{towards + kOpen, towards + 2.0 * kPi - kOpen}, {0.0, 2.0 * kPi}}};
    for (const std::size_t race : {0U, 1U})
      add_ring(m, ring_profile(s.animation, race, s.factor), shift(race), arcs[race].first,
               arcs[race].second, steel);
    for (const LandPlace& land : land_places(s.animation, s.factor))
      add_strip(m, land, shift(land.race), arcs[land.race], shades_of(t.red), 2.0 / scale);
    key_ = key;
  }
  canvas_.restore(races_);
  Modeller m(canvas_, eye, scale, middle);
  add_elements(m, s, roller_factor(s.animation));
  add_cage(m, s);
  // Spots on the races' faces show their turning.
  const std::array<QColor, 2> spots{t.light_blue, t.blue};
  for (std::size_t race = outer_spot_shown(s, eye) ? 0 : 1; race < 2; ++race) {
    const auto profile = ring_profile(s.animation, race, s.factor);
    const double size_of = 0.16 * s.geometry().element_radius;
    for (const RingColumn& face : {profile.front(), profile.back()})
      m.sphere(Vec3(face.x, 0.0, 0.0) +
                   0.5 * (face.near + face.far) * outwards(s.animation.race_angle[race][s.index]) +
                   shift(race),
               size_of, Vec3::Zero(), shades_of(spots[race]), shades_of(spots[race]));
  }
  // The rest is paper, which lies there already.
  const QRect drawn = canvas_.drawn();
  if (drawn.isEmpty()) return;
  const QRect box(drawn.topLeft() / oversample - QPoint(1, 1),
                  drawn.bottomRight() / oversample + QPoint(1, 1));
  const QRect seen = box & QRect(QPoint(0, 0), size / oversample);
  QImage image = canvas_.image(oversample, seen);
  image.setDevicePixelRatio(pixel_ratio);
  s.sketch.painter().drawImage(area.topLeft() + QPointF(seen.topLeft()) / pixel_ratio, image);
}

double solid_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const double rim = std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
  return 1.06 * std::hypot(rim, 0.5 * size_length(animation, "outer_race_width"));
}

void solid_view(const Scene& s, SolidLayer& layer) {
  QPainter& p = s.sketch.painter();
  const auto& t = s.sketch.theme();
  constexpr int kStill = 2;
  layer.draw(s, s.options.moving ? 1 : kStill, p.device()->devicePixelRatioF());
  const Eye eye(s.options.yaw, s.options.elevation);
  const auto at = [&](const Vec3& v) { return s.sketch.at(v.dot(eye.right), v.dot(eye.up)); };
  // Over the bodies: a line hidden in the metal says nothing.
  if (s.options.trails)
    for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
      std::vector<WayPoint> way;
      for (const TrailPoint& point : element_trail(s, k))
        way.push_back({at({point.x, point.centre.x(), point.centre.y()}), point.joined});
      draw_way(p, s.sketch.area(), way, trail_colour(s), 1.8);
    }
  std::vector<KeyEntry> key;
  if (outer_spot_shown(s, eye)) key.push_back({t.light_blue, "spot of the outer race"});
  key.push_back({t.blue, "spot of the inner race"});
  if (!land_places(s.animation).empty()) key.push_back({t.red, "guide lands"});
  if (s.options.trails) key.push_back(trail_entry(s));
  const auto* const loads = s.options.contacts ? s.animation.contacts_at(s.index) : nullptr;
  if (s.options.contacts && loads == nullptr)
    key.push_back(
        {t.muted, QString::fromStdString("no race loads: " + s.animation.no_loads(s.index))});
  if (loads != nullptr && s.animation.contacts->largest_load > 0.0) {
    const auto& contacts = *loads;
    const double radius = s.geometry().element_radius;
    for (std::size_t k = 0; k < contacts.size(); ++k)
      for (std::size_t j = 0; j < 2; ++j) {
        const double part = contacts[k].load[j] / s.animation.contacts->largest_load;
        const double angle = s.animation.value("contact.angle", s.index, 2 * k + j);
        if (!(part > 0.0) || !std::isfinite(angle)) continue;
        const double way = j == 0 ? 1.0 : -1.0;
        const Vec3 u = way * (Vec3(std::sin(angle), 0.0, 0.0) +
                              std::cos(angle) * outwards(s.frame.elements.at(k).theta));
        const Vec3 tip = element_place(s, k) + radius * u, tail = tip + 1.3 * part * radius * u;
        s.sketch.arrow(at(tail), at(tip), t.curves[j], 2.6);
      }
    const auto& largest = s.animation.contacts->largest_of_race;
    key.push_back({t.curves[0], "outer race loads" + longest_load(s, largest[0])});
    key.push_back({t.curves[1], "inner race loads" + longest_load(s, largest[1])});
  }
  if (s.options.colour != ColourBy::None)
    draw_scale(s, colouring(s.animation, s.index, s.options.colour, s.options.scale));
  // The bearing's axes, in the upper left corner.
  const double high = s.sketch.area().height();
  const double arm = high < 200.0 ? 10.0 : high < 420.0 ? 18.0 : 30.0;
  const int letters = high < 200.0 ? 9 : 12;
  const QPointF corner = s.sketch.area().topLeft() + 1.6 * QPointF(arm, arm);
  const std::array<std::pair<Vec3, const char*>, 3> axes{
      {{Vec3::UnitX(), "x"}, {Vec3::UnitY(), "y"}, {Vec3::UnitZ(), "z"}}};
  for (const auto& [axis, name] : axes) {
    const QPointF way(axis.dot(eye.right), -axis.dot(eye.up));
    s.sketch.arrow(corner, corner + arm * way, t.muted, 1.8);
    s.sketch.label(corner + (arm + 0.75 * letters) * way, name, t.muted, letters, true);
  }
  std::string remark = s.animation.has_cage ? fmt::format("clearances across × {}",
                                                          desktop::pretty_number(s.factor, 3))
                                            : std::string("to scale");
  const double factor = layer.roller_factor(s.animation);
  if (s.animation.file.bearing_type != 1)
    remark += !(factor > 0.0) ? std::string("  ·  no skew, no tilt")
              : factor == 1.0
                  ? std::string("  ·  skew and tilt to scale")
                  : fmt::format("  ·  skew and tilt × {}", desktop::pretty_number(factor, 4));
  if (too_low(s.options, s.sketch.area().height())) {  // first: colours say nothing without
    const std::vector<KeyEntry> ends = scale_entries(s);
    key.insert(key.begin(), ends.begin(), ends.end());
  }
  draw_key(s, key, QString::fromStdString(remark));
}

}  // namespace adore::agore
