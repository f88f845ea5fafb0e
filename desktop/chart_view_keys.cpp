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
QPointF way_of(ChartDeed deed) {
  switch (deed) {
    case ChartDeed::MoveLeft:
      return {-kMove, 0.0};
    case ChartDeed::MoveRight:
      return {kMove, 0.0};
    case ChartDeed::FarLeft:
      return {-1.0, 0.0};
    case ChartDeed::FarRight:
      return {1.0, 0.0};
    case ChartDeed::MoveUp:
      return {0.0, -kMove};  // downward in the scene
    case ChartDeed::MoveDown:
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

QString ChartView::whyNotAtAll() const {
  const ChartPage& page = scene_->page();
  if (page.study) return tr("Charts of a study have fixed axes.");
  if (page.panels.empty()) return tr("There are no curves on this page.");
  if (page.equal_axes && !scene_->isPlane()) return tr("This drawing cannot be zoomed.");
  (void)valuesOfPanel();
  const bool any = std::any_of(values_of_.begin(), values_of_.end(),
                               [](const auto& values) { return !values->empty(); });
  if (!any || scene_->plotAreas().empty()) return tr("There are no values.");
  return {};
}

QString ChartView::whyNot(ChartDeed deed) const {
  if (const QString reason = whyNotAtAll(); !reason.isEmpty()) return reason;
  switch (deed) {
    case ChartDeed::ZoomIn:
    case ChartDeed::ZoomOut:
    case ChartDeed::ZoomToCursors:
      return whyNotZoom(deed);
    case ChartDeed::MoveLeft:
    case ChartDeed::MoveRight:
    case ChartDeed::FarLeft:
    case ChartDeed::FarRight:
    case ChartDeed::MoveUp:
    case ChartDeed::MoveDown:
      return whyNotMove(deed);
    case ChartDeed::EnlargeValues:
    case ChartDeed::ReduceValues:
      return whyNotValues(deed);
    case ChartDeed::PanelAbove:
    case ChartDeed::PanelBelow: {
      const std::size_t count = scene_->page().panels.size();
      if (count < 2) return tr("This page has only one panel.");
      if (deed == ChartDeed::PanelAbove && panel_ == 0) return tr("This is the first panel.");
      if (deed == ChartDeed::PanelBelow && panel_ + 1 >= count)
        return tr("This is the last panel.");
      return {};
    }
    default:
      return whyNotRead(deed);
  }
}

QString ChartView::whyNotZoom(ChartDeed deed) const {
  const QRectF all = scene_->everything(), area = scene_->plotAreas().front();
  if (deed == ChartDeed::ZoomToCursors) {
    if (scene_->isPlane()) return tr("This page has no horizontal axis. Use + to zoom.");
    if (!std::isfinite(cursors_[0]) || !std::isfinite(cursors_[1]))
      return tr("Set cursors A and B first.");
    if (cursors_[0] == cursors_[1]) return tr("Cursors A and B are at the same point.");
  }
  const QRectF part = partAfter(deed);
  if (deed == ChartDeed::ZoomOut)
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

QString ChartView::whyNotMove(ChartDeed deed) const {
  const bool upright = way_of(deed).y() != 0.0;
  const QString nothing = tr("There is nothing more in this direction.");
  if (!upright && scene_->everything().width() < scene_->plotAreas().front().width() + kEdge)
    return nothing;
  if (!upright || scene_->isPlane()) {
    const QPointF moved = partAfter(deed).topLeft() - scene_->plotAreas().front().topLeft();
    return std::abs(moved.x()) < kEdge && std::abs(moved.y()) < kEdge ? nothing : QString();
  }
  const ChartZoom zoom = scene_->zoom();
  if (panel_ >= zoom.panels.size() || !zoom.panels[panel_])
    return tr("Enlarge the values of this panel first.");
  const auto [low, high] = valuesAfter(deed);
  const Extent& all = valuesOfPanel();
  return all.empty() || low > all.high || high < all.low ? nothing : QString();
}

QString ChartView::whyNotValues(ChartDeed deed) const {
  if (scene_->isPlane()) return tr("This page uses equal axis scales; + and - zoom both axes.");
  const Extent& all = valuesOfPanel();
  if (all.empty()) return tr("This panel has no values.");
  const QRectF& area = scene_->plotAreas().at(panel_);
  if (deed == ChartDeed::ReduceValues)
    return scene_->valueAt(panel_, area.bottom()) <= all.low &&
                   scene_->valueAt(panel_, area.top()) >= all.high
               ? tr("All values of this panel are shown.")
               : QString();
  constexpr double kDigits = 1e-9, kLeast = 1e-6;  // of a value, of all of them
  const auto [low, high] = valuesAfter(deed);
  const double least = scene_->page().panels[panel_].log ? 0.0 : kLeast * (all.high - all.low);
  const bool closest =
      high - low < std::max(least, kDigits * std::max(std::abs(low), std::abs(high)));
  return closest ? tr("Maximum zoom reached.") : QString();
}

QString ChartView::whyNotRead(ChartDeed deed) const {
  const ChartPage& page = scene_->page();
  const bool cursor = deed == ChartDeed::CursorA || deed == ChartDeed::CursorB;
  if (page.equal_axes && page.closed_outline) return tr("Outlines have no stored points.");
  if (cursor && page.equal_axes && page.along.empty())
    return tr("The points of this page are not ordered by time.");
  if (reading_) {
    if (cursor)
      return std::isfinite(abscissaOf(*reading_)) ? QString()
                                                  : tr("The time of this point is unknown.");
    return placeAfter(deed) ? QString() : tr("There is nothing more in this direction.");
  }
  for (StoredPlace at; at.curve < (page.equal_axes ? page.panels.front().curves.size() : 1);
       ++at.curve, at.index = 0)
    for (; at.index < placesOf(at.curve); ++at.index)
      if (hasPlace(at)) return {};
  return tr("There are no points to read.");
}

QRectF ChartView::partAfter(ChartDeed deed) const {
  const QRectF area = scene_->plotAreas().front();
  QRectF part = area;
  if (deed == ChartDeed::ZoomIn || deed == ChartDeed::ZoomOut) {
    const double factor = deed == ChartDeed::ZoomIn ? kZoom : 1.0 / kZoom;
    const QPointF about = reading_ ? sceneOf(*reading_) : area.center();
    part = QRectF(about + factor * (area.topLeft() - about), factor * area.size());
  } else if (deed == ChartDeed::ZoomToCursors) {
    const auto [from, to] = std::minmax(cursors_[0], cursors_[1]);
    part.setLeft(scene_->positionOf(from));
    part.setRight(scene_->positionOf(to));
  } else {
    const QPointF way = way_of(deed);
    part.translate(way.x() * area.width(), way.y() * area.height());
  }
  return withinAll(part);
}

QRectF ChartView::withinAll(const QRectF& part) const {
  const QRectF all = scene_->everything();
  const auto [left, right] = inside(part.left(), part.right(), all.left(), all.right());
  const auto [top, bottom] = inside(part.top(), part.bottom(), all.top(), all.bottom());
  return {QPointF(left, top), QPointF(right, bottom)};
}

void ChartView::showPart(const QRectF& part) {
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
const Extent& ChartView::valuesOfPanel() const {
  for (std::size_t p = values_of_.size(); p < scene_->page().panels.size(); ++p) {
    const ChartPanel& panel = scene_->page().panels[p];
    Extent& of = values_of_.emplace_back(Extent{}).value();
    if (panel.rows) {
      for (const double limit : limits_between(panel.rows->at)) of.include(limit);
      continue;
    }
    for (const ChartCurve& curve : panel.curves)
      for (const auto* values : {&curve.y, &curve.low, &curve.high})
        for (const double value : *values)
          if (!panel.log || value > 0.0) of.include(value);
  }
  return values_of_.at(panel_).value();
}

std::pair<double, double> ChartView::valuesAfter(ChartDeed deed) const {
  const QRectF& area = scene_->plotAreas().at(panel_);
  // In pixels, so that a logarithmic axis behaves like any other.
  double grown = 0.0, moved = area.height() * way_of(deed).y();
  if (deed == ChartDeed::EnlargeValues) grown = 0.5 * (kZoom - 1.0) * area.height();
  if (deed == ChartDeed::ReduceValues) grown = 0.5 * (1.0 / kZoom - 1.0) * area.height();
  return {scene_->valueAt(panel_, area.bottom() + moved + grown),
          scene_->valueAt(panel_, area.top() + moved - grown)};
}

void ChartView::choosePanel(std::size_t panel) {
  panel_ = panel;
  emit panelClicked(panel);
  read();
  viewport()->update();
}

std::vector<LegendEntry> ChartView::namedCurves() const {
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

void ChartView::perform(ChartDeed deed) {
  if (!whyNot(deed).isEmpty()) return;
  const bool moves = !way_of(deed).isNull();
  switch (deed) {
    case ChartDeed::PanelAbove:
      return choosePanel(panel_ - 1);
    case ChartDeed::PanelBelow:
      return choosePanel(panel_ + 1);
    case ChartDeed::CursorA:
    case ChartDeed::CursorB: {
      const int which = deed == ChartDeed::CursorA ? 0 : 1;
      const auto place = placeOfNow();
      if (!place) return;
      const double here = abscissaOf(*place);
      reading_ = place;
      setCursor(which, cursorAt(which) == here ? std::numeric_limits<double>::quiet_NaN() : here);
      break;
    }
    case ChartDeed::ReadBack:
    case ChartDeed::ReadOn:
    case ChartDeed::ReadFarBack:
    case ChartDeed::ReadFarOn:
      if (const auto place = placeAfter(deed)) follow(*place);
      break;
    default:
      if (!moves || !moving_) remember();
      moving_ = moves;
      if (deed == ChartDeed::EnlargeValues || deed == ChartDeed::ReduceValues ||
          (way_of(deed).y() != 0.0 && !scene_->isPlane()))
        scene_->setPanelView(panel_, valuesAfter(deed));
      else
        showPart(partAfter(deed));
  }
  read();
  viewport()->update();
}

}  // namespace adore::desktop
