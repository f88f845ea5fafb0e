#include "desktop/stroke_mask.hpp"

#include "desktop/dense_line.hpp"
#include "desktop/dense_way.hpp"

#include <QColor>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::desktop {
namespace {

/// Vertical strips of a column of pixels; within one the line is its bounding rectangle.
constexpr int kStrips = 4;

/// How much of each pixel of a column is covered by intervals along it.
class Column {
 public:
  explicit Column(int rows) : part_(static_cast<std::size_t>(rows) + 1), rise_(part_.size()) {}
  /// Adds `weight` times the cover of [top, bottom].
  void add(double top, double bottom, float weight) {
    const auto rows = static_cast<double>(part_.size() - 1);
    top = std::clamp(top, 0.0, rows);
    bottom = std::clamp(bottom, 0.0, rows);
    if (!(bottom > top)) return;
    const auto first = static_cast<std::size_t>(top), last = static_cast<std::size_t>(bottom);
    from_ = std::min(from_, first);
    to_ = std::max(to_, std::min(last, part_.size() - 2));
    if (first == last) {
      part_[first] += weight * static_cast<float>(bottom - top);
      return;
    }
    part_[first] += weight * static_cast<float>(static_cast<double>(first + 1) - top);
    part_[last] += weight * static_cast<float>(bottom - static_cast<double>(last));
    rise_[first + 1] += weight;
    rise_[last] -= weight;
  }
  /// Calls use(row, cover) for the added parts, and clears them.
  template <class Use>
  void take(Use use) {
    float whole = 0.0F;
    for (std::size_t row = from_; row <= to_ && from_ < part_.size(); ++row) {
      whole += rise_[row];
      use(static_cast<int>(row), std::min(1.0F, whole + part_[row]));
      part_[row] = rise_[row] = 0.0F;
    }
    part_.back() = rise_.back() = 0.0F;
    from_ = part_.size();
    to_ = 0;
  }

 private:
  std::vector<float> part_, rise_;
  std::size_t from_ = part_.size(), to_ = 0;
};

/// A round pen as strips: its extent up and down, number of strips next to its middle. Only a part
/// of the outermost strip belongs to it.
struct Pen {
  explicit Pen(double radius) {
    const double all = 2.0 * radius * kStrips;  // strips
    const int whole = std::max(0, static_cast<int>(std::floor(0.5 * (all - 1.0))));
    part = static_cast<float>(std::clamp(0.5 * (all - (2.0 * whole + 1.0)), 0.0, 1.0));
    for (int aside = 0; aside <= whole + 1; ++aside) {
      const double x = static_cast<double>(aside) / kStrips;
      reach.push_back(std::sqrt(std::max(0.0, radius * radius - x * x)));
    }
  }
  std::vector<double> reach;
  float part;
  [[nodiscard]] int most() const { return static_cast<int>(reach.size()) - 1; }
};

/// An empty image of a color, to be laid on in covers.
struct Cover {
  Cover(const QRect& box, const QColor& colour)
      : out{QImage(box.size(), QImage::Format_ARGB32_Premultiplied), box.topLeft()},
        stride(static_cast<std::size_t>(out.image.bytesPerLine()) / sizeof(QRgb)),
        inks(premultiplied_inks(colour)) {
    out.image.fill(Qt::transparent);
    pixels = reinterpret_cast<QRgb*>(out.image.bits());
  }
  /// Keeps larger existing coverage. `x` counts from the left of the picture, not of the image.
  void lay(Column& column, int x) {
    column.take([&](int row, float cover) {
      QRgb& pixel = pixels[static_cast<std::size_t>(row) * stride +
                           static_cast<std::size_t>(x - out.place.x())];
      const QRgb ink = inks[static_cast<std::size_t>(std::lround(255.0F * cover))];
      if (qAlpha(ink) > qAlpha(pixel)) pixel = ink;
    });
  }
  StrokeImage out;
  std::size_t stride;
  QRgb* pixels = nullptr;
  std::array<QRgb, 256> inks;
};

struct Interval {
  double top = 1e300, bottom = -1e300;
  void include(const ColumnBar& bar, double reach) {
    top = std::min(top, bar.top - reach);
    bottom = std::max(bottom, bar.bottom + reach);
  }
};

}  // namespace

StrokeImage stroke_image(const std::vector<QPolygonF>& lines, double width, const QColor& colour,
                         const QRect& within) {
  const double radius = 0.5 * width;
  QRectF around;
  for (const QPolygonF& line : lines)
    around = around.united(line.boundingRect().adjusted(0, 0, 1e-3, 1e-3));
  const QRect box =
      around.adjusted(-radius - 1.0, -radius - 1.0, radius + 1.0, radius + 1.0).toAlignedRect() &
      within;
  if (box.isEmpty()) return {};
  Cover cover(box, colour);
  const Pen pen(radius);
  const int most = pen.most();  // strips to either side
  Column column(box.height());
  for (const QPolygonF& line : lines) {
    const double margin = radius + 1.0;
    const std::vector<ColumnBar> bars =
        column_bars(line, box.left() - margin, box.right() + 1.0 + margin, kStrips);
    if (bars.empty()) continue;
    const int first = bars.front().column, last = bars.back().column;
    const int from = std::max(first - most, box.left() * kStrips),
              to = std::min(last + most, (box.right() + 1) * kStrips - 1);
    int now = from >= 0 ? from / kStrips : -((kStrips - 1 - from) / kStrips);
    for (int strip = from; strip <= to; ++strip) {
      const int of = strip >= 0 ? strip / kStrips : -((kStrips - 1 - strip) / kStrips);
      if (of != now) {
        cover.lay(column, now);
        now = of;
      }
      Interval inner;
      for (int at = std::max(strip - most + 1, first); at <= std::min(strip + most - 1, last); ++at)
        inner.include(bars[static_cast<std::size_t>(at - first)],
                      pen.reach[static_cast<std::size_t>(std::abs(at - strip))]);
      Interval outer = inner;
      for (const int at : {strip - most, strip + most})
        if (at >= first && at <= last)
          outer.include(bars[static_cast<std::size_t>(at - first)], pen.reach.back());
      column.add(inner.top - box.top(), inner.bottom - box.top(), (1.0F - pen.part) / kStrips);
      column.add(outer.top - box.top(), outer.bottom - box.top(), pen.part / kStrips);
    }
    cover.lay(column, now);
  }
  return std::move(cover.out);
}

StrokeImage band_image(const QPolygonF& outline, const QColor& colour) {
  const QRect box = outline.boundingRect().toAlignedRect();
  if (box.isEmpty()) return {};
  Cover cover(box, colour);
  Column column(box.height());
  const qsizetype pieces = outline.size() / 4;
  int now = box.left();
  for (qsizetype k = 0; k < pieces; ++k) {
    const QPointF &top = outline[2 * k], &bottom = outline[outline.size() - 1 - 2 * k];
    const double right = outline[2 * k + 1].x();
    for (double x = top.x(); x < right;) {
      const int of = static_cast<int>(std::floor(x));
      if (of != now) {
        cover.lay(column, now);
        now = of;
      }
      const double end = std::min(right, of + 1.0);
      column.add(top.y() - box.top(), bottom.y() - box.top(), static_cast<float>(end - x));
      x = end;
    }
  }
  cover.lay(column, now);
  return std::move(cover.out);
}

}  // namespace adore::desktop
