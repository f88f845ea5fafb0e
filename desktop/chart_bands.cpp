#include "desktop/chart_scene_parts.hpp"

#include <algorithm>
#include <cmath>

namespace adore::desktop {

/// The extremes between the values, as a pale area that the lowest and highest value of each column
/// of pixels bound. Blocks of a long curve that stand in one column are taken whole.
void ChartScene::addBand(std::size_t panel, std::size_t which, const QRectF& area,
                         const AxisScale& y_axis, int colour, std::vector<QPolygonF>& drawn) {
  const ChartCurve& curve = page_.panels[panel].curves[which];
  const std::size_t count = std::min({page_.x.size(), curve.low.size(), curve.high.size()});
  struct Column {
    qreal x = 0.0;
    double low = 0.0, high = 0.0;
  };
  std::vector<Column> columns;
  const auto flush = [&] {
    if (columns.size() < 2) {
      columns.clear();
      return;
    }
    const auto height = [&](double value) {
      const double at = (y_axis.shown(value) - y_axis.min) / (y_axis.max - y_axis.min);
      return area.bottom() - std::clamp(at, 0.0, 1.0) * area.height();
    };
    QPolygonF outline;
    for (const Column& c : columns) outline.append({c.x, height(c.high)});
    for (auto c = columns.rbegin(); c != columns.rend(); ++c)
      outline.append({c->x, height(c->low)});
    QColor fill = theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()];
    fill.setAlpha(70);
    addPolygon(outline, QPen(Qt::NoPen), fill);
    drawn.push_back(std::move(outline));
    columns.clear();
  };
  const auto place = [&](std::size_t i) {
    return area.left() +
           (x_axis_.shown(page_.x[i]) - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
  };
  const auto add = [&](qreal x, double low, double high) {
    if (columns.size() > 1 && std::floor(x) == std::floor(columns.back().x)) {
      columns.back().low = std::min(columns.back().low, low);
      columns.back().high = std::max(columns.back().high, high);
    } else {
      columns.push_back({x, low, high});
    }
  };
  const LongCurve* const blocks = blocks_.empty() ? nullptr : &blocks_[panel][which];
  const auto [first, last] =
      rising_ ? places_between(page_.x, low_, high_) : std::pair(std::size_t{0}, count);
  for (std::size_t i = first; i < std::min(last, count);) {
    if (!rising_ && (page_.x[i] < low_ || page_.x[i] > high_)) {
      ++i;
      continue;
    }
    const std::size_t b = i / CurveBlocks::kLength, end = i + CurveBlocks::kLength;
    if (blocks != nullptr && i % CurveBlocks::kLength == 0 && end <= last &&
        b < std::min(blocks->low.blocks.size(), blocks->high.blocks.size()) &&
        blocks->low.blocks[b].whole && blocks->high.blocks[b].whole &&
        std::floor(place(i)) == std::floor(place(end - 1))) {
      add(place(i), curve.low[blocks->low.blocks[b].lowest],
          curve.high[blocks->high.blocks[b].highest]);
      i = end;
      continue;
    }
    if (is_drawable(curve.low[i]) && is_drawable(curve.high[i]))
      add(place(i), curve.low[i], curve.high[i]);
    else
      flush();
    ++i;
  }
  flush();
}

}  // namespace adore::desktop
