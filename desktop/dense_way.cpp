#include "desktop/dense_way.hpp"

#include <QColor>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <thread>

namespace adore::desktop {
namespace {

constexpr double kCells = 1.4143;  ///< to a pixel: none is longer than one across

/// Visited small squares of a picture. Their edges do not depend on the position of the picture.
class Cells {
 public:
  explicit Cells(const QRectF& area)
      : left_(std::floor(area.left() * kCells) / kCells),
        top_(std::floor(area.top() * kCells) / kCells),
        columns_(static_cast<int>(std::ceil(area.width() * kCells)) + 2),
        rows_(static_cast<int>(std::ceil(area.height() * kCells)) + 2),
        passed_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}
  [[nodiscard]] int at(const QPointF& p) const { return row(p.y()) * columns_ + column(p.x()); }
  [[nodiscard]] bool is_new(int cell) const { return passed_[static_cast<std::size_t>(cell)] == 0; }
  void pass(int cell) { passed_[static_cast<std::size_t>(cell)] = 1; }
  /// Visits all cells of a stroke except the first one; both ends are inside. True if one of them
  /// was new.
  bool pass_to(const QPointF& p, const QPointF& q) {
    const int c = column(p.x()), r = row(p.y());
    int across = column(q.x()) - c, along = row(q.y()) - r;  // cells to go
    const int step_c = across > 0 ? 1 : -1, step_r = along > 0 ? columns_ : -columns_;
    // Parts of the stroke to the next edge, and from one to the next.
    const auto edge = [](double from, int cell, double length) {
      return std::abs(length) < 1e-12 ? 2.0 : (cell + (length > 0.0 ? 1 : 0) - from) / length;
    };
    const auto apart = [](double length) { return 1.0 / std::max(std::abs(length), 1e-12); };
    const double dx = (q.x() - p.x()) * kCells, dy = (q.y() - p.y()) * kCells;
    double next_c = edge((p.x() - left_) * kCells, c, dx),
           next_r = edge((p.y() - top_) * kCells, r, dy);
    const double per_c = apart(dx), per_r = apart(dy);
    across = std::abs(across);
    along = std::abs(along);
    bool any = false;
    int cell = r * columns_ + c;
    while (across + along > 0) {
      if (along == 0 || (across > 0 && next_c < next_r)) {
        cell += step_c;
        next_c += per_c;
        --across;
      } else {
        cell += step_r;
        next_r += per_r;
        --along;
      }
      any |= is_new(cell);
      pass(cell);
    }
    return any;
  }

 private:
  [[nodiscard]] int column(double x) const {
    return std::clamp(static_cast<int>((x - left_) * kCells), 0, columns_ - 1);
  }
  [[nodiscard]] int row(double y) const {
    return std::clamp(static_cast<int>((y - top_) * kCells), 0, rows_ - 1);
  }
  double left_, top_;
  int columns_, rows_;
  std::vector<std::uint8_t> passed_;
};

/// A part of a picture and the rest of the cells that it cuts: strokes there count, too.
QRectF whole_cells(const QRectF& area) {
  const auto down = [](double at) { return std::floor(at * kCells) / kCells; };
  const auto up = [](double at) { return std::ceil(at * kCells) / kCells; };
  return {QPointF(down(area.left()), down(area.top())),
          QPointF(up(area.right()), up(area.bottom()))};
}

/// Cuts a stroke at the edges of `area`. False: nothing of it is inside.
bool cut(QPointF& p, QPointF& q, const QRectF& area) {
  if (std::max(p.x(), q.x()) < area.left() || std::min(p.x(), q.x()) > area.right() ||
      std::max(p.y(), q.y()) < area.top() || std::min(p.y(), q.y()) > area.bottom())
    return false;
  double from = 0.0, to = 1.0;
  const QPointF a = p, way = q - p;
  const auto keep = [&](double start, double length, double low, double high) {
    if (length == 0.0) return start >= low && start <= high;
    const double one = (low - start) / length, other = (high - start) / length;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    return from <= to;
  };
  if (!keep(a.x(), way.x(), area.left(), area.right()) ||
      !keep(a.y(), way.y(), area.top(), area.bottom()))
    return false;
  p = a + from * way;
  q = a + to * way;
  return true;
}

}  // namespace

