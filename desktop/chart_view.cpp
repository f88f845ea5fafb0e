#include "desktop/chart_view.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QRubberBand>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::desktop {
namespace {

constexpr std::size_t kMostViews = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr int kDigits = 5;

QString quantity(double value, const std::string& unit, int digits = kDigits) {
  return QString::fromStdString(pretty_quantity(value, unit, digits));
}

/// So many digits that what a curve varies by has as many as its values else have: 30.005 mm tells
/// nothing of a motion of 1 µm about it.
int digits_of(const ChartCurve& curve) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : curve.y)
    if (std::isfinite(v)) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  const double largest = std::max(std::abs(low), std::abs(high));
  if (!(high > low) || !std::isfinite(largest)) return kDigits;
  constexpr int kMost = 12;
  const int more = static_cast<int>(std::floor(std::log10(largest / (high - low))));
  return std::clamp(kDigits + more, kDigits, kMost);
}

/// The same for a page that is read again.
std::string name_of(const ChartPage& page) {
  std::string name = page.title + '\n' + page.subtitle;
  for (const ChartPanel& panel : page.panels) {
    name += '\n' + panel.title + " [" + panel.unit + ']';
    for (const ChartCurve& curve : panel.curves) name += '\n' + curve.name;
  }
  return name;
}

std::string abscissa_of(const ChartPage& page) { return page.x_title + " [" + page.x_unit + ']'; }

}  // namespace

ChartView::ChartView(QWidget* parent)
    : QGraphicsView(parent), scene_(new ChartScene(ChartStyle::Page, this)) {
  setScene(scene_);
  setFrameShape(QFrame::NoFrame);
  setRenderHint(QPainter::Antialiasing);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  setMouseTracking(true);
  setMinimumSize(480, 360);
  setAccessibleName(tr("Chart"));
  band_ = new QRubberBand(QRubberBand::Rectangle, viewport());
}

void ChartView::showPage(ChartPage page) {
  constexpr std::size_t kMostPages = 1000;
  const ChartPage& old = scene_->page();
  const bool same = page.x_unit == old.x_unit && page.x_title == old.x_title;
  if (!same) cursors_ = {kNone, kNone};
  ranges_ = now().ranges;
  if (hidden_.size() > kMostPages) hidden_.clear();
  auto& hidden = hidden_[name_of(old)];
  hidden.clear();
  for (std::size_t p = 0; p < old.panels.size(); ++p)
    for (std::size_t c = 0; c < old.panels[p].curves.size(); ++c)
      if (old.panels[p].curves[c].hidden) hidden.emplace(p, c);
  for (const auto& [p, c] : hidden_[name_of(page)])
    if (p < page.panels.size() && c < page.panels[p].curves.size())
      page.panels[p].curves[c].hidden = true;
  scene_->setPage(std::move(page), true);
  const auto own = ranges_.find(name_of(scene_->page()));
  if (own != ranges_.end()) scene_->setZoom({scene_->viewLow(), scene_->viewHigh(), own->second});
  emit cursorsChanged();
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
}

void ChartView::remember() {
  View view = now();
  if (!back_.empty() && back_.back() == view) return;
  back_.push_back(std::move(view));
  if (back_.size() > kMostViews) back_.erase(back_.begin());
  forward_.clear();
}

/// Views that would change nothing here are passed over; they stay where no other one changes
/// anything, for the page where they do.
void ChartView::travel(std::vector<View>& from, std::vector<View>& to) {
  const View left = now();
  const ChartZoom seen = scene_->zoom();
  for (std::size_t i = from.size(); i-- > 0;) {
    const View view = from[i];
    apply(view);
    if (scene_->zoom() == seen) continue;
    from.resize(i);
    to.push_back(left);
    viewport()->update();
    return;
  }
  apply(left);
}

void ChartView::zoomBack() { travel(back_, forward_); }

void ChartView::zoomForward() { travel(forward_, back_); }

/// Everything; again, where a page begins with a part: that part.
void ChartView::zoomAll() {
  if (scene_->whole() && !scene_->zoomed()) return;
  remember();
  if (scene_->whole())
    scene_->resetView();
  else
    scene_->showAll();
}

