#include "agore/pocket_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace adore::agore {
namespace {

/// Of a roller's pocket at its end 0 (-x) or 1.
double wall(const PocketOutline& p, std::size_t end) {
  return 0.5 * (p.roller_length + p.clearance_1) + p.leaning.at(end);
}

/// Extent of a roller to one side (-1 left, 1 right) of the middle of its pocket, for walls with
/// constant width.
double reach(const QPolygonF& roller, double taper, double side) {
  double out = -std::numeric_limits<double>::infinity();
  for (const QPointF& p : roller) out = std::max(out, side * p.x() - taper * p.y());
  return out;
}

/// Half the width at the roller's middle that its sides leave a roller of this taper.
double half_at_middle(const PocketOutline& p) {
  if (p.faces.empty()) return p.radius + 0.5 * p.clearance_1;
  double out = std::numeric_limits<double>::infinity();
  for (const GuideFace& face : p.faces)
    out = std::min({out, face.at_low - p.taper * face.low, face.at_high - p.taper * face.high});
  return out;
}

/// Where the cage stands back beside and between guide faces.
double behind_faces(const PocketOutline& p) {
  double out = 0.0;
  for (const GuideFace& face : p.faces) out = std::max({out, face.at_low, face.at_high});
  return out + 0.12 * p.radius;
}

}  // namespace

QPolygonF upright(const QPainterPath& silhouette, double skew) {
  const double sine = std::sin(skew), cosine = std::cos(skew);
  QPolygonF out = silhouette.toFillPolygon();
  for (QPointF& p : out) p = {p.x() * sine - p.y() * cosine, p.x() * cosine + p.y() * sine};
  return out;
}

PocketGaps pocket_gaps(const PocketOutline& pocket, const QPolygonF& roller) {
  const double half = half_at_middle(pocket);
  const QRectF box = roller.boundingRect();
  return {{half - reach(roller, pocket.taper, -1.0), half - reach(roller, pocket.taper, 1.0)},
          {wall(pocket, 0) + box.top(), wall(pocket, 1) - box.bottom()}};
}

double drawn_skew(const QPainterPath& silhouette, double taper, double skew, double factor) {
  const auto wide = [&](double angle) {
    const QPolygonF roller = upright(silhouette, angle);
    return reach(roller, taper, -1.0) + reach(roller, taper, 1.0);
  };
  const double straight = wide(0.0);
  // A silhouette is a chain of chords: a barrel that turns by less than one of them (a degree)
  // would not change. Then the reduction is proportional to 1 - cos for the arc; ends reduce it
  // more.
  constexpr double kArc = 0.08;  // [rad], five chords
  const double of_arc = wide(std::copysign(kArc, skew)) - straight;
  const auto taken = [&](double angle) {
    const double chords = wide(angle) - straight;
    if (!(std::abs(angle) < kArc)) return chords;
    return std::max(chords, of_arc * (1.0 - std::cos(angle)) / (1.0 - std::cos(kArc)));
  };
  const double wanted = factor * taken(skew);
  constexpr int kHalvings = 40;
  double low = 0.0, high = std::numbers::pi / 3.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (taken(std::copysign(middle, skew)) < wanted ? low : high) = middle;
  }
  return std::copysign(low, skew);
}

double moved(const std::array<double, 2>& play, std::array<double, 2> gaps) {
  for (double& gap : gaps) gap = std::max(gap, 0.0);
  const double both = gaps[0] + gaps[1], left = std::max(play[0] + play[1], 0.0);
  const double share = both > 0.0 ? gaps[1] / both : 0.5;
  return play[1] - (left > 0.0 ? share * left : 0.5 * (play[0] + play[1]));
}

