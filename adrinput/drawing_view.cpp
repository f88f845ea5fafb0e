#include "adrinput/drawing_view.hpp"

#include "adrinput/drawing_layout.hpp"
#include "adrinput/drawing_marks.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/picture_marks.hpp"
#include "desktop/theme.hpp"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace adore::adrinput {
namespace {

using desktop::Theme;
using drawing::Part;
using Style = drawing::Shape::Style;

constexpr double kMargin = 10.0;  // around everything, px
constexpr double kTitle = 20.0;   // height of a figure's title, px
constexpr double kNear = 7.0;     // how near a click must be, px

QColor body_colour(const Theme& t, Part part) {
  const bool dark = t.kind == desktop::ThemeKind::Dark;
  switch (part) {
    case Part::Shaft:
    case Part::Housing:
      return dark ? t.raised.lighter(115) : t.raised;
    case Part::Cage:
      return t.cage;
    case Part::Element:
      return dark ? t.steel_light : t.steel_light.lighter(108);
    default:
      return dark ? t.steel_dark : t.steel_dark.lighter(118);
  }
}

}  // namespace

QPainterPath path_of(const drawing::Shape& shape, const QTransform& place, bool close) {
  QPainterPath path;
  for (const drawing::Path& points : shape.paths) {
    if (points.empty()) continue;
    QPolygonF polygon;
    for (const drawing::Point& p : points) polygon << place.map(QPointF(p.x, p.y));
    path.addPolygon(polygon);
    if (close) path.closeSubpath();
  }
  for (const drawing::Circle& circle : shape.circles) {
    const QPointF centre = place.map(QPointF(circle.centre.x, circle.centre.y));
    const double rx = circle.radius * std::abs(place.m11()),
                 ry = circle.radius * std::abs(place.m22());
    path.addEllipse(centre, rx, ry);
  }
  return path;
}

DrawingView::DrawingView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(130, 140);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Drawing of the bearing"));
}

QSize DrawingView::sizeHint() const { return {364, 520}; }

void DrawingView::setDrawing(drawing::Drawing drawing, const QString& stale) {
  const bool same_view =
      drawing.view == drawing_.view && drawing.panes.size() == drawing_.panes.size();
  drawing_ = std::move(drawing);
  stale_ = stale;
  if (!same_view) zooms_.clear();
  zooms_.resize(drawing_.panes.size());
  setFocusOn(focus_);
}

void DrawingView::setFocusOn(DrawingFocus focus) {
  focus_ = std::move(focus);
  focused_parts_ = drawing::parts_of(focus_.record, focus_.variable);
  focus_has_dimension_ = false;
  for (const drawing::Pane& pane : drawing_.panes) {
    focus_has_dimension_ = focus_has_dimension_ ||
                           std::any_of(pane.dimensions.begin(), pane.dimensions.end(),
                                       [&](const auto& dimension) { return inFocus(dimension); }) ||
                           std::any_of(pane.arrows.begin(), pane.arrows.end(),
                                       [&](const auto& arrow) { return inFocus(arrow); });
  }
  update();
}

void DrawingView::setFocusLabel(const QString& label) {
  focus_label_ = label;
  update();
}

bool DrawingView::isDimensionVisible(const drawing::Dimension& d) const {
  return isInFocusedRecord(d.variable) && (inFocus(d) || !d.minor);
}

bool DrawingView::inFocus(const drawing::Dimension& d) const {
  return d.variable == focus_.variable && d.instance == focus_.instance;
}

bool DrawingView::inFocus(const drawing::Arrow& arrow) const {
  return arrow.variable == focus_.variable;
}

bool DrawingView::inFocus(const drawing::Shape& shape) const {
  if (focus_.variable.empty()) return false;
  if (std::find(shape.shows.begin(), shape.shows.end(), focus_.variable) != shape.shows.end())
    return true;
  return shape.style != Style::Strong && std::find(focused_parts_.begin(), focused_parts_.end(),
                                                   shape.part) != focused_parts_.end();
}