void ChartView::setCursor(int which, double abscissa) {
  const auto& x = scene_->page().x;
  // On a stored value: what is read off is in the file.
  cursors_.at(static_cast<std::size_t>(which)) =
      x.empty() || !std::isfinite(abscissa) ? kNone : x[nearest_index(x, abscissa)];
  emit cursorsChanged();
  viewport()->update();
}

void ChartView::clearCursors() {
  cursors_ = {kNone, kNone};
  emit cursorsChanged();
  viewport()->update();
}

QString ChartView::cursorReport() const {
  const ChartPage& page = scene_->page();
  const bool a = std::isfinite(cursors_[0]), b = std::isfinite(cursors_[1]);
  if ((!a && !b) || page.equal_axes || page.x.empty()) return {};
  QStringList lines;
  QString head;
  if (a) head += tr("A: %1").arg(quantity(cursors_[0], page.x_unit));
  if (b) head += tr("%1B: %2").arg(a ? "   " : "", quantity(cursors_[1], page.x_unit));
  if (a && b) {
    const double gap = cursors_[1] - cursors_[0];
    head += tr("   B − A: %1").arg(quantity(gap, page.x_unit));
    if (page.x_unit == "s" && gap != 0.0)
      head += tr("   1/(B − A): %1").arg(quantity(1.0 / std::abs(gap), "Hz"));
  }
  lines << head;
  for (const ChartPanel& panel : page.panels)
    for (const ChartCurve& curve : panel.curves) {
      const bool any =
          std::any_of(curve.y.begin(), curve.y.end(), [](double v) { return std::isfinite(v); });
      if (curve.hidden || !any) continue;
      // A chart of one's own names its curves by their quantity.
      const bool named = curve.name.starts_with(panel.title);
      QString line = QString::fromStdString(curve.name.empty() ? panel.title
                                            : named            ? curve.name
                                                               : panel.title + ", " + curve.name) +
                     ":";
      const auto value = [&](double x) {
        const std::size_t i = nearest_index(page.x, x);
        return i < curve.y.size() ? curve.value(i) : kNone;
      };
      const int digits = digits_of(curve);
      if (a) line += tr("  A %1").arg(quantity(value(cursors_[0]), panel.unit, digits));
      if (b) line += tr("  B %1").arg(quantity(value(cursors_[1]), panel.unit, digits));
      if (a && b) {
        std::vector<double> lowered;
        if (curve.lift != 0.0) {
          lowered = curve.y;
          for (double& v : lowered) v -= curve.lift;
        }
        const CurveStatistics s = statistics_between(page.x, lowered.empty() ? curve.y : lowered,
                                                     cursors_[0], cursors_[1]);
        line += tr("  B − A %1").arg(quantity(value(cursors_[1]) - value(cursors_[0]), panel.unit));
        if (s.count > 0)
          line +=
              tr("  min %1  max %2  mean %3  RMS %4")
                  .arg(quantity(s.lowest, panel.unit, digits),
                       quantity(s.highest, panel.unit, digits),
                       quantity(s.mean, panel.unit, digits), quantity(s.rms, panel.unit, digits));
      }
      lines << line;
    }
  return lines.join('\n');
}

void ChartView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  scene_->setPageSize(viewport()->size());
}