QSizeF pocket_half_size(const PocketOutline& p) {
  const double half = p.radius + 0.5 * p.clearance_1;
  if (!p.faces.empty()) return {behind_faces(p), std::max(wall(p, 0), wall(p, 1))};
  if (p.roller_length > 0.0) {
    const double high = wall(p, p.taper < 0.0 ? 0 : 1);
    return {half + std::abs(p.taper) * high, std::max(wall(p, 0), wall(p, 1))};
  }
  switch (p.code) {
    case 2:  // elongated round the bearing
      return {half + 0.5 * p.clearance_2, half};
    case 3:  // rectangular
      return {half, p.radius + 0.5 * p.clearance_2};
    case 4: {  // conical: the wider of its two ends
      const double wide = p.radius + 0.5 * std::max(p.clearance_1, p.clearance_2);
      return {wide, wide};
    }
    default:
      return {half, half};
  }
}

QPainterPath pocket_hole(const PocketOutline& p) {
  const QSizeF half = pocket_half_size(p);
  const QRectF box(-half.width(), -half.height(), 2.0 * half.width(), 2.0 * half.height());
  QPainterPath path;
  if (!p.faces.empty()) {
    const double back = half.width();
    path.addRect(QRectF(QPointF(-back, -wall(p, 0)), QPointF(back, wall(p, 1))));
    for (const GuideFace& face : p.faces)
      for (const double side : {-1.0, 1.0}) {
        QPainterPath block;
        block.addPolygon(QPolygonF{{side * face.at_low, face.low},
                                   {side * face.at_high, face.high},
                                   {side * back, face.high},
                                   {side * back, face.low}});
        block.closeSubpath();
        path = path.subtracted(block);
      }
  } else if (p.roller_length > 0.0) {
    const double middle = p.radius + 0.5 * p.clearance_1;
    QPolygonF window;
    for (const auto& [side, up] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      const double high = up * wall(p, up < 0.0 ? 0 : 1);
      window.append({side * (middle + p.taper * high), high});
    }
    path.addPolygon(window);
    path.closeSubpath();
  } else if (p.code == 3)
    path.addRect(box);
  else
    path.addRoundedRect(box, half.height(), half.height());
  return path;
}

QPointF wall_contact_direction(bool roller, QPointF centre, double angle, double direction) {
  if (roller) return {-direction * std::cos(angle), 0.0};
  const double way = std::hypot(centre.x(), centre.y());
  return way > 0.0 ? centre / way : QPointF(-direction * std::cos(angle), std::sin(angle));
}

QPointF wall_contact_point(const QPolygonF& roller, double taper, std::size_t side,
                           std::optional<double> along) {
  const double way = side == 0 ? -1.0 : 1.0, most = reach(roller, taper, way);
  const QRectF box = roller.boundingRect();
  // For a side parallel to the wall the middle.
  const double near = 1e-3 * box.width();
  double low = box.bottom(), high = box.top();
  for (const QPointF& p : roller)
    if (way * p.x() - taper * p.y() > most - near)
      low = std::min(low, p.y()), high = std::max(high, p.y());
  const double y = std::clamp(along && std::isfinite(*along) ? *along : 0.5 * (low + high),
                              box.top(), box.bottom());
  double x = box.center().x();
  for (qsizetype i = 0; i < roller.size(); ++i) {
    const QPointF &a = roller[i], &b = roller[(i + 1) % roller.size()];
    if ((a.y() - y) * (b.y() - y) > 0.0) continue;
    const double part = a.y() == b.y() ? 0.5 : (y - a.y()) / (b.y() - a.y());
    const double at = a.x() + part * (b.x() - a.x());
    if (way * at > way * x) x = at;
  }
  return {x, y};
}

QPainterPath pocket_far_edge(const PocketOutline& p) {
  QPainterPath path;
  constexpr int kConical = 4;
  if (p.code != kConical || p.roller_length > 0.0 || p.clearance_1 == p.clearance_2) return path;
  const double narrow = p.radius + 0.5 * std::min(p.clearance_1, p.clearance_2);
  path.addEllipse(QPointF(0.0, 0.0), narrow, narrow);
  return path;
}

}  // namespace adore::agore
