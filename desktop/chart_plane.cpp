#include "desktop/chart_scene.hpp"
#include "desktop/chart_scene_parts.hpp"

#include <QAbstractGraphicsShapeItem>
#include <QFontMetricsF>
#include <QGraphicsTextItem>

#include <cmath>
#include <limits>
#include <numbers>

/// Pages with equal axes: orbits, roses and cuts.
namespace adore::desktop {

namespace {

/// Fraction of the picture height within which outlines are considered equal, as for curves.
constexpr double kSameOutline = 1.0 / 300.0;

/// Does a curve have more points than a line is stroked with? Then only its visible parts are
/// drawn.
bool is_long(const ChartCurve& curve) {
  constexpr std::size_t kLong = 4096;
  return std::min(curve.x.size(), curve.y.size()) > kLong;
}

/// For corresponding points; infinite if outlines have different points.
double farthest_apart(const ChartCurve& one, const ChartCurve& other) {
  double out = std::numeric_limits<double>::infinity();
  if (one.x.size() != other.x.size() || one.y.size() != other.y.size() || one.x.empty()) return out;
  out = 0.0;
  for (std::size_t i = 0; i < std::min(one.x.size(), one.y.size()); ++i) {
    const double apart = std::hypot(one.x[i] - other.x[i], one.y[i] - other.y[i]);
    if (std::isfinite(apart)) out = std::max(out, apart);
  }
  return out;
}

}  // namespace

bool ChartScene::isPlane() const {
  return page_.equal_axes && !page_.schematic && !page_.panels.empty();
}

void ChartScene::precomputePlaneCurves() {
  plane_curves_.clear();
  if (page_.panels.empty()) return;
  for (const ChartCurve& curve : page_.panels.front().curves) {
    PlaneCurve& known = plane_curves_.emplace_back();
    for (const double x : curve.x) known.across.include(x);
    for (const double y : curve.y) known.up.include(y);
    known.runs = PathIndex(curve.x, curve.y);
  }
}

ChartScene::EqualAxesLayout ChartScene::fullPlaneLayout(const Metrics& m) const {
  const QRectF space = this->space(m);
  const ChartPanel& panel = page_.panels.front();
  Extent across, up;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    if (panel.curves[c].hidden) continue;
    across.include(plane_curves_[c].across);
    up.include(plane_curves_[c].up);
  }
  for (const ChartLabel& label : page_.labels) {
    if (!page_.schematic) break;
    across.include(label.x);
    up.include(label.y);
  }
  for (const double r : {-page_.guide_radius, page_.guide_radius}) {
    if (page_.guide_radius <= 0.0) continue;
    across.include(r);
    up.include(r);
  }
  // A square with both ranges keeps circles round; a margin of a twelfth keeps the curve off the
  // frame.
  EqualAxesLayout out;
  out.middle_x = across.empty() ? 0.0 : 0.5 * (across.low + across.high);
  out.middle_y = up.empty() ? 0.0 : 0.5 * (up.low + up.high);
  double half = across.empty() || up.empty()
                    ? 1.0
                    : 0.5 * std::max(across.high - across.low, up.high - up.low);
  if (!(half > 1e-9 * std::max(std::abs(out.middle_x), std::abs(out.middle_y))))
    half = std::max({std::abs(out.middle_x), std::abs(out.middle_y), 1e-9});
  // Less than an atom's size is rounding, not a path.
  half = std::max(half, 0.5 * min_axis_span(panel.unit));
  half *= 1.08;
  // A fitted page is as wide as its curves need at the scale that its height gives, or less.
  out.half_x = out.half_y = half;
  if (page_.fitted && !across.empty() && !up.empty()) {
    constexpr double kMargin = 0.62;  // of the range, either side of its middle
    out.half_x = kMargin * (across.high - across.low);
    out.half_y = kMargin * (up.high - up.low);
  }
  const QSizeF most(space.width(), space.height() - m.legend);
  const qreal scale = std::min(most.width() / out.half_x, most.height() / out.half_y);
  if (page_.fitted) {                                 // remarks next to the curves, if they fit
    constexpr qreal kRemark = 180.0, kBeside = 45.0;  // dot, leader and gaps
    qreal remark = kRemark;
    const QFontMetricsF metrics(ui_font(m.text_font));
    for (const ChartLabel& label : page_.labels)
      if (label.towards_x != 0.0)
        remark = std::max(remark, kBeside + metrics.horizontalAdvance(text_of(label.text)));
    const double wanted = out.half_x / 1.24 + 2.0 * remark / scale;
    out.half_x = std::clamp(wanted, out.half_x, most.width() / scale);
  }
  const QSizeF size(out.half_x * scale, out.half_y * scale);
  out.area = QRectF(space.left() + 0.5 * (space.width() - size.width()), space.top() + m.legend,
                    size.width(), size.height());
  return out;
}

