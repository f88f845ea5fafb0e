#include "desktop/chart_scene_parts.hpp"
#include "desktop/dense_line.hpp"

#include <QGraphicsItem>
#include <QPainter>

#include <algorithm>
#include <cmath>

/// The curves of a panel: lines, points and bands.
namespace adore::desktop {
namespace {

/// The parts of a line of a chart, not beyond its area.
class LineItem : public QGraphicsItem {
 public:
  LineItem(std::vector<QPolygonF> parts, const QRectF& area, QPen pen)
      : parts_(std::move(parts)), area_(area), pen_(std::move(pen)) {}
  [[nodiscard]] QRectF boundingRect() const override { return area_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    draw_lines(*painter, parts_, area_, pen_);
  }

 private:
  std::vector<QPolygonF> parts_;
  QRectF area_;
  QPen pen_;
};

/// A path of very many points, drawn from tiles stored in its scene.
class LongWayItem : public QGraphicsItem {
 public:
  LongWayItem(const PathIndex& way, PathTiles& tiles, PathPlacement place, QPen pen)
      : way_(way), tiles_(tiles), place_(std::move(place)), pen_(std::move(pen)) {}
  [[nodiscard]] QRectF boundingRect() const override { return place_.area; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    tiles_.draw(*painter, way_, place_, pen_);
  }

 private:
  const PathIndex& way_;
  PathTiles& tiles_;
  PathPlacement place_;
  QPen pen_;
};

}  // namespace

QPen ChartScene::penOf(int colour, qreal width, bool dashed) const {
  QPen pen(theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()], width);
  pen.setJoinStyle(Qt::BevelJoin);  // a round one takes five times as long
  if (const QList<qreal> dashes = dash_pattern(*theme_, static_cast<std::size_t>(colour));
      !dashes.isEmpty())
    pen.setDashPattern(dashes);
  else if (dashed)
    pen.setDashPattern({4.0, 4.0});
  return pen;
}

QPolygonF line_in_scene(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                        const AxisScale& y_axis, bool limited) {
  QPolygonF points;
  points.reserve(static_cast<qsizetype>(line.x.size()));
  // Far outside a picture numbers are too large for the painter.
  const double far = limited ? 1e5 : 1e12;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const double x = (x_axis.shown(line.x[i]) - x_axis.min) / (x_axis.max - x_axis.min),
                 y = (y_axis.shown(line.y[i]) - y_axis.min) / (y_axis.max - y_axis.min);
    points.append({area.left() + std::clamp(x * area.width(), -far, far),
                   area.bottom() - std::clamp(y * area.height(), -far, far)});
  }
  return points;
}

/// The parts of a line inside `area`.
std::vector<QPolygonF> clip_to_area(const QPolygonF& line, const QRectF& area) {
  std::vector<QPolygonF> out;
  bool joined = false;  // the last part continues
  for (qsizetype i = 1; i < line.size(); ++i) {
    const QPointF p = line[i - 1], way = line[i] - p;
    double from = 0.0, to = 1.0;
    const auto keep = [&](double start, double length, double low, double high) {
      if (length == 0.0) return start >= low && start <= high;
      const double a = (low - start) / length, b = (high - start) / length;
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
      return from <= to;
    };
    if (!keep(p.x(), way.x(), area.left(), area.right()) ||
        !keep(p.y(), way.y(), area.top(), area.bottom())) {
      joined = false;
      continue;
    }
    if (!joined || from > 0.0) out.push_back({p + from * way});
    out.back().append(p + to * way);
    joined = to == 1.0;
  }
  return out;
}

namespace {

/// Height of a bend of the stripes below [px].
constexpr qreal kBend = 18.0;

/// Oscillates with the height: 0 to kBend.
qreal bent(qreal y) {
  const qreal part = y / (2.0 * kBend);
  return 2.0 * kBend * std::abs(part - std::round(part));
}

/// A line with a point wherever it passes a bend.
QPolygonF with_bends(const QPolygonF& line) {
  QPolygonF out;
  for (const QPointF& q : line) {
    if (!out.isEmpty()) {
      const QPointF p = out.back();
      const qreal from = p.y() / kBend, to = q.y() / kBend;
      const qreal way = to > from ? 1.0 : -1.0;
      for (qreal k = way > 0.0 ? std::floor(from) + 1.0 : std::ceil(from) - 1.0;
           way * (to - k) > 0.0; k += way)
        out.append(p + (k - from) / (to - from) * (q - p));
    }
    out.append(q);
  }
  return out;
}

/// Stripes of a line that are left to the curve above it: every `of`-th stripe across the picture,
/// so that both are visible along a spike. The stripes are bent, because a line parallel to
/// straight ones would have a single color. They are vertical for dense oscillations, which would
/// have too many parts.
std::vector<QPolygonF> stretches(const QPolygonF& whole, int of, const QRectF& area) {
  constexpr qreal kWide = 9.0, kLong = 20000.0;
  const std::vector<QPolygonF> lines = clip_to_area(whole, area);
  qreal length = 0.0;
  for (const QPolygonF& line : lines)
    for (qsizetype i = 1; i < line.size(); ++i) length += std::abs(line[i].y() - line[i - 1].y());
  const qreal slant = length < kLong ? 1.0 : 0.0;
  std::vector<QPolygonF> out;
  QPolygonF piece;
  const auto mine = [of](long stripe) { return (stripe % of + of) % of == of - 1; };
  const auto flush = [&] {
    if (piece.size() > 1) out.push_back(piece);
    piece.clear();
  };
  const auto stripe_at = [slant](const QPointF& p) {
    return (p.x() + slant * bent(p.y())) / kWide;
  };
  for (const QPolygonF& smooth : lines) {
    const QPolygonF line = slant > 0.0 ? with_bends(smooth) : smooth;
    for (qsizetype i = 0; i < line.size(); ++i) {
      const QPointF q = line[i];
      const qreal to = stripe_at(q);
      if (i > 0) {
        const QPointF p = line[i - 1];
        const qreal from = stripe_at(p);
        const long last = static_cast<long>(std::floor(to)), way = to > from ? 1 : -1;
        for (long s = static_cast<long>(std::floor(from)); s != last; s += way) {
          const qreal edge = static_cast<qreal>(way > 0 ? s + 1 : s);
          const QPointF at = p + (edge - from) / (to - from) * (q - p);
          if (mine(s)) piece.append(at);
          flush();
          if (mine(s + way)) piece.append(at);
        }
      }
      if (mine(static_cast<long>(std::floor(to)))) piece.append(q);
    }
    flush();
  }
  return out;
}

/// The part of a line between two horizontal positions; x increases.
QPolygonF between(const QPolygonF& line, qreal left, qreal right) {
  QPolygonF out;
  for (qsizetype i = 0; i < line.size(); ++i) {
    const QPointF q = line[i];
    if (i > 0) {
      const QPointF p = line[i - 1];
      const auto at = [&](qreal x) { return p + (x - p.x()) / (q.x() - p.x()) * (q - p); };
      if (p.x() < left && q.x() > left) out.append(at(left));
      if (p.x() < right && q.x() > right) out.append(at(right));
    }
    if (q.x() >= left && q.x() <= right) out.append(q);
  }
  return out;
}

}  // namespace

