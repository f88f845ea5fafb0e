#include "desktop/chart_view.hpp"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QRubberBand>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace adore::desktop {
namespace {

constexpr std::size_t kMostViews = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr int kQuantityDigits = 5;

QString quantity(double value, const std::string& unit, int digits = kQuantityDigits) {
  return QString::fromStdString(pretty_quantity(value, unit, digits));
}

/// The same for a page that is read again.
std::string name_of(const ChartPage& page) {
  std::string name = page.title + '\n' + page.subtitle;
  if (page.equal_axes) name += '\n' + page.x_title;
  for (const ChartPanel& panel : page.panels) {
    name += '\n' + panel.title + " [" + panel.unit + ']';
    for (const ChartCurve& curve : panel.curves) name += '\n' + curve.name;
  }
  return name;
}

std::string abscissa_of(const ChartPage& page) { return page.x_title + " [" + page.x_unit + ']'; }

/// Values of the cursors: the abscissa, for an orbit that of its points.
const std::vector<double>& cursor_places(const ChartPage& page) {
  return page.equal_axes ? page.along : page.x;
}
std::string cursor_axis(const ChartPage& page) {
  return page.equal_axes ? page.along_title + " [" + page.along_unit + ']' : abscissa_of(page);
}

}  // namespace

ChartView::ChartView(QWidget* parent)
    : QGraphicsView(parent), scene_(new ChartScene(ChartStyle::Page, this)) {
  setScene(scene_);
  scene_->setInteractive(true);
  setFrameShape(QFrame::NoFrame);
  setRenderHint(QPainter::Antialiasing);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  setMouseTracking(true);
  setMinimumSize(360, 300);
  setAccessibleName(tr("Chart"));
  band_ = new QRubberBand(QRubberBand::Rectangle, viewport());
}

void ChartView::showPage(ChartPage page) {
  constexpr std::size_t kMostPages = 1000;
  const ChartPage& old = scene_->page();
  const bool same_axis = cursor_axis(page) == cursor_axis(old);
  if (!same_axis) cursors_ = {kNone, kNone};
  const double read_at = reading_ && same_axis ? abscissaOf(*reading_) : kNone;
  reading_.reset();
  if (name_of(page) != name_of(old)) panel_ = 0;
  if (panel_ >= page.panels.size()) panel_ = 0;
  key_move_active_ = false;
  panel_value_ranges_.clear();
  pointer_line_x_ = -1.0;  // its values are of the page before
  hovered_plane_point_.reset();
  pointer_position_.reset();
  ranges_ = now().ranges;
  if (hidden_curves_.size() > kMostPages) hidden_curves_.clear();
  auto& hidden = hidden_curves_[name_of(old)];
  hidden.clear();
  for (std::size_t p = 0; p < old.panels.size(); ++p)
    for (std::size_t c = 0; c < old.panels[p].curves.size(); ++c)
      if (old.panels[p].curves[c].hidden) hidden.emplace(p, c);
  for (const auto& [p, c] : hidden_curves_[name_of(page)])
    if (p < page.panels.size() && c < page.panels[p].curves.size())
      page.panels[p].curves[c].hidden = true;
  scene_->setPage(std::move(page), true);
  const auto own = ranges_.find(name_of(scene_->page()));
  if (own != ranges_.end()) scene_->setZoom({scene_->viewLow(), scene_->viewHigh(), own->second});
  if (const auto& places = cursor_places(scene_->page()); std::isfinite(read_at) && !places.empty())
    reading_ = StoredPoint{0, nearest_index(places, read_at)};
  if (!reading_) setAccessibleDescription(QString::fromStdString(scene_->page().title));
  emit cursorsChanged();
  read();
  viewport()->update();
}

ChartView::View ChartView::now() const {
  const ChartZoom zoom = scene_->zoom();
  View out{abscissa_of(scene_->page()), zoom.low, zoom.high, ranges_};
  const std::string page = name_of(scene_->page());
  if (std::any_of(zoom.panels.begin(), zoom.panels.end(),
                  [](const auto& range) { return range.has_value(); }))
    out.ranges[page] = zoom.panels;
  else
    out.ranges.erase(page);
  return out;
}

void ChartView::apply(const View& view) {
  ranges_ = view.ranges;
  const bool same = view.abscissa == abscissa_of(scene_->page());
  const auto own = ranges_.find(name_of(scene_->page()));
  scene_->setZoom({same ? view.low : scene_->viewLow(), same ? view.high : scene_->viewHigh(),
                   own == ranges_.end() ? Ranges{} : own->second});
  read();
}