bool DrawingView::isInFocusedRecord(const std::string& variable) const {
  const deck::RecordSpec* spec = deck::find_record(focus_.record);
  return spec != nullptr &&
         std::any_of(spec->variables.begin(), spec->variables.end(),
                     [&](const deck::VariableSpec& v) { return v.name == variable; });
}

QTransform DrawingView::fitTransform(const drawing::Pane& pane, const QRectF& area) const {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  const auto take = [&](const drawing::Point& p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  };
  if (!pane.axes.empty()) {
    take({pane.axes[0].low, pane.axes[1].low});
    take({pane.axes[0].high, pane.axes[1].high});
  } else if (!pane.window.empty()) {
    for (const drawing::Point& p : pane.window) take(p);
  } else {
    for (const drawing::Shape& shape : pane.shapes) {
      for (const drawing::Path& path : shape.paths)
        for (const drawing::Point& p : path) take(p);
      for (const drawing::Circle& c : shape.circles) {
        take({c.centre.x - c.radius, c.centre.y - c.radius});
        take({c.centre.x + c.radius, c.centre.y + c.radius});
      }
    }
    for (const drawing::Caption& caption : pane.captions) take(caption.at);
    for (const drawing::Arrow& arrow : pane.arrows)
      for (const drawing::Point& p : arrow.path) take(p);
    for (const drawing::Dimension& d : pane.dimensions)
      if (isInFocusedRecord(d.variable)) {
        take(d.from);
        take(d.to);
      }
  }
  if (!(right > left) || !(high > low)) return {};
  double sx = area.width() / (right - left), sy = area.height() / (high - low);
  if (pane.axes.empty()) sx = sy = std::min(sx, sy);
  const QPointF middle = area.center();
  return {sx,
          0.0,
          0.0,
          -sy,
          middle.x() - sx * 0.5 * (left + right),
          middle.y() + sy * 0.5 * (low + high)};
}

void DrawingView::layOut() {
  pane_layouts_.clear();
  double total = 0.0, foot = 0.0;
  for (const drawing::Pane& pane : drawing_.panes) total += pane.share;
  const QFontMetricsF metrics(desktop::ui_font(kText));
  QString remarks;
  for (const std::string& remark : drawing_.remarks) remarks += text_of(remark) + "\n";
  if (!remarks.isEmpty())
    foot = metrics
               .boundingRect(QRectF(0, 0, width() - 2 * kMargin, height()), Qt::TextWordWrap,
                             remarks.trimmed())
               .height() +
           6.0;
  const double usable = height() - 2 * kMargin - foot;
  double y = kMargin;
  for (std::size_t i = 0; i < drawing_.panes.size(); ++i) {
    const drawing::Pane& pane = drawing_.panes[i];
    const double share = usable * pane.share / total;
    QRectF area(kMargin, y + kTitle, width() - 2 * kMargin, share - kTitle);
    y += share;
    PaneLayout frame;
    frame.area = area;
    const QRectF inner = pane.axes.empty() ? area.adjusted(16, 16, -16, -16)
                                           : area.adjusted(kAxisLeft, 8, -10, -kAxisBottom);
    frame.place = fitTransform(pane, inner);
    if (pane.axes.empty() && i < zooms_.size()) {
      const Zoom& z = zooms_[i];
      const QPointF c = inner.center();
      frame.place *= QTransform::fromTranslate(-c.x(), -c.y()) *
                     QTransform::fromScale(z.scale, z.scale) *
                     QTransform::fromTranslate(c.x() + z.shift.x(), c.y() + z.shift.y());
    }
    pane_layouts_.push_back(frame);
  }
}