/// A page with long curves is moved by whole pixels: its tiles are reused, and curves do not shift
/// against each other. At most half a pixel.
ChartScene::EqualAxesLayout ChartScene::visiblePlaneLayout(const EqualAxesLayout& whole) const {
  EqualAxesLayout out = page_.schematic ? whole : selectedPlaneLayout(whole);
  const auto& curves = page_.panels.front().curves;
  if (std::none_of(curves.begin(), curves.end(), is_long)) return out;
  const auto on_pixels = [](double middle, double anchor, double place, double per) {
    const double at = place + (anchor - middle) * per, aside = at - std::round(at);
    return std::abs(aside) < 1e-6 ? middle : middle + aside / per;  // the fixed ends
  };
  out.middle_x = on_pixels(out.middle_x, whole.middle_x, out.area.center().x(),
                           out.area.width() / (2.0 * out.half_x));
  out.middle_y = on_pixels(out.middle_y, whole.middle_y, out.area.center().y(),
                           -out.area.height() / (2.0 * out.half_y));
  return out;
}

/// Both axes at one scale, for any two ranges: both ranges are visible, extended as the frame
/// needs, never beyond the whole.
ChartScene::EqualAxesLayout ChartScene::selectedPlaneLayout(const EqualAxesLayout& whole) const {
  constexpr double kMost = 1.0 / kLeastPart;
  if (panel_views_.size() != 2 || !panel_views_[0] || !panel_views_[1]) return whole;
  const auto [bottom, top] = *panel_views_[0];
  const auto [left, right] = *panel_views_[1];
  const double part =
      std::max((right - left) / (2.0 * whole.half_x), (top - bottom) / (2.0 * whole.half_y));
  if (!(part < 1.0 - 1e-9) || !(right >= left) || !(top >= bottom)) return whole;
  EqualAxesLayout out = whole;
  out.enlarged = std::min(1.0 / std::max(part, 1.0 / kMost), kMost);
  out.half_x /= out.enlarged;
  out.half_y /= out.enlarged;
  const auto inside = [](double middle, double half, double of, double of_half) {
    return std::clamp(middle, of - of_half + half, of + of_half - half);
  };
  out.middle_x = inside(0.5 * (left + right), out.half_x, whole.middle_x, whole.half_x);
  out.middle_y = inside(0.5 * (bottom + top), out.half_y, whole.middle_y, whole.half_y);
  return out;
}

void ChartScene::setPlaneView(const QRectF& part) {
  if (!isPlane() || plot_areas_.empty()) return;
  setZoom({low_,
           high_,
           {std::pair(valueAt(0, part.bottom()), valueAt(0, part.top())),
            std::pair(abscissaAt(part.left()), abscissaAt(part.right()))}});
}

std::optional<QPointF> ChartScene::planePosition(double across, double up) const {
  if (!isPlane() || plot_areas_.empty() || !is_drawable(across) || !is_drawable(up))
    return std::nullopt;
  const QPointF at(sceneXAt(across), sceneYAt(0, up));
  return plot_areas_.front().contains(at) ? std::optional(at) : std::nullopt;
}

