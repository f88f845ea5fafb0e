#include "agore/solid_model.hpp"
#include "agore/solid_view.hpp"
#include "agore/ways.hpp"
#include "desktop/picture_marks.hpp"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

/// Lines over the bodies of a frame: paths of the elements and load arrows, dashed behind bodies,
/// like hidden edges of engineering drawings.
namespace adore::agore {
namespace {

/// The way of an element's center in the picture, cut where bodies begin and end to hide it.
struct CutWay {
  std::vector<std::vector<TrajectoryPoint>> seen, hidden;
};

class WayCutter {
 public:
  WayCutter(const SolidLayer& layer, CutWay& out) : layer_(layer), out_(out) {}
  struct Place {
    QPointF at;
    double depth;  ///< toward the viewer [pixels]
  };
  void begin() { last_.reset(); }
  void add(const Place& to, bool joined) {
    if (last_ && joined) {
      // As fine as a body's edge is seen.
      constexpr double kStep = 3.0;  // pixels
      const QPointF way = to.at - last_->at;
      const int parts = std::max(
          1, static_cast<int>(std::ceil(std::min(1e4, std::hypot(way.x(), way.y())) / kStep)));
      const Place from = *last_;
      for (int i = 1; i <= parts; ++i) {
        const double part = static_cast<double>(i) / parts;
        step({from.at + part * way, from.depth + part * (to.depth - from.depth)}, i == parts);
      }
      return;
    }
    // If the previous path is unknown, this point is marked, in the same list.
    const bool hidden = layer_.hides(to.at, to.depth);
    const bool on = last_ && hidden == hidden_;
    hidden_ = hidden;
    if (!on) piece().emplace_back();
    piece().back().push_back({to.at, false});
    last_ = to;
  }

 private:
  [[nodiscard]] std::vector<std::vector<TrajectoryPoint>>& piece() {
    return hidden_ ? out_.hidden : out_.seen;
  }
  void step(const Place& to, bool frame) {
    const bool hidden = layer_.hides(to.at, to.depth);
    if (hidden != hidden_) {
      piece().back().push_back({to.at, true, false});
      hidden_ = hidden;
      piece().push_back({{to.at, false, frame}});
    } else if (frame) {
      piece().back().push_back({to.at, true});
    }
    last_ = to;
  }
  const SolidLayer& layer_;
  CutWay& out_;
  std::optional<Place> last_;
  bool hidden_ = false;
};

/// From the bearing's axes into the picture.
class Projection {
 public:
  Projection(const Scene& scene, const Eye& eye) : scene_(scene), eye_(eye) {}
  [[nodiscard]] WayCutter::Place operator()(const Vec3& place) const {
    return {scene_.sketch.at(place.dot(eye_.right), place.dot(eye_.up)),
            scene_.sketch.scale() * place.dot(eye_.toward)};
  }

 private:
  const Scene& scene_;
  const Eye& eye_;
};

/// An arrow in space, as drawn.
struct LoadArrow {
  CutWay shaft;
  QPointF tip, way;  ///< `way`: of length 1
  double head = 0.0;
  bool hidden = false;  ///< is its head?
  QColor colour;
};

LoadArrow load_arrow_of(const SolidLayer& layer, const WayCutter::Place& tail,
                        const WayCutter::Place& tip, double width, const QColor& colour) {
  LoadArrow out;
  const QPointF along = tip.at - tail.at;
  const double length = std::hypot(along.x(), along.y());
  out.tip = tip.at, out.way = along / length, out.colour = colour;
  out.head = std::min(0.5 * length, 5.0 + 3.2 * width);
  const auto between = [&](double from_tip) {
    const double part = from_tip / length;
    return WayCutter::Place{tip.at - part * along, tip.depth - part * (tip.depth - tail.depth)};
  };
  WayCutter cutter(layer, out.shaft);
  cutter.begin();
  cutter.add(tail, false);
  cutter.add(between(0.8 * out.head), true);
  for (auto* ways : {&out.shaft.seen, &out.shaft.hidden})
    for (std::vector<TrajectoryPoint>& way : *ways)
      for (TrajectoryPoint& point : way) point.frame = false;
  const WayCutter::Place middle = between(0.5 * out.head);
  out.hidden = layer.hides(middle.at, middle.depth);
  return out;
}

void draw_head(QPainter& p, const LoadArrow& arrow, const QColor& paper) {
  constexpr double kEdge = 2.4;  // half of it outside
  const auto head = [&](const QColor& ink, const QPen& edge) {
    desktop::draw_arrow_head(p, arrow.tip, arrow.way, arrow.head, ink, edge);
  };
  if (arrow.hidden) {
    head(paper, QPen(paper, kEdge + 2.0 * kCasing));
    head(paper, QPen(arrow.colour, kEdge));
  } else {
    head(arrow.colour, QPen(paper, 2.0 * kCasing));
  }
}

}  // namespace

namespace {

double length_of(const std::vector<std::vector<TrajectoryPoint>>& ways) {
  double out = 0.0;
  for (const std::vector<TrajectoryPoint>& way : ways)
    for (std::size_t i = 1; i < way.size(); ++i)
      if (way[i].joined) out += QLineF(way[i - 1].at, way[i].at).length();
  return std::isfinite(out) ? out : 0.0;
}

}  // namespace

LineVisibility draw_paths(const Scene& s, const SolidLayer& layer, const Eye& eye) {
  CutWay ways;
  WayCutter cutter(layer, ways);
  const Projection at(s, eye);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    cutter.begin();
    for (const TrailPoint& point : element_trail(s, k))
      cutter.add(at(Vec3(point.x, point.centre.x(), point.centre.y())), point.joined);
  }
  QPainter& p = s.sketch.painter();
  const QColor colour = trail_colour(s), edge = s.sketch.theme().surface;
  draw_trajectories(p, s.sketch.area(), ways.hidden, {colour, 1.6, edge, true});
  draw_trajectories(p, s.sketch.area(), ways.seen, {colour, 1.8, edge});
  // A twentieth of them is hardly found.
  constexpr double kPart = 0.05;
  const double seen = length_of(ways.seen), hidden = length_of(ways.hidden);
  if (!(seen + hidden > 0.0)) return {!ways.seen.empty(), !ways.hidden.empty()};
  return {seen > kPart * hidden, hidden > kPart * seen};
}