void DrawingView::paintEvent(QPaintEvent*) {
  const Theme& t = desktop::current_theme();
  labels_.clear();
  layOut();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), t.surface);
  painter.setPen(QPen(t.frame, 1));
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  const bool old = !stale_.isEmpty() && !drawing_.panes.empty();
  painter.setOpacity(old ? 0.3 : 1.0);
  for (std::size_t i = 0; i < drawing_.panes.size(); ++i) {
    painter.save();
    paintPane(painter, drawing_.panes[i], pane_layouts_[i]);
    painter.restore();
  }
  painter.setOpacity(1.0);
  painter.setFont(desktop::ui_font(kText));
  if (!drawing_.remarks.empty() && !old) {
    QString remarks;
    for (const std::string& remark : drawing_.remarks) remarks += text_of(remark) + "\n";
    painter.setPen(t.muted);
    painter.drawText(QRectF(rect()).adjusted(kMargin, 0, -kMargin, -kMargin + 2),
                     Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, remarks.trimmed());
  }
  if (stale_.isEmpty()) return;
  const QString text = (old ? tr("Last valid drawing. ") : QString()) + stale_;
  painter.setFont(desktop::ui_font(12));
  const QRectF room = QRectF(rect()).adjusted(24, 24, -24, -24);
  const QRectF box =
      QFontMetricsF(painter.font()).boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, text);
  painter.setPen(QPen(t.red, 1));
  painter.setBrush(t.surface);
  painter.drawRoundedRect(box.adjusted(-10, -8, 10, 8), 4, 4);
  painter.setPen(t.text);
  painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, text);
}

void DrawingView::paintPane(QPainter& painter, const drawing::Pane& pane, const PaneLayout& frame) {
  const Theme& t = desktop::current_theme();
  painter.setPen(t.muted);
  const QRectF title(frame.area.left(), frame.area.top() - kTitle, frame.area.width(), kTitle);
  const QString text = text_of(pane.title);
  // In a narrow pane smaller letters before any are left out.
  constexpr int kLeast = 8;
  for (int letters = kText; letters >= kLeast; --letters) {
    painter.setFont(desktop::ui_font(letters, true));
    if (QFontMetricsF(painter.font()).horizontalAdvance(text) <= title.width()) break;
  }
  painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetricsF(painter.font()).elidedText(text, Qt::ElideRight, title.width()));
  painter.setClipRect(frame.area);
  if (!pane.axes.empty()) paintAxes(painter, pane, frame);
  // The outline of the part in focus is drawn last among its kind.
  for (const drawing::Shape& shape : pane.shapes) paintShape(painter, shape, frame.place);
  for (const drawing::Arrow& arrow : pane.arrows)
    if (arrow.value != 0.0 || inFocus(arrow)) paintArrow(painter, arrow, frame.place);
  for (const bool focused : {false, true})
    for (const drawing::Dimension& d : pane.dimensions)
      if (isDimensionVisible(d) && inFocus(d) == focused &&
          (focused || marks::needs_label(d, frame.place)) &&
          (focused || d.kind != drawing::Dimension::Kind::Leader))
        paintDimension(painter, d, frame.place);
  writeLabels(painter, pane, frame);
}