void ChartView::wheelEvent(QWheelEvent* event) {
  const QPointF position = mapToScene(event->position().toPoint());
  // A horizontal wheel, or Alt, turns the other way on some desktops.
  const double turn =
      event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  const double factor = std::pow(0.8, turn / 120.0);
  const auto panel = scene_->panelAt(position);
  remember();
  if ((event->modifiers() & Qt::ControlModifier) != 0 && panel && !scene_->page().equal_axes) {
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
  event->accept();
}

bool ChartView::toggleLegend(QPointF position) {
  for (const LegendEntry& entry : scene_->legend()) {
    if (!entry.place.adjusted(-3, -3, 3, 3).contains(position)) continue;
    const LegendEntry found = entry;  // the scene makes its legend anew
    scene_->showCurve(found.panel, found.curve,
                      scene_->page().panels[found.panel].curves[found.curve].hidden);
    emit curvesChanged();
    return true;
  }
  return false;
}

void ChartView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF position = mapToScene(event->position().toPoint());
  if (scene_->page().study) {
    if (const std::vector<long> runs = scene_->runsAt(position); !runs.empty())
      emit runsChosen(runs);
    return;
  }
  if (toggleLegend(position)) return;
  if ((event->modifiers() & Qt::ControlModifier) != 0) {
    if (scene_->panelAt(position) && !scene_->page().equal_axes)
      setCursor((event->modifiers() & Qt::ShiftModifier) != 0 ? 1 : 0,
                scene_->abscissaAt(position.x()));
    return;
  }
  if ((event->modifiers() & Qt::ShiftModifier) != 0) {
    boxing_ = true;
    box_from_ = event->position().toPoint();
    band_->setGeometry(QRect(box_from_, QSize()));
    band_->show();
    return;
  }
  dragging_ = true;
  remember();
  drag_from_ = scene_->abscissaAt(position.x());
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = mapToScene(event->position().toPoint());
  if (boxing_) band_->setGeometry(QRect(box_from_, event->position().toPoint()).normalized());
  if (dragging_ && !scene_->page().log_x) {
    const double shift = drag_from_ - scene_->abscissaAt(position.x());
    const double low = scene_->viewLow() + shift, high = scene_->viewHigh() + shift;
    const auto& x = scene_->page().x;
    // Moving beyond the data would squeeze the view, so it stops at the ends.
    if (!x.empty() && low >= x.front() && high <= x.back()) scene_->setView(low, high);
  }
  const QStringList parts = scene_->readoutParts(position);
  pointer_ = parts.isEmpty() ? -1.0 : position.x();
  emit readoutChanged(parts);
  viewport()->update();
}

void ChartView::zoomBox(const QRectF& box) {
  constexpr qreal kSmallest = 6.0;
  if (scene_->page().equal_axes || box.width() < kSmallest || box.height() < kSmallest) return;
  const auto panel = scene_->panelAt(box.center());
  if (!panel) return;
  const QRectF inside = box.intersected(scene_->plotAreas()[*panel]);
  remember();
  ChartZoom zoom = scene_->zoom();
  zoom.low = scene_->abscissaAt(inside.left());
  zoom.high = scene_->abscissaAt(inside.right());
  zoom.panels.resize(scene_->page().panels.size());
  zoom.panels[*panel] =
      std::pair(scene_->valueAt(*panel, inside.bottom()), scene_->valueAt(*panel, inside.top()));
  scene_->setZoom(zoom);
}

void ChartView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_ && !back_.empty() && back_.back() == now()) back_.pop_back();
  dragging_ = false;
  if (!boxing_) return;
  boxing_ = false;
  band_->hide();
  zoomBox(QRectF(mapToScene(box_from_), mapToScene(event->position().toPoint())).normalized());
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->modifiers() == Qt::NoModifier) zoomAll();
}

void ChartView::leaveEvent(QEvent* event) {
  pointer_ = -1.0;
  emit readoutChanged({});
  viewport()->update();
  QGraphicsView::leaveEvent(event);
}

void ChartView::drawForeground(QPainter* painter, const QRectF&) {
  const auto line = [&](double x) {
    for (const auto& area : scene_->plotAreas())
      painter->drawLine(QLineF(x, area.top(), x, area.bottom()));
  };
  if (pointer_ >= 0.0) {
    painter->setPen(QPen(current_theme().accent, 1, Qt::DotLine));
    line(pointer_);
  }
  if (scene_->page().equal_axes || scene_->plotAreas().empty()) return;
  for (std::size_t i = 0; i < cursors_.size(); ++i) {
    if (!(cursors_[i] >= scene_->viewLow() && cursors_[i] <= scene_->viewHigh())) continue;
    const double x = scene_->positionOf(cursors_[i]);
    painter->setPen(QPen(current_theme().red, 1.2));
    line(x);
    painter->setFont(ui_font(12, true));
    painter->drawText(QPointF(x + 4, scene_->plotAreas().front().top() + 13), i == 0 ? "A" : "B");
  }
}

}  // namespace adore::desktop