std::array<LineVisibility, 2> draw_loads(const Scene& s, const SolidLayer& layer, const Eye& eye) {
  std::array<LineVisibility, 2> out{};
  const auto* const contacts = s.animation.contacts_at(s.index);
  if (contacts == nullptr || !(s.animation.contacts->largest_load > 0.0)) return out;
  constexpr double kSeen = 6.0, kWidth = 2.6, kHiddenWidth = 2.4;  // pixels
  const Projection at(s, eye);
  const double radius = s.geometry().element_radius;
  struct Stub {
    QPointF tail, tip;
    QColor colour;
  };
  std::vector<Stub> stubs;
  std::vector<LoadArrow> arrows;
  for (std::size_t k = 0; k < contacts->size(); ++k)
    for (const std::size_t c : {0U, 1U, 2U, 3U}) {  // both races, then other halves of split ones
      const std::size_t j = c % 2;
      const double load = c < 2 ? (*contacts)[k].load[j]
                                : s.animation.value("second_contact.load", s.index, 2 * k + j);
      const double part = load / s.animation.contacts->largest_load;
      if (!(part >= kLeastLoad)) continue;
      const double angle =
          s.animation.value(c < 2 ? "contact.angle" : "second_contact.angle", s.index, 2 * k + j);
      if (!std::isfinite(angle)) continue;
      const double way = j == 0 ? 1.0 : -1.0;
      const Vec3 u = way * (Vec3(std::sin(angle), 0.0, 0.0) +
                            std::cos(angle) * outward_direction(s.frame.elements.at(k).theta));
      const Vec3 tip = drawn_element_center(s, k) + radius * u;
      const WayCutter::Place from = at(Vec3(tip + 1.3 * part * radius * u)), to = at(tip);
      const double length = QLineF(from.at, to.at).length();
      if (!std::isfinite(length)) continue;
      if (length < kSeen) {
        if (layer.hides(to.at, to.depth)) continue;
        stubs.push_back({from.at, to.at, s.sketch.theme().curves[j]});
        out[j].seen = true;
        continue;
      }
      arrows.push_back(load_arrow_of(layer, from, to, kWidth, s.sketch.theme().curves[j]));
      out[j].seen = out[j].seen || !arrows.back().hidden;
      out[j].hidden = out[j].hidden || arrows.back().hidden || !arrows.back().shaft.hidden.empty();
    }
  QPainter& p = s.sketch.painter();
  const QColor paper = s.sketch.theme().surface;
  // Sorted from back to front.
  for (const LoadArrow& arrow : arrows) {
    draw_trajectories(p, s.sketch.area(), arrow.shaft.hidden,
                      {arrow.colour, kHiddenWidth, paper, true});
    if (arrow.hidden) draw_head(p, arrow, paper);
  }
  for (const LoadArrow& arrow : arrows) {
    draw_trajectories(p, s.sketch.area(), arrow.shaft.seen, {arrow.colour, kWidth, paper});
    if (!arrow.hidden) draw_head(p, arrow, paper);
  }
  for (const Stub& stub : stubs) draw_load_stub(p, stub.tail, stub.tip, stub.colour, paper);
  return out;
}

}  // namespace adore::agore