std::optional<ChartScene::PlanePoint> ChartScene::nearestPlanePoint(QPointF position,
                                                                    qreal reach) const {
  if (!isPlane() || plot_areas_.empty()) return std::nullopt;
  // In the unit of the page: no point of a long orbit is converted twice.
  const double x = abscissaAt(position.x()), y = valueAt(0, position.y());
  const double unit = std::abs(abscissaAt(position.x() + 1.0) - x);
  double least = reach * reach * unit * unit;
  std::optional<PlanePoint> out;
  const auto& curves = page_.panels.front().curves;
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (!curves[c].hidden)
      if (const auto i = plane_curves_[c].runs.nearest(x, y, least)) out = PlanePoint{c, *i, {}};
  if (!out) return out;
  const ChartCurve& curve = curves[out->curve];
  out->at = QPointF(sceneXAt(curve.x[out->index]), sceneYAt(0, curve.y[out->index]));
  return out;
}

/// The stored point near the pointer and its time, else the position of the pointer.
QStringList ChartScene::planeReadout(QPointF position) const {
  constexpr qreal kBeside = 20.0;
  if (!panelAt(position)) return {};
  const auto near = page_.closed_outline ? std::nullopt : nearestPlanePoint(position, kBeside);
  if (near) return storedPointReadout(near->curve, near->index);
  return {tr("here:   ") + planeValuesText(abscissaAt(position.x()), valueAt(0, position.y()))};
}

QString ChartScene::planeValuesText(double across, double up) const {
  const ChartPanel& panel = page_.panels.front();
  const int digits = digitsOf(0, 0);
  return tr("%1 %2, %3 %4")
      .arg(text_of(page_.x_title), text_of(pretty_quantity(across, panel.unit, digits)),
           text_of(panel.title), text_of(pretty_quantity(up, panel.unit, digits)));
}