void DrawingView::paintAxes(QPainter& painter, const drawing::Pane& pane, const PaneLayout& frame) {
  const Theme& t = desktop::current_theme();
  painter.setFont(desktop::ui_font(kText));
  const QFontMetricsF metrics(painter.font());
  const drawing::ChartAxis &x = pane.axes[0], &y = pane.axes[1];
  const QRectF box =
      QRectF(frame.place.map(QPointF(x.low, y.high)), frame.place.map(QPointF(x.high, y.low)));
  const auto ticks = [](const drawing::ChartAxis& axis, int parts) {
    const double step = desktop::nice_step((axis.high - axis.low) / axis.factor, parts);
    return std::pair(step, std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))));
  };
  const auto [dx, x_decimals] = ticks(x, 4);
  for (double v = std::ceil(x.low / x.factor / dx - 1e-9) * dx; v <= x.high / x.factor + 1e-9 * dx;
       v += dx) {
    const double px = frame.place.map(QPointF(v * x.factor, 0.0)).x();
    painter.setPen(QPen(t.grid, 1));
    painter.drawLine(QPointF(px, box.top()), QPointF(px, box.bottom()));
    painter.setPen(t.muted);
    const QString text = text_of(desktop::tick_text(v, x_decimals));
    painter.drawText(QPointF(px - 0.5 * metrics.horizontalAdvance(text), box.bottom() + 14), text);
  }
  const auto [dy, y_decimals] = ticks(y, 4);
  for (double v = std::ceil(y.low / y.factor / dy - 1e-9) * dy; v <= y.high / y.factor + 1e-9 * dy;
       v += dy) {
    const double py = frame.place.map(QPointF(0.0, v * y.factor)).y();
    painter.setPen(QPen(t.grid, 1));
    painter.drawLine(QPointF(box.left(), py), QPointF(box.right(), py));
    painter.setPen(t.muted);
    const QString text = text_of(desktop::tick_text(v, y_decimals));
    painter.drawText(QPointF(box.left() - 6 - metrics.horizontalAdvance(text), py + 4), text);
  }
  painter.setPen(QPen(t.frame, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box);
  painter.setPen(t.text);
  const auto title = [](const drawing::ChartAxis& axis) {
    return text_of(axis.title) + (axis.unit.empty() ? QString() : " [" + text_of(axis.unit) + "]");
  };
  painter.drawText(QRectF(box.left(), box.bottom() + 18, box.width(), 18), Qt::AlignCenter,
                   title(x));
  painter.save();
  painter.translate(frame.area.left() + 9, box.center().y());
  painter.rotate(-90);
  painter.drawText(QRectF(-0.5 * box.height(), -8, box.height(), 16), Qt::AlignCenter, title(y));
  painter.restore();
}

void DrawingView::paintShape(QPainter& painter, const drawing::Shape& shape,
                             const QTransform& place) {
  const Theme& t = desktop::current_theme();
  const bool focused = inFocus(shape);
  const bool area =
      shape.style == Style::Cut || shape.style == Style::Body || shape.style == Style::Behind;
  const QPainterPath path = path_of(shape, place, area);
  const QColor body = body_colour(t, shape.part);
  const bool dark = t.kind == desktop::ThemeKind::Dark;
  QColor line = dark ? body.lighter(150) : body.darker(160);
  QColor fill = body;
  if (shape.style == Style::Behind) fill.setAlpha(90);
  if (focused && area && shape.part != Part::Cage) {
    const double mix = 0.35;
    fill = QColor::fromRgbF(static_cast<float>((1 - mix) * fill.redF() + mix * t.accent.redF()),
                            static_cast<float>((1 - mix) * fill.greenF() + mix * t.accent.greenF()),
                            static_cast<float>((1 - mix) * fill.blueF() + mix * t.accent.blueF()),
                            fill.alphaF());
  }
  if (area) {
    if (shape.style == Style::Body && shape.circles.size() == 1 && shape.paths.empty()) {
      const QPointF c = place.map(QPointF(shape.circles[0].centre.x, shape.circles[0].centre.y));
      painter.setBrush(desktop::ball_brush(c, shape.circles[0].radius * place.m11(),
                                           fill.lighter(125), fill, fill.darker(130)));
    } else {
      painter.setBrush(fill);
    }
    painter.setPen(QPen(focused ? t.accent : line, focused ? 2.6 : 1.1));
    painter.drawPath(path);
    if (shape.style == Style::Cut && shape.part != Part::Cage) {
      QColor hatch = focused ? t.accent : line;
      hatch.setAlpha(70);
      marks::hatch(painter, path, hatch,
                   shape.part == Part::InnerRing || shape.part == Part::Housing);
    }
    return;
  }
  QColor colour = focused ? t.accent : shape.part == Part::Construction ? t.muted : line;
  if (shape.part == Part::Curve) colour = focused ? t.accent : t.muted;
  QPen pen(colour, focused ? 2.4 : 1.2);
  if (shape.style == Style::Dashed) pen.setStyle(Qt::DashDotLine);
  if (shape.style == Style::Strong) pen.setWidthF(focused ? 4.0 : 2.4);
  pen.setCapStyle(Qt::FlatCap);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
}

