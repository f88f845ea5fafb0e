#include "desktop/chart_view.hpp"

#include <algorithm>
#include <cmath>

/// Reading by keys: from one stored point of a page to the next.
namespace adore::desktop {

std::size_t ChartView::placesOf(std::size_t curve) const {
  const ChartPage& page = scene_->page();
  if (!page.equal_axes) return page.x.size();
  const ChartCurve& of = page.panels.front().curves.at(curve);
  return std::min(of.x.size(), of.y.size());
}

bool ChartView::hasStoredPoint(const StoredPoint& place) const {
  const ChartPage& page = scene_->page();
  if (place.index >= placesOf(place.curve)) return false;
  if (!page.equal_axes)
    return is_drawable(page.x[place.index]) && (!page.log_x || page.x[place.index] > 0.0);
  const ChartCurve& of = page.panels.front().curves.at(place.curve);
  return !of.hidden && is_drawable(of.x[place.index]) && is_drawable(of.y[place.index]);
}

QPointF ChartView::scenePosition(const StoredPoint& place) const {
  const ChartPage& page = scene_->page();
  if (!page.equal_axes)
    return {scene_->sceneXAt(page.x[place.index]),
            page.panels.front().rows
                ? scene_->sceneYAt(0, page.panels.front().rows->at.at(place.curve))
                : scene_->plotAreas().front().center().y()};
  const ChartCurve& of = page.panels.front().curves.at(place.curve);
  return {scene_->sceneXAt(of.x[place.index]), scene_->sceneYAt(0, of.y[place.index])};
}

double ChartView::abscissaOf(const StoredPoint& place) const {
  const ChartPage& page = scene_->page();
  const std::vector<double>& places = page.equal_axes ? page.along : page.x;
  // Cursors of an orbit are on its first curve.
  return (place.curve == 0 || !page.equal_axes) && place.index < places.size()
             ? places[place.index]
             : std::numeric_limits<double>::quiet_NaN();
}

bool ChartView::isPointVisible(const StoredPoint& place) const {
  constexpr qreal kRounded = 0.5;
  return !scene_->plotAreas().empty() && hasStoredPoint(place) &&
         scene_->plotAreas()
             .front()
             .adjusted(-kRounded, -kRounded, kRounded, kRounded)
             .contains(scenePosition(place));
}

std::optional<ChartView::StoredPoint> ChartView::nextStoredPoint(StoredPoint at, long by) const {
  const ChartPage& page = scene_->page();
  const std::size_t curves = page.equal_axes ? page.panels.front().curves.size() : 1;
  std::optional<StoredPoint> out;
  for (long left = std::abs(by); left > 0;) {
    if (by > 0) {
      if (at.index + 1 < placesOf(at.curve))
        ++at.index;
      else if (at.curve + 1 < curves)
        at = {at.curve + 1, 0};
      else
        break;
    } else if (at.index > 0) {
      --at.index;
    } else if (page.equal_axes && at.curve > 0) {
      --at.curve;
      at.index = std::max<std::size_t>(placesOf(at.curve), 1) - 1;
    } else {
      break;
    }
    if (!hasStoredPoint(at)) continue;
    out = at;
    --left;
  }
  return out;
}

std::optional<ChartView::StoredPoint> ChartView::currentStoredPoint() const {
  constexpr qreal kAnywhere = 1e9;
  if (reading_) return reading_;
  const QPointF pointer = pointer_position_ ? mapToScene(*pointer_position_) : QPointF(-1.0, -1.0);
  const QPointF from = scene_->panelAt(pointer) ? pointer : scene_->plotAreas().front().center();
  if (scene_->isPlane()) {
    const auto near = scene_->nearestPlanePoint(from, kAnywhere);
    return near ? std::optional(StoredPoint{near->curve, near->index}) : std::nullopt;
  }
  const StoredPoint out{scene_->mapRowAt(from).value_or(0),
                        nearest_index(scene_->page().x, scene_->abscissaAt(from.x()))};
  if (hasStoredPoint(out)) return out;
  const auto on = nextStoredPoint(out, 1);
  return on ? on : nextStoredPoint(out, -1);
}

/// Reading begins in the middle of the visible range, or continues from the pointer.
std::optional<ChartView::StoredPoint> ChartView::storedPointAfter(ChartAction chart_action) const {
  const auto from = currentStoredPoint();
  const bool pointed = pointer_position_ && scene_->panelAt(mapToScene(*pointer_position_));
  if (!from || (!reading_ && !pointed)) return from;
  const bool on = chart_action == ChartAction::ReadOn || chart_action == ChartAction::ReadFarOn;
  const bool far =
      chart_action == ChartAction::ReadFarBack || chart_action == ChartAction::ReadFarOn;
  long by = on ? 1 : -1;
  if (far && scene_->isPlane()) {
    by *= std::max(1L, static_cast<long>(placesOf(from->curve) / 20));
  } else if (far) {
    const qreal way = 0.05 * scene_->plotAreas().front().width() * (on ? 1.0 : -1.0);
    const auto there = static_cast<long>(
        nearest_index(scene_->page().x, scene_->abscissaAt(scenePosition(*from).x() + way)));
    const long steps = there - static_cast<long>(from->index);
    if (steps * by > 1) by = steps;
  }
  const auto next = nextStoredPoint(*from, by);
  return next || reading_ ? next : from;
}

/// Reads a point; the view moves if the point is outside.
void ChartView::follow(const StoredPoint& place) {
  reading_ = place;
  if (isPointVisible(place)) return;
  constexpr double kRoom = 0.1;  // fraction of the visible range, ahead
  const QRectF area = scene_->plotAreas().front();
  const QPointF at = scenePosition(place);
  const auto beyond = [](qreal value, qreal low, qreal high) {
    const qreal room = kRoom * (high - low);
    return value < low ? value - low - room : value > high ? value - high + room : 0.0;
  };
  if (!key_move_active_) remember();
  key_move_active_ = true;
  const QPointF by(beyond(at.x(), area.left(), area.right()),
                   scene_->isPlane() ? beyond(at.y(), area.top(), area.bottom()) : 0.0);
  setVisiblePart(limitToContent(area.translated(by)));
}

/// Shows a point as if the pointer were there, also to screen readers.
void ChartView::readStoredPoint(const StoredPoint& place) {
  const QStringList parts = scene_->storedPointReadout(place.curve, place.index);
  const QPointF at = scenePosition(place);
  pointer_line_x_ = scene_->isPlane() ? -1.0 : at.x();
  hovered_plane_point_ = scene_->isPlane() ? std::optional(at) : std::nullopt;
  if (const QString told = parts.join(""); told != accessibleDescription())
    setAccessibleDescription(told);
  emit readoutChanged(parts);
  viewport()->update();
}

void ChartView::endReading() {
  reading_.reset();
  pointer_line_x_ = -1.0;
  hovered_plane_point_.reset();
  setAccessibleDescription(QString::fromStdString(scene_->page().title));
  emit readoutChanged({});
}

}  // namespace adore::desktop