void ChartScene::addOrbit(const Metrics& m) {
  const ChartPanel& panel = page_.panels.front();
  const EqualAxesLayout whole = fullPlaneLayout(m);
  const EqualAxesLayout seen = visiblePlaneLayout(whole);
  const QRectF& area = whole.area;
  const double half_x = seen.half_x, half_y = seen.half_y;
  const double half = std::max(half_x, half_y);
  // The numbers that are shown decide the unit of both axes, so that they share it; ticks are
  // counted over the whole range from minus to plus the largest of them.
  const double largest = seen.enlarged > 1.0 ? std::max(std::abs(seen.middle_x) + half_x,
                                                        std::abs(seen.middle_y) + half_y)
                                             : half;
  const double parts = std::clamp(
      std::min(area.width(), area.height()) * half / std::min(half_x, half_y) / 90.0, 2.0, 8.0);
  AxisScale x_axis =
      tight_axis(-largest, largest, panel.unit,
                 static_cast<int>(std::min(std::floor(parts) * largest / half, 1e6)));
  x_axis.offset = 0.0;
  AxisScale y_axis = x_axis;
  x_axis.min = x_axis.shown(seen.middle_x - half_x),
  x_axis.max = x_axis.shown(seen.middle_x + half_x);
  y_axis.min = y_axis.shown(seen.middle_y - half_y),
  y_axis.max = y_axis.shown(seen.middle_y + half_y);
  x_axis_ = x_axis;
  addFrame(area, x_axis, y_axis, with_unit(text_of(page_.x_title), x_axis),
           with_unit(text_of(panel.title), y_axis), true, true, m);
  if (page_.guide_radius > 0.0) {
    Polyline circle;
    // Equally round when enlarged: the height of a chord decreases with the square of its length.
    const int points = 180 * static_cast<int>(std::ceil(std::sqrt(seen.enlarged)));
    for (int i = 0; i <= points; ++i) {
      const double a = 2.0 * std::numbers::pi * i / points;
      circle.x.push_back(page_.guide_radius * std::cos(a));
      circle.y.push_back(page_.guide_radius * std::sin(a));
    }
    QPen pen = penOf(1, m.thin_line);
    pen.setStyle(Qt::DashLine);
    addCurve(circle, area, x_axis, y_axis, pen);
  }
  int colour = 0;
  std::vector<ShownCurve> shown;  // of outlines
  bool one_place = true;          // start and end of every curve
  for (const auto& curve : panel.curves) {
    if (curve.hidden) {
      ++colour;
      continue;
    }
    // An outline on another one is drawn dashed over it, and its name says so.
    bool on_another = false;
    if (page_.closed_outline) {
      ShownCurve one{.curve = static_cast<std::size_t>(colour), .colour = colour};
      for (const ShownCurve& before : shown) {
        const double apart = farthest_apart(panel.curves[before.curve], curve);
        if (before.hides || !(apart <= 2.0 * std::min(half_x, half_y) * kSameOutline)) continue;
        one.hides = before.curve;
        one.alike = apart <= 1e-6 * half ? Alike::Equal : Alike::Near;
        on_another = true;
        break;
      }
      shown.push_back(std::move(one));
    }
    const QPen pen = penOf(colour,
                           curve.heavy            ? 3.0 * m.line
                           : page_.closed_outline ? m.line
                                                  : m.thin_line,
                           curve.dashed || on_another);
    Polyline line, piece;  // first and last point; the part since the last gap
    const auto draw_piece = [&] {
      if (piece.x.empty()) return;
      if (page_.points) {  // a spoke and a mark each, and nothing between them
        for (std::size_t i = 0; i < piece.x.size(); ++i)
          addCurve({{0.0, piece.x[i]}, {0.0, piece.y[i]}}, area, x_axis, y_axis, pen);
        const qreal r = (on_another ? 2.0 : 3.6) * m.line;  // at the same point both are visible
        for (const QPointF& at : line_in_scene(piece, area, x_axis, y_axis, false))
          if (area.adjusted(-1, -1, 1, 1).contains(at))
            addEllipse(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r), QPen(Qt::NoPen), pen.color())
                ->setZValue(5);
        piece = {};
        return;
      }
      addCurve(piece, area, x_axis, y_axis, pen);
      piece = {};
    };
    const auto known = [&curve](std::size_t i) {
      return is_drawable(curve.x[i]) && is_drawable(curve.y[i]);
    };
    const std::size_t count = std::min(curve.x.size(), curve.y.size());
    const bool by_what_is_seen = is_long(curve) && !curve.dashed && !on_another;
    std::size_t first = 0, last = count;
    while (first < count && !known(first)) ++first;
    while (last > first && !known(last - 1)) --last;
    if (first < last) {
      line.x = {curve.x[first], curve.x[last - 1]};
      line.y = {curve.y[first], curve.y[last - 1]};
    }
    if (by_what_is_seen) {
      const double x_per = area.width() / (x_axis.max - x_axis.min),
                   y_per = -area.height() / (y_axis.max - y_axis.min);
      const PlaneScale scale{area.left() - x_axis.min * x_per, x_per / x_axis.factor,
                             area.bottom() - y_axis.min * y_per, y_per / y_axis.factor};
      addLongPath(static_cast<std::size_t>(colour),
                  {scale, QPointF(whole.middle_x, whole.middle_y), area}, pen);
    }
    for (std::size_t i = first; i < last && !by_what_is_seen; ++i) {
      if (!known(i)) {
        draw_piece();
        continue;
      }
      piece.x.push_back(curve.x[i]);
      piece.y.push_back(curve.y[i]);
    }
    draw_piece();
    ++colour;
    if (line.x.empty() || page_.closed_outline) continue;
    const auto place = [&](std::size_t i) {
      const double px = area.left() + (x_axis.shown(line.x[i]) - x_axis.min) /
                                          (x_axis.max - x_axis.min) * area.width();
      const double py = area.bottom() - (y_axis.shown(line.y[i]) - y_axis.min) /
                                            (y_axis.max - y_axis.min) * area.height();
      return QPointF(px, py);
    };
    // Distinguished by shape, for color-blind users.
    const auto mark = [&](const QPointF& at, const QColor& fill, bool square) {
      if (!area.adjusted(-1, -1, 1, 1).contains(at)) return;
      const QPen edge(theme_->surface, 1.5);
      QAbstractGraphicsShapeItem* item;
      if (square)
        item = addRect(QRectF(at.x() - 4.5, at.y() - 4.5, 9, 9), edge, fill);
      else
        item = addEllipse(QRectF(at.x() - 5, at.y() - 5, 10, 10), edge, fill);
      item->setZValue(5);
    };
    const QPointF start = place(0), end = place(line.x.size() - 1);
    constexpr qreal kSame = 1.0;
    one_place = one_place && QLineF(start, end).length() < kSame;
    mark(start, theme_->green, false);
    mark(end, theme_->red, true);
  }
  plot_areas_.push_back(area);
  y_axes_.push_back(y_axis);
  for (const ChartLabel& label : page_.labels) {
    const QPointF at(area.left() + (x_axis.shown(label.x) - x_axis.min) /
                                       (x_axis.max - x_axis.min) * area.width(),
                     area.bottom() - (y_axis.shown(label.y) - y_axis.min) /
                                         (y_axis.max - y_axis.min) * area.height());
    if (seen.enlarged > 1.0 && !area.contains(at)) continue;
    addPlaneLabel(label, at, area, m);
  }
  if (page_.closed_outline) {
    addLegend(panel, shown, area, labelsTop(area, y_axis, m), m);
    return;
  }
  auto* key = addText(QString());
  key->setFont(ui_font(m.text_font));
  key->setDefaultTextColor(theme_->muted);
  const auto entry = [](const char* sign, const QColor& ink, const char* name) {
    return QString("<span style='color:%1'>%2</span> %3").arg(ink.name(), sign, name);
  };
  QStringList entries;
  if (one_place)
    entries << entry("■", theme_->red, "start and end");
  else
    entries << entry("●", theme_->green, "start") << entry("■", theme_->red, "end");
  if (page_.guide_radius > 0.0) entries << entry("– –", theme_->curves[1], "clearance");
  key->setHtml(entries.join(" &nbsp; "));
  key->setPos(area.right() - key->boundingRect().width(),
              area.top() - key->boundingRect().height());
}

