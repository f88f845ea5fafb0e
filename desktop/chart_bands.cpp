#include "desktop/chart_scene_parts.hpp"
#include "desktop/dense_line.hpp"

#include <QGraphicsPolygonItem>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace adore::desktop {
namespace {

/// An area of rectangles side by side. A general painter takes ten times as long.
class BandItem : public QGraphicsPolygonItem {
 public:
  BandItem(const QPolygonF& outline, const QColor& colour) : QGraphicsPolygonItem(outline) {
    setPen(Qt::NoPen);
    setBrush(colour);
  }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override {
    if (!draw_band(*painter, polygon(), brush().color()))
      QGraphicsPolygonItem::paint(painter, option, widget);
  }
};

}  // namespace

/// The extremes between values, as a min-max band over each interval from one stored value to the
/// next: from the minimum to the maximum of both values and those between. Intervals within one
/// column of pixels are one piece, a pixel wide, because narrower ones would fade; blocks of a long
/// curve within one column are used as a whole.
void ChartScene::addBand(std::size_t panel, std::size_t which, const QRectF& area,
                         const AxisScale& y_axis, int colour, std::vector<QPolygonF>& drawn) {
  const ChartCurve& curve = page_.panels[panel].curves[which];
  const std::size_t count =
      std::min({page_.x.size(), curve.y.size(), curve.low.size(), curve.high.size()});
  struct Piece {
    qreal left = 0.0, right = 0.0;
    double low = 0.0, high = 0.0;
  };
  std::vector<Piece> pieces;
  const auto flush = [&] {
    if (pieces.empty()) return;
    const auto height = [&](double value) {
      const double shown = y_axis.shown(value);
      if (!(shown > y_axis.min)) return area.bottom();  // of 0 and less on a logarithmic axis, too
      const double at = (shown - y_axis.min) / (y_axis.max - y_axis.min);
      return area.bottom() - std::clamp(at, 0.0, 1.0) * area.height();
    };
    QPolygonF outline;
    for (const Piece& p : pieces) {
      outline.append({p.left, height(p.high)});
      outline.append({p.right, height(p.high)});
    }
    for (auto p = pieces.rbegin(); p != pieces.rend(); ++p) {
      outline.append({p->right, height(p->low)});
      outline.append({p->left, height(p->low)});
    }
    QColor fill = theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()];
    fill.setAlpha(95);
    addItem(new BandItem(outline, fill));
    drawn.push_back(std::move(outline));
    pieces.clear();
  };
  const double per = area.width() / (x_axis_.max - x_axis_.min);
  const auto place = [&](std::size_t i) {
    return area.left() + (x_axis_.shown(page_.x[i]) - x_axis_.min) * per;
  };
  const auto add = [&](qreal from, qreal to, double low, double high) {
    if (from > to) std::swap(from, to);
    if (to - from < 1.0) {
      from = std::floor(from);
      to = from + 1.0;
    }
    from = std::max(from, pieces.empty() ? area.left() : pieces.back().right);
    to = std::min(to, area.right());
    if (from < to) {
      pieces.push_back({from, to, low, high});
    } else if (!pieces.empty()) {
      pieces.back().low = std::min(pieces.back().low, low);
      pieces.back().high = std::max(pieces.back().high, high);
    }
  };
  const LongCurveBlocks* const blocks =
      curve_blocks_.empty() ? nullptr : &curve_blocks_[panel][which];
  const auto [first, last] = abscissa_increasing_ ? indices_between(page_.x, low_, high_)
                                                  : std::pair(std::size_t{0}, count);
  // The interval that the end of the view cuts is drawn as far.
  std::size_t known = count;  // the value at position `begins`
  qreal begins = 0.0;
  for (std::size_t i = first; i < std::min(last + 1, count);) {
    if (!abscissa_increasing_ && (page_.x[i] < low_ || page_.x[i] > high_)) {
      ++i;
      continue;
    }
    const std::size_t b = i / CurveBlocks::kLength, end = i + CurveBlocks::kLength;
    if (blocks != nullptr && i % CurveBlocks::kLength == 0 && end <= last &&
        b < std::min(blocks->low.blocks.size(), blocks->high.blocks.size()) &&
        blocks->low.blocks[b].whole && blocks->high.blocks[b].whole) {
      const qreal from = place(i), to = place(end - 1);
      if (std::floor(from) == std::floor(to)) {
        add(from, to, blocks->low.blocks[b].low, blocks->high.blocks[b].high);
        known = end - 1, begins = to;
        i = end;
        continue;
      }
    }
    if (!is_drawable(curve.low[i]) || !is_drawable(curve.high[i])) {
      flush();
    } else if (i > 0) {
      const double before = is_drawable(curve.y[i - 1]) ? curve.y[i - 1] : curve.low[i];
      const qreal from = known == i - 1 ? begins : place(i - 1), to = place(i);
      add(from, to, std::min(curve.low[i], before), std::max(curve.high[i], before));
      known = i, begins = to;
    }
    ++i;
  }
  flush();
}

