#include "desktop/chart_scene.hpp"
#include "desktop/chart_scene_parts.hpp"

#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsTextItem>

#include <cmath>
#include <limits>
#include <numbers>

/// Pages with equal axes: orbits, roses and cuts.
namespace adore::desktop {

namespace {

/// Part of the picture's height within which outlines lie on one another, as curves do.
constexpr double kSameOutline = 1.0 / 300.0;

/// Of points that belong to each other; infinite where outlines are not of the same points.
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

void ChartScene::addOrbit(const QRectF& space, const Metrics& m) {
  const ChartPanel& panel = page_.panels.front();
  Extent across, up;
  for (const auto& curve : panel.curves) {
    if (curve.hidden) continue;
    for (const double x : curve.x) across.include(x);
    for (const double y : curve.y) up.include(y);
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
  // One square that holds both ranges keeps circles round; a twelfth of margin keeps the curve off
  // the frame.
  const double middle_x = across.empty() ? 0.0 : 0.5 * (across.low + across.high);
  const double middle_y = up.empty() ? 0.0 : 0.5 * (up.low + up.high);
  double half = across.empty() || up.empty()
                    ? 1.0
                    : 0.5 * std::max(across.high - across.low, up.high - up.low);
  if (!(half > 1e-9 * std::max(std::abs(middle_x), std::abs(middle_y))))
    half = std::max({std::abs(middle_x), std::abs(middle_y), 1e-9});
  // Less than an atom's size is rounding, not a path.
  half = std::max(half, 0.5 * least_span_of(panel.unit));
  half *= 1.08;
  // A fitted page is as wide as its curves need at the scale that its height gives, or less.
  double half_x = half, half_y = half;
  if (page_.fitted && !across.empty() && !up.empty()) {
    constexpr double kMargin = 0.62;  // of the range, either side of its middle
    half_x = kMargin * (across.high - across.low);
    half_y = kMargin * (up.high - up.low);
  }
  const QSizeF most(space.width(), space.height() - m.legend);
  const qreal scale = std::min(most.width() / half_x, most.height() / half_y);
  if (page_.fitted) {  // remarks beside the curves, as far as there is room
    constexpr qreal kRemark = 180.0, kBeside = 45.0;  // dot, leader and gaps
    qreal remark = kRemark;
    const QFontMetricsF metrics(ui_font(m.text_font));
    for (const ChartLabel& label : page_.labels)
      if (label.towards_x != 0.0)
        remark = std::max(remark, kBeside + metrics.horizontalAdvance(text_of(label.text)));
    const double wanted = half_x / 1.24 + 2.0 * remark / scale;
    half_x = std::clamp(wanted, half_x, most.width() / scale);
  }
  const QSizeF size(half_x * scale, half_y * scale);
  const QRectF area(space.left() + 0.5 * (space.width() - size.width()), space.top() + m.legend,
                    size.width(), size.height());
  const int parts = std::clamp(static_cast<int>(std::min(size.width(), size.height()) * half /
                                                std::min(half_x, half_y) / 90),
                               2, 8);
  // The wider absolute range decides the unit of both axes, so that they share it.
  AxisScale x_axis = tight_axis(-half, half, panel.unit, parts);
  x_axis.offset = 0.0;
  AxisScale y_axis = x_axis;
  x_axis.min = x_axis.shown(middle_x - half_x), x_axis.max = x_axis.shown(middle_x + half_x);
  y_axis.min = y_axis.shown(middle_y - half_y), y_axis.max = y_axis.shown(middle_y + half_y);
  x_axis_ = x_axis;
  addChart(area, x_axis, y_axis, with_unit(text_of(page_.x_title), x_axis),
           with_unit(text_of(panel.title), y_axis), true, true, m);
  if (page_.guide_radius > 0.0) {
    Polyline circle;
    constexpr int kPoints = 180;
    for (int i = 0; i <= kPoints; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kPoints;
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
    // An outline that lies on another one is dashed over it, and its name says so.
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
    Polyline line, piece;  // all that is drawn, and the part since the last gap
    const auto draw_piece = [&] {
      if (piece.x.empty()) return;
      addCurve(piece, area, x_axis, y_axis,
               penOf(colour,
                     curve.heavy            ? 3.0 * m.line
                     : page_.closed_outline ? m.line
                                            : m.thin_line,
                     curve.dashed || on_another));
      piece = {};
    };
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (!is_drawable(curve.x[i]) || !is_drawable(curve.y[i])) {
        draw_piece();
        continue;
      }
      for (Polyline* to : {&line, &piece}) {
        to->x.push_back(curve.x[i]);
        to->y.push_back(curve.y[i]);
      }
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
    const auto dot = [&](const QPointF& at, const QColor& fill) {
      addEllipse(QRectF(at.x() - 5, at.y() - 5, 10, 10), QPen(theme_->surface, 1.5), fill)
          ->setZValue(5);
    };
    const QPointF start = place(0), end = place(line.x.size() - 1);
    constexpr qreal kSame = 1.0;
    one_place = one_place && QLineF(start, end).length() < kSame;
    dot(start, theme_->green);
    dot(end, theme_->red);
  }
  areas_.push_back(area);
  y_axes_.push_back(y_axis);
  for (const ChartLabel& label : page_.labels) {
    const QPointF at(area.left() + (x_axis.shown(label.x) - x_axis.min) /
                                       (x_axis.max - x_axis.min) * area.width(),
                     area.bottom() - (y_axis.shown(label.y) - y_axis.min) /
                                         (y_axis.max - y_axis.min) * area.height());
    addRemark(label, at, area, m);
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
    entries << entry("●", theme_->red, "start and end");
  else
    entries << entry("●", theme_->green, "start") << entry("●", theme_->red, "end");
  if (page_.guide_radius > 0.0) entries << entry("– –", theme_->curves[1], "clearance");
  key->setHtml(entries.join(" &nbsp; "));
  key->setPos(area.right() - key->boundingRect().width(),
              area.top() - key->boundingRect().height());
}

void ChartScene::addRemark(const ChartLabel& label, QPointF at, const QRectF& area,
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
  // Not over what stands around the picture.
  const qreal most_left = std::max(4.0, area.right() - width - 4.0),
              lowest = std::max(area.top(), area.bottom() - height - 2.0);
  item->setPos(std::clamp(left, std::min(area.left() + 4.0, most_left), most_left),
               std::clamp(end.y() - 0.5 * height * (1.0 + label.towards_y),
                          std::min(area.top() + 2.0, lowest), lowest));
  item->setZValue(6);
}

}  // namespace adore::desktop