void ChartScene::addPlaneLabel(const ChartLabel& label, QPointF at, const QRectF& area,
                               const Metrics& m) {
  constexpr qreal kLeader = 26.0, kDot = 3.0;
  const QFont font = ui_font(m.text_font);
  const QFontMetricsF metrics(font);
  const QString text = text_of(label.text);
  const QPointF end = at + kLeader * QPointF(label.towards_x, -label.towards_y);
  addEllipse(QRectF(at.x() - kDot, at.y() - kDot, 2.0 * kDot, 2.0 * kDot), QPen(Qt::NoPen),
             theme_->text)
      ->setZValue(6);
  addLine(QLineF(at, end), QPen(theme_->text, 1))->setZValue(6);
  const qreal width = metrics.horizontalAdvance(text), height = metrics.height();
  const qreal left = label.towards_x > 0.0   ? end.x() + 4.0
                     : label.towards_x < 0.0 ? end.x() - width - 4.0
                                             : end.x() - 0.5 * width;
  auto* item = addSimpleText(text, font);
  item->setBrush(theme_->text);
  // Not over the surroundings of the picture.
  const qreal most_left = std::max(4.0, area.right() - width - 4.0),
              lowest = std::max(area.top(), area.bottom() - height - 2.0);
  item->setPos(std::clamp(left, std::min(area.left() + 4.0, most_left), most_left),
               std::clamp(end.y() - 0.5 * height * (1.0 + label.towards_y),
                          std::min(area.top() + 2.0, lowest), lowest));
  item->setZValue(6);
}

}  // namespace adore::desktop