void ChartView::remember() {
  key_move_active_ = false;
  View view = now();
  if (!back_views_.empty() && back_views_.back() == view) return;
  back_views_.push_back(std::move(view));
  if (back_views_.size() > kMostViews) back_views_.erase(back_views_.begin());
  forward_views_.clear();
}

/// Views without effect here are skipped; they are kept if no other one has an effect, for the page
/// where they have one.
void ChartView::travel(std::vector<View>& from, std::vector<View>& to) {
  const View left = now();
  const ChartZoom seen = scene_->zoom();
  for (std::size_t i = from.size(); i-- > 0;) {
    const View view = from[i];
    apply(view);
    if (scene_->zoom() == seen) continue;
    from.resize(i);
    to.push_back(left);
    key_move_active_ = false;
    viewport()->update();
    return;
  }
  apply(left);
}

void ChartView::zoomBack() { travel(back_views_, forward_views_); }

void ChartView::zoomForward() { travel(forward_views_, back_views_); }

/// Everything; a second time, if a page begins with a part: that part.
void ChartView::zoomAll() {
  if (scene_->whole() && !scene_->zoomed()) return;
  remember();
  if (scene_->whole())
    scene_->resetView();
  else
    scene_->showAll();
  read();
}

void ChartView::setCursorAbscissa(int which, double abscissa) {
  const auto& x = cursor_places(scene_->page());
  // On a stored value: the readout is a value of the file.
  cursors_.at(static_cast<std::size_t>(which)) =
      x.empty() || !std::isfinite(abscissa) ? kNone : x[nearest_index(x, abscissa)];
  emit cursorsChanged();
  viewport()->update();
}

void ChartView::clearCursors() {
  cursors_ = {kNone, kNone};
  if (reading_) endReading();
  emit cursorsChanged();
  read();
  viewport()->update();
}

namespace {

/// Minimum and maximum of the extremes between two points; no value without extremes.
std::optional<std::pair<double, double>> band_between(const std::vector<double>& x,
                                                      const ChartCurve& curve, double a, double b) {
  std::optional<std::pair<double, double>> out;
  const auto [from, to] = std::minmax(a, b);
  const std::size_t count = std::min({x.size(), curve.low.size(), curve.high.size()});
  // Extremes are at the end of their interval.
  for (std::size_t i = 1; i < count; ++i) {
    const auto [begin, end] = std::minmax(x[i - 1], x[i]);
    if (begin < from || end > to || !std::isfinite(curve.low[i]) || !std::isfinite(curve.high[i]))
      continue;
    if (!out) out.emplace(curve.low[i], curve.high[i]);
    out->first = std::min(out->first, curve.low[i]);
    out->second = std::max(out->second, curve.high[i]);
  }
  return out;
}

}  // namespace