void DrawingView::paintArrow(QPainter& painter, const drawing::Arrow& arrow,
                             const QTransform& place) {
  const Theme& t = desktop::current_theme();
  const bool focused = inFocus(arrow);
  QPolygonF line;
  for (const drawing::Point& p : arrow.path) line << place.map(QPointF(p.x, p.y));
  marks::arrow(painter, line, focused ? t.accent : marks::arrow_colour(t, arrow.kind),
               focused ? 3.4 : 2.4, arrow.value == 0.0);
}

void DrawingView::paintDimension(QPainter& painter, const drawing::Dimension& d,
                                 const QTransform& place) {
  const Theme& t = desktop::current_theme();
  const bool focused = inFocus(d);
  const QColor colour = focused ? t.accent : t.muted;
  marks::dimension(painter, d, place, colour, focused ? 2.0 : 0.9);
}

int DrawingView::paneAt(QPointF position) const {
  for (std::size_t i = 0; i < pane_layouts_.size(); ++i)
    if (pane_layouts_[i].area.contains(position)) return static_cast<int>(i);
  return -1;
}

const drawing::Dimension* DrawingView::dimensionAt(QPointF position) const {
  const int pane = paneAt(position);
  if (pane < 0) return nullptr;
  const auto i = static_cast<std::size_t>(pane);
  const drawing::Dimension* nearest = nullptr;
  double best = kNear;
  for (const drawing::Dimension& d : drawing_.panes[i].dimensions) {
    if (!isDimensionVisible(d)) continue;
    const double distance = marks::distance(d, pane_layouts_[i].place, position);
    if (distance >= best) continue;
    best = distance;
    nearest = &d;
  }
  return nearest;
}

bool DrawingView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const drawing::Dimension* d = dimensionAt(help->pos());
    if (d != nullptr)
      QToolTip::showText(help->globalPos(), text_of(d->label), this);
    else
      QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

void DrawingView::wheelEvent(QWheelEvent* event) {
  const int pane = paneAt(event->position());
  if (pane < 0 || !drawing_.panes[static_cast<std::size_t>(pane)].axes.empty())
    return event->ignore();
  Zoom& zoom = zooms_[static_cast<std::size_t>(pane)];
  const double factor = std::pow(1.0015, event->angleDelta().y());
  const double scale = std::clamp(zoom.scale * factor, 1.0, 2000.0);
  const double by = scale / zoom.scale;
  const QPointF middle =
      pane_layouts_[static_cast<std::size_t>(pane)].area.adjusted(16, 16, -16, -16).center();
  const QPointF from = event->position() - middle;
  zoom.shift = scale == 1.0 ? QPointF() : from - (from - zoom.shift) * by;
  zoom.scale = scale;
  event->accept();
  update();
}

void DrawingView::mousePressEvent(QMouseEvent* event) {
  press_position_ = last_drag_position_ = event->position();
  dragging_ = false;
}

void DrawingView::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  if ((event->position() - press_position_).manhattanLength() > 5) dragging_ = true;
  const int pane = paneAt(press_position_);
  if (dragging_ && pane >= 0 && zooms_[static_cast<std::size_t>(pane)].scale > 1.0) {
    zooms_[static_cast<std::size_t>(pane)].shift += event->position() - last_drag_position_;
    update();
  }
  last_drag_position_ = event->position();
}

void DrawingView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_ || event->button() != Qt::LeftButton) return;
  if (const drawing::Dimension* d = dimensionAt(event->position()))
    emit dimensionClicked(text_of(d->variable), d->instance, d->index);
}

void DrawingView::mouseDoubleClickEvent(QMouseEvent*) {
  std::fill(zooms_.begin(), zooms_.end(), Zoom());
  update();
}

}  // namespace adore::adrinput