std::vector<QPolygonF> visible_path_strokes(const std::vector<double>& x,
                                            const std::vector<double>& y, const PlaneScale& scale,
                                            const QRectF& area) {
  constexpr double kMargin = 4.0;  // strokes outside the picture reach into it [px]
  return visible_path_strokes(x, y, {{0, std::min(x.size(), y.size())}}, scale, area, kMargin);
}

std::vector<QPolygonF> visible_path_strokes(const std::vector<double>& x,
                                            const std::vector<double>& y,
                                            const std::vector<PointRange>& stretches,
                                            const PlaneScale& scale, const QRectF& area,
                                            double margin) {
  const QRectF around = whole_cells(area.adjusted(-margin, -margin, margin, margin));
  const double left = around.left(), right = around.right(), top = around.top(),
               bottom = around.bottom();
  Cells cells(around);
  std::vector<QPolygonF> out;
  QPointF end;  // of the last drawing
  const auto draw = [&](const QPointF& p, const QPointF& q) {
    if (out.empty() || end != p) out.push_back({p});
    out.back().append(q);
    end = q;
  };
  bool known = false, fresh = false;  // is the cell of the point before new on this visit?
  QPointF p;
  int cell = -1;  // none: outside
  const auto go_to = [&](const QPointF& q) {
    if (!std::isfinite(q.x()) || !std::isfinite(q.y())) {
      known = false;
      return;
    }
    const bool inside = q.x() >= left && q.x() <= right && q.y() >= top && q.y() <= bottom;
    if (!known) {
      cell = inside ? cells.at(q) : -1;
      fresh = inside && cells.is_new(cell);
      if (fresh) cells.pass(cell);
    } else if (inside && cell >= 0) {
      const int next = cells.at(q);
      if (next == cell) {
        if (fresh) draw(p, q);
      } else {
        const bool seen = cells.pass_to(p, q);
        if (seen || fresh) draw(p, q);
        fresh = seen;
        cell = next;
      }
    } else {  // one end or both are outside
      QPointF from = p, to = q;
      const bool passes = cut(from, to, around);
      if (passes) {
        const int first = cells.at(from);
        const bool begins = cells.is_new(first);
        cells.pass(first);
        const bool seen = cells.pass_to(from, to) || begins;
        if (seen || fresh) draw(from, to);
        fresh = seen;
      }
      cell = inside ? cells.at(q) : -1;
      fresh = fresh && inside;
    }
    p = q;
    known = true;
  };
  for (const PointRange& stretch : stretches) {
    known = false;
    for (std::size_t i = stretch.first; i < stretch.end; ++i) go_to(scale.place(x[i], y[i]));
  }
  return out;
}