QString ChartView::cursorReport() const {
  const ChartPage& page = scene_->page();
  const bool a = std::isfinite(cursors_[0]), b = std::isfinite(cursors_[1]);
  if ((!a && !b) || cursor_places(page).empty()) return {};
  const std::string& unit = page.equal_axes ? page.along_unit : page.x_unit;
  QStringList lines;
  QString head;
  if (a) head += tr("A: %1").arg(quantity(cursors_[0], unit));
  if (b) head += tr("%1B: %2").arg(a ? "   " : "", quantity(cursors_[1], unit));
  if (a && b) {
    const double gap = cursors_[1] - cursors_[0];
    head += tr("   B − A: %1").arg(quantity(gap, unit));
    if (unit == "s" && gap != 0.0)
      head += tr("   1/(B − A): %1").arg(quantity(1.0 / std::abs(gap), "Hz"));
  }
  lines << head;
  if (page.equal_axes) return (lines << planeReport()).join('\n');
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    if (page.panels[p].rows) {
      lines << mapReport(page.panels[p]);
      continue;
    }
    for (std::size_t c = 0; c < page.panels[p].curves.size(); ++c) {
      const ChartPanel& panel = page.panels[p];
      const ChartCurve& curve = panel.curves[c];
      const bool any =
          std::any_of(curve.y.begin(), curve.y.end(), [](double v) { return std::isfinite(v); });
      if (curve.hidden || !any) continue;
      const bool named = curve.name.starts_with(panel.title);
      QString line = QString::fromStdString(!curve.brief.empty() ? curve.brief
                                            : curve.name.empty() ? panel.title
                                            : named              ? curve.name
                                                    : panel.title + ", " + curve.name) +
                     ":";
      const auto value = [&](double x) {
        const std::size_t i = nearest_index(page.x, x);
        return i < curve.y.size() ? curve.y[i] : kNone;
      };
      const int digits = scene_->digitsOf(p, c);
      if (a) line += tr("  A %1").arg(quantity(value(cursors_[0]), panel.unit, digits));
      if (b) line += tr("  B %1").arg(quantity(value(cursors_[1]), panel.unit, digits));
      if (a && b) {
        const CurveStatistics s = statistics_between(page.x, curve.y, cursors_[0], cursors_[1]);
        line += tr("  B − A %1").arg(quantity(value(cursors_[1]) - value(cursors_[0]), panel.unit));
        if (s.count > 0)
          line +=
              tr("  min %1  max %2  mean %3  RMS %4")
                  .arg(quantity(s.lowest, panel.unit, digits),
                       quantity(s.highest, panel.unit, digits),
                       quantity(s.mean, panel.unit, digits), quantity(s.rms, panel.unit, digits));
        // A curve that ends between the cursors, such as that of a shorter run.
        const auto [from, to] = std::minmax(cursors_[0], cursors_[1]);
        if (s.count > 0 && (s.first > from || s.last < to))
          line += tr(" (%1 to %2)").arg(quantity(s.first, unit), quantity(s.last, unit));
        if (const auto band = band_between(page.x, curve, cursors_[0], cursors_[1]))
          line += tr("  band %1 to %2")
                      .arg(quantity(band->first, panel.unit, digits),
                           quantity(band->second, panel.unit, digits));
      }
      lines << line;
    }
  }
  return lines.join('\n');
}

/// The largest value of a map at each cursor, and its row.
QString ChartView::mapReport(const ChartPanel& panel) const {
  QString out = QString::fromStdString(panel.title) + ":";
  for (const auto& [name, at] : {std::pair("A", cursors_[0]), std::pair("B", cursors_[1])}) {
    if (!std::isfinite(at)) continue;
    const std::size_t i = nearest_index(scene_->page().x, at);
    std::size_t best = 0;
    for (std::size_t r = 0; r < panel.curves.size(); ++r)
      if (panel.curves[r].y[i] > panel.curves[best].y[i]) best = r;
    out += tr("  %1 maximum %2 at %3")
               .arg(QString(name), quantity(panel.curves[best].y[i], panel.unit, 5),
                    quantity(panel.rows->at[best], panel.rows->unit));
  }
  return out;
}

/// Both coordinates of an orbit at the cursors, and how far apart these are.
QString ChartView::planeReport() const {
  const ChartPage& page = scene_->page();
  const ChartPanel& panel = page.panels.front();
  const ChartCurve& curve = panel.curves.front();
  const bool a = std::isfinite(cursors_[0]), b = std::isfinite(cursors_[1]);
  const int digits = scene_->digitsOf(0, 0);
  const auto at = [&](const std::vector<double>& values, std::size_t which) {
    const std::size_t i = nearest_index(page.along, cursors_.at(which));
    return i < values.size() ? values[i] : kNone;
  };
  QStringList lines;
  const auto line = [&](const std::string& title, const std::vector<double>& values) {
    QString text = QString::fromStdString(title) + ":";
    if (a) text += tr("  A %1").arg(quantity(at(values, 0), panel.unit, digits));
    if (b) text += tr("  B %1").arg(quantity(at(values, 1), panel.unit, digits));
    if (a && b) text += tr("  B − A %1").arg(quantity(at(values, 1) - at(values, 0), panel.unit));
    lines << text;
  };
  line(page.x_title, curve.x);
  line(panel.title, curve.y);
  if (a && b)
    lines << tr("A to B:  %1")
                 .arg(quantity(
                     std::hypot(at(curve.x, 1) - at(curve.x, 0), at(curve.y, 1) - at(curve.y, 0)),
                     panel.unit));
  return lines.join('\n');
}

std::optional<QPointF> ChartView::planeCursor(std::size_t which) const {
  const ChartPage& page = scene_->page();
  if (!page.equal_axes || page.along.empty() || !std::isfinite(cursors_.at(which))) return {};
  const ChartCurve& curve = page.panels.front().curves.front();
  const std::size_t i = nearest_index(page.along, cursors_.at(which));
  if (i >= std::min(curve.x.size(), curve.y.size())) return {};
  return scene_->planePosition(curve.x[i], curve.y[i]);
}