namespace {

/// Covered range of each column of pixels from `left` on, downward.
std::vector<Extent> columns_of(const std::vector<QPolygonF>& lines, const QRectF& area) {
  const auto count = static_cast<std::ptrdiff_t>(std::ceil(area.width())) + 1;
  std::vector<Extent> out(static_cast<std::size_t>(count));
  const auto column = [&](qreal x) {
    return std::clamp(static_cast<std::ptrdiff_t>(std::floor(x - area.left())), std::ptrdiff_t{0},
                      count - 1);
  };
  for (const QPolygonF& line : lines)
    for (qsizetype i = 0; i < line.size(); ++i) {
      const QPointF &p = line[std::max<qsizetype>(i - 1, 0)], &q = line[i];
      const qreal low = std::min(p.x(), q.x()), high = std::max(p.x(), q.x());
      if (high < area.left() || low > area.right()) continue;
      const auto height = [&](qreal x) {
        const qreal part = high > low ? std::clamp((x - p.x()) / (q.x() - p.x()), 0.0, 1.0) : 1.0;
        return std::clamp(p.y() + part * (q.y() - p.y()), area.top(), area.bottom());
      };
      for (std::ptrdiff_t c = column(low); c <= column(high); ++c) {
        const qreal left = area.left() + static_cast<qreal>(c);
        Extent& of = out[static_cast<std::size_t>(c)];
        of.include(height(std::max(low, left)));
        of.include(height(std::min(high, left + 1.0)));
        if (high == low) of.include(std::clamp(p.y(), area.top(), area.bottom()));
      }
    }
  return out;
}

}  // namespace

bool ChartScene::areBandsVisible(const std::vector<QPolygonF>& bands,
                                 const std::vector<ShownCurve>& shown, const QRectF& area,
                                 qreal line) {
  constexpr qreal kSeen = 0.7, kSteepest = 2.0;  // [px], and of a line's width
  if (bands.empty()) return false;
  std::vector<std::vector<Extent>> covers;
  for (const ShownCurve& one : shown) covers.push_back(columns_of(one.lines, area));
  std::vector<std::pair<qreal, qreal>> over;
  for (const QPolygonF& band : bands) {
    const qsizetype pieces = band.size() / 4;
    for (qsizetype k = 0; k < pieces; ++k) {
      const QPointF &top = band[2 * k], &bottom = band[band.size() - 1 - 2 * k];
      if (bottom.y() - top.y() < kSeen) continue;
      const auto first = static_cast<std::size_t>(std::max(0.0, top.x() - area.left()));
      const qreal end = band[2 * k + 1].x() - area.left();
      for (std::size_t c = first; static_cast<qreal>(c) < end && c < covers.front().size(); ++c) {
        over.clear();
        for (const std::vector<Extent>& cover : covers) {
          if (cover[c].empty()) continue;
          const qreal half =
              0.5 * line * std::min(std::hypot(1.0, cover[c].high - cover[c].low), kSteepest);
          over.emplace_back(cover[c].low - half, cover[c].high + half);
        }
        std::sort(over.begin(), over.end());
        qreal bare = top.y();  // not covered yet from here down
        for (const auto& [from, to] : over) {
          if (std::min(from, bottom.y()) - bare > kSeen) return true;
          bare = std::max(bare, to);
        }
        if (bottom.y() - bare > kSeen) return true;
      }
    }
  }
  return false;
}

}  // namespace adore::desktop
