#include "desktop/chart_view.hpp"

#include <algorithm>
#include <cmath>

/// Key commands of a chart: the same as those of the mouse, at the current point or the middle of
/// the visible range.
namespace adore::desktop {
namespace {

constexpr double kZoom = 0.5, kMove = 0.1;  ///< fractions of the visible range
constexpr qreal kEdge = 0.5;                ///< smaller motions are ignored [px]

/// Fraction of the visible range by which a command moves along the abscissa and upward.
QPointF way_of(ChartAction chart_action) {
  switch (chart_action) {
    case ChartAction::MoveLeft:
      return {-kMove, 0.0};
    case ChartAction::MoveRight:
      return {kMove, 0.0};
    case ChartAction::FarLeft:
      return {-1.0, 0.0};
    case ChartAction::FarRight:
      return {1.0, 0.0};
    case ChartAction::MoveUp:
      return {0.0, -kMove};  // downward in the scene
    case ChartAction::MoveDown:
      return {0.0, kMove};
    default:
      return {};
  }
}

/// As much of a range, moved inside another one.
std::pair<qreal, qreal> inside(qreal low, qreal high, qreal first, qreal last) {
  const qreal length = std::min(high - low, last - first);
  const qreal begin = std::clamp(low, first, std::max(first, last - length));
  return {begin, begin + length};
}

}  // namespace

QString ChartView::chartDisabledReason() const {
  const ChartPage& page = scene_->page();
  if (page.study) return tr("Charts of a study have fixed axes.");
  if (page.panels.empty()) return tr("There are no curves on this page.");
  if (page.equal_axes && !scene_->isPlane()) return tr("This drawing cannot be zoomed.");
  (void)panelValueRange();
  const bool any = std::any_of(panel_value_ranges_.begin(), panel_value_ranges_.end(),
                               [](const auto& values) { return !values->empty(); });
  if (!any || scene_->plotAreas().empty()) return tr("There are no values.");
  return {};
}

QString ChartView::disabledReason(ChartAction chart_action) const {
  if (const QString reason = chartDisabledReason(); !reason.isEmpty()) return reason;
  switch (chart_action) {
    case ChartAction::ZoomIn:
    case ChartAction::ZoomOut:
    case ChartAction::ZoomToCursors:
      return zoomDisabledReason(chart_action);
    case ChartAction::MoveLeft:
    case ChartAction::MoveRight:
    case ChartAction::FarLeft:
    case ChartAction::FarRight:
    case ChartAction::MoveUp:
    case ChartAction::MoveDown:
      return moveDisabledReason(chart_action);
    case ChartAction::EnlargeValues:
    case ChartAction::ReduceValues:
      return valueZoomDisabledReason(chart_action);
    case ChartAction::PanelAbove:
    case ChartAction::PanelBelow: {
      const std::size_t count = scene_->page().panels.size();
      if (count < 2) return tr("This page has only one panel.");
      if (chart_action == ChartAction::PanelAbove && panel_ == 0)
        return tr("This is the first panel.");
      if (chart_action == ChartAction::PanelBelow && panel_ + 1 >= count)
        return tr("This is the last panel.");
      return {};
    }
    default:
      return readDisabledReason(chart_action);
  }
}

QString ChartView::zoomDisabledReason(ChartAction chart_action) const {
  const QRectF all = scene_->everything(), area = scene_->plotAreas().front();
  if (chart_action == ChartAction::ZoomToCursors) {
    if (scene_->isPlane()) return tr("This page has no horizontal axis. Use + to zoom.");
    if (!std::isfinite(cursors_[0]) || !std::isfinite(cursors_[1]))
      return tr("Set cursors A and B first.");
    if (cursors_[0] == cursors_[1]) return tr("Cursors A and B are at the same point.");
  }
  const QRectF part = visiblePartAfter(chart_action);
  if (chart_action == ChartAction::ZoomOut)
    return all.width() > area.width() + kEdge ? QString() : tr("Everything is shown.");
  const bool closest = scene_->isPlane()
                           ? area.width() < all.width() * ChartScene::kLeastPart * (1.0 + 1e-6)
                           : scene_->abscissaAt(part.right()) - scene_->abscissaAt(part.left()) <
                                 ChartScene::kLeastPart * (scene_->abscissaAt(all.right()) -
                                                           scene_->abscissaAt(all.left()));
  if (closest || all.width() < 1.0) return tr("Maximum zoom reached.");
  if (std::abs(part.left() - area.left()) < kEdge && std::abs(part.right() - area.right()) < kEdge)
    return tr("This range is already shown.");
  return {};
}

QString ChartView::moveDisabledReason(ChartAction chart_action) const {
  const bool upright = way_of(chart_action).y() != 0.0;
  const QString nothing = tr("There are no more values in this direction.");
  if (!upright && scene_->everything().width() < scene_->plotAreas().front().width() + kEdge)
    return nothing;
  if (!upright || scene_->isPlane()) {
    const QPointF moved =
        visiblePartAfter(chart_action).topLeft() - scene_->plotAreas().front().topLeft();
    return std::abs(moved.x()) < kEdge && std::abs(moved.y()) < kEdge ? nothing : QString();
  }
  const ChartZoom zoom = scene_->zoom();
  if (panel_ >= zoom.panels.size() || !zoom.panels[panel_])
    return tr("Zoom in vertically on this panel first.");
  const auto [low, high] = valueRangeAfter(chart_action);
  const Extent& all = panelValueRange();
  return all.empty() || low > all.high || high < all.low ? nothing : QString();
}

QString ChartView::valueZoomDisabledReason(ChartAction chart_action) const {
  if (scene_->isPlane()) return tr("This page uses equal axis scales; + and - zoom both axes.");
  const Extent& all = panelValueRange();
  if (all.empty()) return tr("This panel has no values.");
  const QRectF& area = scene_->plotAreas().at(panel_);
  if (chart_action == ChartAction::ReduceValues)
    return scene_->valueAt(panel_, area.bottom()) <= all.low &&
                   scene_->valueAt(panel_, area.top()) >= all.high
               ? tr("All values of this panel are shown.")
               : QString();
  constexpr double kDigits = 1e-9, kLeast = 1e-6;  // of a value, of all of them
  const auto [low, high] = valueRangeAfter(chart_action);
  const double least = scene_->page().panels[panel_].log ? 0.0 : kLeast * (all.high - all.low);
  const bool closest =
      high - low < std::max(least, kDigits * std::max(std::abs(low), std::abs(high)));
  return closest ? tr("Maximum zoom reached.") : QString();
}

QString ChartView::readDisabledReason(ChartAction chart_action) const {
  const ChartPage& page = scene_->page();
  const bool cursor = chart_action == ChartAction::CursorA || chart_action == ChartAction::CursorB;
  if (page.equal_axes && page.closed_outline) return tr("Outlines have no stored points.");
  if (cursor && page.equal_axes && page.along.empty())
    return tr("The points of this page are not ordered by time.");
  if (reading_) {
    if (cursor)
      return std::isfinite(abscissaOf(*reading_)) ? QString()
                                                  : tr("The time of this point is unknown.");
    return storedPointAfter(chart_action) ? QString()
                                          : tr("There are no more values in this direction.");
  }
  for (StoredPoint at; at.curve < (page.equal_axes ? page.panels.front().curves.size() : 1);
       ++at.curve, at.index = 0)
    for (; at.index < placesOf(at.curve); ++at.index)
      if (hasStoredPoint(at)) return {};
  return tr("There are no points to read.");
}

QRectF ChartView::visiblePartAfter(ChartAction chart_action) const {
  const QRectF area = scene_->plotAreas().front();
  QRectF part = area;
  if (chart_action == ChartAction::ZoomIn || chart_action == ChartAction::ZoomOut) {
    const double factor = chart_action == ChartAction::ZoomIn ? kZoom : 1.0 / kZoom;
    const QPointF about = reading_ ? scenePosition(*reading_) : area.center();
    part = QRectF(about + factor * (area.topLeft() - about), factor * area.size());
  } else if (chart_action == ChartAction::ZoomToCursors) {
    const auto [from, to] = std::minmax(cursors_[0], cursors_[1]);
    part.setLeft(scene_->sceneXAt(from));
    part.setRight(scene_->sceneXAt(to));
  } else {
    const QPointF way = way_of(chart_action);
    part.translate(way.x() * area.width(), way.y() * area.height());
  }
  return limitToContent(part);
}

QRectF ChartView::limitToContent(const QRectF& part) const {
  const QRectF all = scene_->everything();
  const auto [left, right] = inside(part.left(), part.right(), all.left(), all.right());
  const auto [top, bottom] = inside(part.top(), part.bottom(), all.top(), all.bottom());
  return {QPointF(left, top), QPointF(right, bottom)};
}

void ChartView::setVisiblePart(const QRectF& part) {
  if (scene_->isPlane()) return scene_->setPlaneView(part);
  // The exact ends, without rounding to pixels.
  const QRectF all = scene_->everything();
  const double low = part.left() < all.left() + kEdge ? -std::numeric_limits<double>::infinity()
                                                      : scene_->abscissaAt(part.left());
  const double high = part.right() > all.right() - kEdge ? std::numeric_limits<double>::infinity()
                                                         : scene_->abscissaAt(part.right());
  scene_->setView(low, high);
}

/// Of all panels once for a page: menus ask again whenever the pointer moves.
const Extent& ChartView::panelValueRange() const {
  for (std::size_t p = panel_value_ranges_.size(); p < scene_->page().panels.size(); ++p) {
    const ChartPanel& panel = scene_->page().panels[p];
    Extent& of = panel_value_ranges_.emplace_back(Extent{}).value();
    if (panel.rows) {
      for (const double limit : cell_edges(panel.rows->at)) of.include(limit);
      continue;
    }
    for (const ChartCurve& curve : panel.curves)
      for (const auto* values : {&curve.y, &curve.low, &curve.high})
        for (const double value : *values)
          if (!panel.log || value > 0.0) of.include(value);
  }
  return panel_value_ranges_.at(panel_).value();
}

std::pair<double, double> ChartView::valueRangeAfter(ChartAction chart_action) const {
  const QRectF& area = scene_->plotAreas().at(panel_);
  // In pixels, so that a logarithmic axis behaves like any other.
  double grown = 0.0, moved = area.height() * way_of(chart_action).y();
  if (chart_action == ChartAction::EnlargeValues) grown = 0.5 * (kZoom - 1.0) * area.height();
  if (chart_action == ChartAction::ReduceValues) grown = 0.5 * (1.0 / kZoom - 1.0) * area.height();
  return {scene_->valueAt(panel_, area.bottom() + moved + grown),
          scene_->valueAt(panel_, area.top() + moved - grown)};
}

void ChartView::choosePanel(std::size_t panel) {
  panel_ = panel;
  emit panelClicked(panel);
  read();
  viewport()->update();
}

std::vector<LegendEntry> ChartView::legendCurves() const {
  std::vector<LegendEntry> out = scene_->legend();
  std::sort(out.begin(), out.end(), [](const LegendEntry& a, const LegendEntry& b) {
    return std::pair(a.panel, a.curve) < std::pair(b.panel, b.curve);
  });
  return out;
}

void ChartView::toggleCurve(std::size_t panel, std::size_t curve) {
  scene_->showCurve(panel, curve, scene_->page().panels.at(panel).curves.at(curve).hidden);
  emit curvesChanged();
  emit cursorsChanged();  // they describe the visible curves
  if (reading_) read();
}

void ChartView::perform(ChartAction chart_action) {
  if (!disabledReason(chart_action).isEmpty()) return;
  const bool moves = !way_of(chart_action).isNull();
  switch (chart_action) {
    case ChartAction::PanelAbove:
      return choosePanel(panel_ - 1);
    case ChartAction::PanelBelow:
      return choosePanel(panel_ + 1);
    case ChartAction::CursorA:
    case ChartAction::CursorB: {
      const int which = chart_action == ChartAction::CursorA ? 0 : 1;
      const auto place = currentStoredPoint();
      if (!place) return;
      const double here = abscissaOf(*place);
      reading_ = place;
      setCursorAbscissa(
          which, cursorAbscissa(which) == here ? std::numeric_limits<double>::quiet_NaN() : here);
      break;
    }
    case ChartAction::ReadBack:
    case ChartAction::ReadOn:
    case ChartAction::ReadFarBack:
    case ChartAction::ReadFarOn:
      if (const auto place = storedPointAfter(chart_action)) follow(*place);
      break;
    default:
      if (!moves || !key_move_active_) remember();
      key_move_active_ = moves;
      if (chart_action == ChartAction::EnlargeValues || chart_action == ChartAction::ReduceValues ||
          (way_of(chart_action).y() != 0.0 && !scene_->isPlane()))
        scene_->setPanelView(panel_, valueRangeAfter(chart_action));
      else
        setVisiblePart(visiblePartAfter(chart_action));
  }
  read();
  viewport()->update();
}

}  // namespace adore::desktop