void ChartView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  scene_->setPageSize(viewport()->size());
  read();
}

void ChartView::wheelEvent(QWheelEvent* event) {
  const QPointF position = mapToScene(event->position().toPoint());
  // A horizontal wheel, or Alt, swaps the axes on some desktops.
  const double turn =
      event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  const double factor = std::pow(0.8, turn / 120.0);
  const auto panel = scene_->panelAt(position);
  remember();
  if (scene_->isPlane()) {
    // At the pointer, or the nearest point of the picture.
    const QRectF area = scene_->plotAreas().front();
    const QPointF about(std::clamp(position.x(), area.left(), area.right()),
                        std::clamp(position.y(), area.top(), area.bottom()));
    scene_->setPlaneView({about + factor * (area.topLeft() - about), factor * area.size()});
  } else if ((event->modifiers() & Qt::ControlModifier) != 0 && panel &&
             !scene_->page().equal_axes) {
    const QRectF& area = scene_->plotAreas()[*panel];
    // In pixels, so that a logarithmic axis zooms like any other.
    const double low = position.y() + (area.bottom() - position.y()) * factor,
                 high = position.y() - (position.y() - area.top()) * factor;
    scene_->setPanelView(*panel,
                         std::pair(scene_->valueAt(*panel, low), scene_->valueAt(*panel, high)));
  } else if (!scene_->plotAreas().empty() && !scene_->page().equal_axes) {
    const QRectF& area = scene_->plotAreas().front();
    scene_->setView(scene_->abscissaAt(position.x() - (position.x() - area.left()) * factor),
                    scene_->abscissaAt(position.x() + (area.right() - position.x()) * factor));
  }
  read();
  event->accept();
}

namespace {

/// Ctrl: cursor A, Ctrl+Shift: cursor B, at the stored point nearest to a position.
void place_cursor(ChartView& view, QPointF position, Qt::KeyboardModifiers held) {
  const int which = held.testFlag(Qt::ShiftModifier) ? 1 : 0;
  constexpr qreal kAnywhere = 1e9;
  const ChartScene& scene = view.chartScene();
  if (!scene.panelAt(position)) return;
  const ChartPage& page = scene.page();
  if (!page.equal_axes)
    view.setCursorAbscissa(which, scene.abscissaAt(position.x()));
  else if (const auto point = scene.nearestPlanePoint(position, kAnywhere);
           point && point->index < page.along.size())
    view.setCursorAbscissa(which, page.along[point->index]);
}

}  // namespace

void ChartView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF position = mapToScene(event->position().toPoint());
  if (scene_->page().study) {
    if (const std::vector<long> runs = scene_->runsAt(position); !runs.empty())
      emit runsChosen(runs);
    return;
  }
  // Click for a cursor: the content under the mouse may just have moved.
  const bool for_cursor = (event->modifiers() & Qt::ControlModifier) != 0;
  press_position_ = event->position().toPoint();
  if (!for_cursor) {
    pressed_legend_entry_ = legendAt(position);
    pressed_title_panel_ = drop_types_.isEmpty() ? std::nullopt : panelTitleAt(position);
    if (pressed_legend_entry_ || pressed_title_panel_) return;
  }
  if (for_cursor) return place_cursor(*this, position, event->modifiers());
  if ((event->modifiers() & Qt::ShiftModifier) != 0) {
    zoom_box_active_ = true;
    zoom_box_start_ = event->position().toPoint();
    band_->setGeometry(QRect(zoom_box_start_, QSize()));
    band_->show();
    return;
  }
  dragging_ = true;
  remember();
  drag_start_x_ = scene_->abscissaAt(position.x());
  last_ = position;
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = mapToScene(event->position().toPoint());
  if ((pressed_legend_entry_ || pressed_title_panel_) && (event->buttons() & Qt::LeftButton) != 0) {
    if ((event->position().toPoint() - press_position_).manhattanLength() <
        QApplication::startDragDistance())
      return;
    const auto name = std::exchange(pressed_legend_entry_, std::nullopt);
    const auto title = std::exchange(pressed_title_panel_, std::nullopt);
    if (name)
      startDrag(name->panel, name->curve);
    else
      startDrag(*title, std::nullopt);
    return;
  }
  const bool left = event->buttons().testFlag(Qt::LeftButton);
  if (left && !dragging_ && !zoom_box_active_ && event->modifiers().testFlag(Qt::ControlModifier) &&
      !scene_->page().study)
    place_cursor(*this, position, event->modifiers());
  if (zoom_box_active_)
    band_->setGeometry(QRect(zoom_box_start_, event->position().toPoint()).normalized());
  if (dragging_ && scene_->isPlane()) {
    if (scene_->zoomed())
      scene_->setPlaneView(scene_->plotAreas().front().translated(last_ - position));
    last_ = position;
  } else if (dragging_ && scene_->page().log_x && !scene_->plotAreas().empty()) {
    const QRectF area = scene_->plotAreas().front().translated(last_ - position);
    const double low = scene_->abscissaAt(area.left()), high = scene_->abscissaAt(area.right());
    const auto& x = scene_->page().x;
    if (!x.empty() && low >= x.front() && high <= x.back()) {
      scene_->setView(low, high);
      last_ = position;
    }
  } else if (dragging_) {
    const double shift = drag_start_x_ - scene_->abscissaAt(position.x());
    const double low = scene_->viewLow() + shift, high = scene_->viewHigh() + shift;
    const auto& x = scene_->page().x;
    // Moving beyond the data would squeeze the view, so it stops at the ends.
    if (!x.empty() && low >= x.front() && high <= x.back()) scene_->setView(low, high);
  }
  if (pointer_position_ != event->position().toPoint()) reading_.reset();
  pointer_position_ = event->position().toPoint();
  read();
}