void ChartScene::addShownCurve(const ShownCurve& shown, const ChartPanel& panel, const QRectF& area,
                               const AxisScale& y_axis, const Metrics& m) {
  const ChartCurve& curve = panel.curves[shown.curve];
  const QPen pen = penOf(shown.colour, curve.heavy ? 2.5 * m.line : m.line, curve.dashed);
  std::vector<QPolygonF> parts;
  const qreal margin = 2.0 + 2.0 * m.line;  // ends of cut strokes are not seen
  const QRectF around = area.adjusted(-margin, -margin, margin, margin);
  const auto add = [&](std::vector<QPolygonF> more) {
    for (QPolygonF& part : more)
      if (part.size() > 1) parts.push_back(std::move(part));
  };
  for (const QPolygonF& line : shown.lines) {
    if (!shown.hides) {
      parts.push_back(line);
    } else if (shown.over.empty()) {
      add(stretches(line, shown.later + 1, around));
    } else {
      qreal left = around.left();
      for (const auto& [first, last] : shown.over) {
        add({between(line, left, first)});
        add(stretches(between(line, first, last), shown.later + 1, around));
        left = last;
      }
      add({between(line, left, around.right())});
    }
  }
  addPolylineItem(std::move(parts), area, pen);
  if (!lines_.empty()) lines_.back() += static_cast<int>(shown.lines.size());
  for (std::size_t i = 0; i < shown.pieces.size(); ++i) {
    // A value between gaps has no line: it is drawn as a point. A dashed line among points is a
    // limit.
    const bool limit = panel.curves[shown.curve].dashed;
    if ((page_.points && !limit) || shown.pieces[i].x.size() == 1)
      addPoints(shown.pieces[i], area, x_axis_, y_axis, shown.colour, m.line);
  }
}

void ChartScene::addPolylineItem(std::vector<QPolygonF> parts, const QRectF& area, QPen pen) {
  if (!parts.empty())
    addItem(new LineItem(std::move(parts), area.adjusted(-1, -1, 1, 1), std::move(pen)));
}

void ChartScene::addLongPath(std::size_t curve, const PathPlacement& place, QPen pen) {
  PlaneCurve& known = plane_curves_[curve];
  PathPlacement around = place;
  around.area.adjust(-1, -1, 1, 1);
  addItem(new LongWayItem(known.runs, known.tiles, around, std::move(pen)));
  if (!lines_.empty()) ++lines_.back();
}

QPolygonF ChartScene::addCurve(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                               const AxisScale& y_axis, QPen pen) {
  // A line that extends far outside the frame is clipped: numbers too large for the painter would
  // have to be changed, and with them the direction of lines that cross the frame.
  QPolygonF points = line_in_scene(line, area, x_axis, y_axis, false);
  constexpr qreal kMargin = 1000.0;
  const QRectF around = area.adjusted(-kMargin, -kMargin, kMargin, kMargin);
  if (around.contains(points.boundingRect()))
    addPolylineItem({points}, area, std::move(pen));
  else
    addPolylineItem(clip_to_area(points, area.adjusted(-10, -10, 10, 10)), area, std::move(pen));
  if (!lines_.empty()) ++lines_.back();
  return points;
}

void ChartScene::addPoints(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                           const AxisScale& y_axis, int colour, qreal width) {
  const QColor fill = theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()];
  const qreal r = 1.6 * width;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (line.x[i] < low_ || line.x[i] > high_) continue;
    const qreal x = area.left() + (x_axis.shown(line.x[i]) - x_axis.min) /
                                      (x_axis.max - x_axis.min) * area.width();
    const qreal y = area.bottom() - (y_axis.shown(line.y[i]) - y_axis.min) /
                                        (y_axis.max - y_axis.min) * area.height();
    if (y < area.top() || y > area.bottom()) continue;  // beyond the chosen range
    addEllipse(QRectF(x - r, y - r, 2 * r, 2 * r), QPen(Qt::NoPen), fill)->setZValue(5);
  }
}

}  // namespace adore::desktop