namespace {

/// Coverage of the pixels of the rows `first` to before `end`; `reach`: end of the coverage, from
/// the middle of a stroke.
void stamp_rows(const std::vector<QPolygonF>& lines, float reach, const QRect& within, int first,
                int end, std::vector<std::uint8_t>& cover) {
  const int columns = within.width();
  for (const QPolygonF& line : lines)
    for (qsizetype i = 1; i < line.size(); ++i) {
      // Single numbers: thousandths of a pixel, in half the time.
      const auto px = static_cast<float>(line[i - 1].x() - within.left()),
                 py = static_cast<float>(line[i - 1].y() - within.top()),
                 dx = static_cast<float>(line[i].x() - line[i - 1].x()),
                 dy = static_cast<float>(line[i].y() - line[i - 1].y());
      const float square = dx * dx + dy * dy, per = square > 0.0F ? 1.0F / square : 0.0F;
      const bool steep = std::abs(dy) > 2.0F * reach;
      const float per_row = steep ? 1.0F / dy : 0.0F;
      const int top =
                    std::max(first, static_cast<int>(std::floor(py + std::min(0.0F, dy) - reach))),
                bottom = std::min(end - 1, static_cast<int>(py + std::max(0.0F, dy) + reach));
      for (int r = top; r <= bottom; ++r) {
        // The part of the stroke that is near this row.
        const float y = static_cast<float>(r) + 0.5F - py;
        float low = px + std::min(0.0F, dx), high = px + std::max(0.0F, dx);
        if (steep) {
          const float one = std::clamp((y - reach) * per_row, 0.0F, 1.0F),
                      other = std::clamp((y + reach) * per_row, 0.0F, 1.0F);
          low = px + std::min(one * dx, other * dx);
          high = px + std::max(one * dx, other * dx);
        }
        const int left = std::max(0, static_cast<int>(std::floor(low - reach))),
                  right = std::min(columns - 1, static_cast<int>(high + reach));
        std::uint8_t* const row = cover.data() + static_cast<std::ptrdiff_t>(r) * columns;
        for (int c = left; c <= right; ++c) {
          if (row[c] == 255) continue;
          const float x = static_cast<float>(c) + 0.5F - px;
          const float part = std::clamp((x * dx + y * dy) * per, 0.0F, 1.0F);
          const float ex = x - part * dx, ey = y - part * dy, away = ex * ex + ey * ey;
          if (away >= reach * reach) continue;
          const float here = std::min(1.0F, reach - std::sqrt(away));
          row[c] = std::max(row[c], static_cast<std::uint8_t>(255.0F * here + 0.5F));
        }
      }
    }
}

}  // namespace

double stamp_radius(double width) { return 0.5 * width + 0.5; }

std::vector<std::uint8_t> stamp_coverage(const std::vector<QPolygonF>& lines, double width,
                                         const QRect& within) {
  if (lines.empty() || within.isEmpty()) return {};
  std::vector<std::uint8_t> cover(static_cast<std::size_t>(within.width()) *
                                  static_cast<std::size_t>(within.height()));
  stamp_rows(lines, static_cast<float>(stamp_radius(width)), within, 0, within.height(), cover);
  return cover;
}

std::array<QRgb, 256> premultiplied_inks(const QColor& colour) {
  std::array<QRgb, 256> out;
  for (int c = 0; c < 256; ++c)
    out[static_cast<std::size_t>(c)] = qPremultiply(
        qRgba(colour.red(), colour.green(), colour.blue(), (c * colour.alpha() + 127) / 255));
  return out;
}

StampImage stamp_image(const std::vector<QPolygonF>& lines, double width, const QColor& colour,
                       const QRect& within) {
  StampImage out;
  if (within.isEmpty()) return out;
  const int columns = within.width(), rows = within.height();
  std::vector<std::uint8_t> cover(static_cast<std::size_t>(columns) *
                                  static_cast<std::size_t>(rows));
  const auto reach = static_cast<float>(stamp_radius(width));
  // Each thread has separate rows; for few strokes a thread is not worthwhile.
  constexpr qsizetype kMany = 20'000;
  qsizetype points = 0;
  for (const QPolygonF& line : lines) points += line.size();
  const int bands =
      points < kMany ? 1 : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 4);
  {
    std::vector<std::jthread> others;
    for (int band = 1; band < bands; ++band)
      others.emplace_back([&, band] {
        stamp_rows(lines, reach, within, band * rows / bands, (band + 1) * rows / bands, cover);
      });
    stamp_rows(lines, reach, within, 0, rows / bands, cover);
  }
  if (std::all_of(cover.begin(), cover.end(), [](std::uint8_t c) { return c == 0; })) return out;
  const std::array<QRgb, 256> inks = premultiplied_inks(colour);
  out.image = QImage(columns, rows, QImage::Format_ARGB32_Premultiplied);
  for (int r = 0; r < rows; ++r) {
    auto* const pixels = reinterpret_cast<QRgb*>(out.image.scanLine(r));
    const std::uint8_t* const row = cover.data() + static_cast<std::ptrdiff_t>(r) * columns;
    for (int c = 0; c < columns; ++c) pixels[c] = inks[row[c]];
  }
  out.place = within.topLeft();
  return out;
}

}  // namespace adore::desktop