/// Content under the pointer now, also after the view has moved.
void ChartView::read() {
  if (reading_ && !isPointVisible(*reading_)) endReading();
  if (reading_)
    readStoredPoint(*reading_);
  else
    readPointer();
  emit viewChanged();
}

void ChartView::readPointer() {
  if (!pointer_position_) return;
  const QPointF position = mapToScene(*pointer_position_);
  const QStringList parts = scene_->readoutParts(position);
  pointer_line_x_ = parts.isEmpty() || scene_->page().equal_axes ? -1.0 : position.x();
  const auto near =
      scene_->page().closed_outline ? std::nullopt : scene_->nearestPlanePoint(position, 20.0);
  hovered_plane_point_ = near ? std::optional(near->at) : std::nullopt;
  emit readoutChanged(parts);
  viewport()->update();
}

void ChartView::zoomBox(const QRectF& box) {
  constexpr qreal kSmallest = 6.0;
  if (box.width() < kSmallest || box.height() < kSmallest) return;
  const auto panel = scene_->panelAt(box.center());
  if (!panel || (scene_->page().equal_axes && !scene_->isPlane())) return;
  const QRectF inside = box.intersected(scene_->plotAreas()[*panel]);
  remember();
  if (scene_->isPlane()) return scene_->setPlaneView(inside);
  ChartZoom zoom = scene_->zoom();
  zoom.low = scene_->abscissaAt(inside.left());
  zoom.high = scene_->abscissaAt(inside.right());
  zoom.panels.resize(scene_->page().panels.size());
  zoom.panels[*panel] =
      std::pair(scene_->valueAt(*panel, inside.bottom()), scene_->valueAt(*panel, inside.top()));
  scene_->setZoom(zoom);
}

void ChartView::mouseReleaseEvent(QMouseEvent* event) {
  pressed_title_panel_.reset();
  if (const auto name = std::exchange(pressed_legend_entry_, std::nullopt))
    return toggleCurve(name->panel, name->curve);
  if (dragging_ && !back_views_.empty() && back_views_.back() == now()) back_views_.pop_back();
  const QPoint place = event->position().toPoint();
  const bool clicked = dragging_ && (place - press_position_).manhattanLength() < 4;
  dragging_ = false;
  if (const auto panel = scene_->panelAt(mapToScene(place)); clicked && panel) choosePanel(*panel);
  if (!zoom_box_active_) return;
  zoom_box_active_ = false;
  band_->hide();
  zoomBox(
      QRectF(mapToScene(zoom_box_start_), mapToScene(event->position().toPoint())).normalized());
  read();
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->modifiers() == Qt::NoModifier) zoomAll();
}

void ChartView::leaveEvent(QEvent* event) {
  pointer_position_.reset();
  if (!reading_) {
    pointer_line_x_ = -1.0;
    hovered_plane_point_.reset();
    emit readoutChanged({});
  }
  viewport()->update();
  QGraphicsView::leaveEvent(event);
}

}  // namespace adore::desktop
