#include "desktop/way_tiles.hpp"

#include "desktop/dense_line.hpp"

#include <QImage>
#include <QPainter>
#include <QPen>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

namespace adore::desktop {
namespace {

/// Pixels of a tile in a row. Moving a page by less than one needs at most a row and a column of
/// tiles; for small tiles the strokes are searched more often.
constexpr int kTile = 64;

int tile_of(int pixel) { return pixel >= 0 ? pixel / kTile : -((kTile - 1 - pixel) / kTile); }

/// The tiles that contain some pixels, as rows and columns.
QRect tiles_of(const QRect& pixels) {
  return {QPoint(tile_of(pixels.left()), tile_of(pixels.top())),
          QPoint(tile_of(pixels.right()), tile_of(pixels.bottom()))};
}

QRect pixels_of(int row, int column) { return {column * kTile, row * kTile, kTile, kTile}; }

struct NewTile {
  int row = 0, column = 0;
  std::vector<PointRange> strokes = {};  ///< of the path, that may cross it
  std::vector<std::uint8_t> cover = {};
};

/// Appends the run to each of the new tiles that its box meets; `at` are these by row and column of
/// `tiles`.
class Finder {
 public:
  Finder(const QRect& tiles, std::vector<NewTile>& made)
      : tiles_(tiles), at_(static_cast<std::size_t>(tiles.width() * tiles.height()), nullptr) {
    for (NewTile& tile : made) at_[place(tile.row, tile.column)] = &tile;
  }
  void find(const PathIndex& way, const PlaneScale& scale, double reach) {
    // Far outside there are no such numbers.
    const auto tile = [](double pixel, int least, int most) {
      return static_cast<int>(std::clamp(std::floor(pixel / kTile), least - 1.0, most + 1.0));
    };
    // Visible values: most runs of an enlarged path are elsewhere.
    const double across[] = {tiles_.left() * kTile - reach, (tiles_.right() + 1) * kTile + reach},
                 along[] = {tiles_.top() * kTile - reach, (tiles_.bottom() + 1) * kTile + reach};
    const auto [least_x, most_x] = std::minmax(
        {(across[0] - scale.x_at) / scale.x_per, (across[1] - scale.x_at) / scale.x_per});
    const auto [least_y, most_y] =
        std::minmax({(along[0] - scale.y_at) / scale.y_per, (along[1] - scale.y_at) / scale.y_per});
    for (std::size_t run = 0; run < way.boxes().size(); ++run) {
      const PathIndex::Box& box = way.boxes()[run];
      if (box.left > most_x || box.right < least_x || box.low > most_y || box.high < least_y)
        continue;
      const QPointF one = scale.place(box.left, box.low), other = scale.place(box.right, box.high);
      const auto [left, right] = std::minmax({one.x(), other.x()});
      const auto [top, bottom] = std::minmax({one.y(), other.y()});
      const int first_column = tile(left - reach, tiles_.left(), tiles_.right()),
                last_column = tile(right + reach, tiles_.left(), tiles_.right()),
                first_row = tile(top - reach, tiles_.top(), tiles_.bottom()),
                last_row = tile(bottom + reach, tiles_.top(), tiles_.bottom());
      for (int r = std::max(first_row, tiles_.top()); r <= std::min(last_row, tiles_.bottom()); ++r)
        for (int c = std::max(first_column, tiles_.left());
             c <= std::min(last_column, tiles_.right()); ++c)
          if (NewTile* const met = at_[place(r, c)]) append(*met, way.stretch(run));
    }
  }

 private:
  [[nodiscard]] std::size_t place(int row, int column) const {
    return static_cast<std::size_t>((row - tiles_.top()) * tiles_.width() + column - tiles_.left());
  }
  static void append(NewTile& tile, const PointRange& run) {
    if (!tile.strokes.empty() && tile.strokes.back().end == run.first + 1)
      tile.strokes.back().end = run.end;
    else
      tile.strokes.push_back(run);
  }
  QRect tiles_;
  std::vector<NewTile*> at_;
};

/// Calls use(i) for each i before `count`, on several cores if there are many.
template <class Use>
void share(std::size_t count, Use use) {
  constexpr std::size_t kMany = 4;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) use(i);
  };
  const int threads =
      count < kMany ? 1 : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 4);
  std::vector<std::jthread> others;
  for (int thread = 1; thread < threads; ++thread) others.emplace_back(work);
  work();
}

}  // namespace

bool PathTiles::Look::same_as(const Look& other) const {
  // An axis that moves changes its scale by rounding.
  constexpr double kRounding = 1e-9;
  const auto same = [](double one, double another) {
    return std::abs(one - another) <= kRounding * std::abs(one);
  };
  return same(x_per, other.x_per) && same(y_per, other.y_per) && width == other.width &&
         anchor == other.anchor;
}

void PathTiles::make(const PathIndex& way, const QRect& seen) {
  const QRect tiles = tiles_of(seen);
  std::vector<NewTile> made;
  for (int r = tiles.top(); r <= tiles.bottom(); ++r)
    for (int c = tiles.left(); c <= tiles.right(); ++c)
      if (!tiles_.contains({r, c})) made.push_back({r, c});
  if (made.empty()) return;
  const PlaneScale scale{-look_.x_per * look_.anchor.x(), look_.x_per,
                         -look_.y_per * look_.anchor.y(), look_.y_per};
  const double reach = stamp_radius(look_.width) + 1.0;
  Finder(tiles, made).find(way, scale, reach);
  share(made.size(), [&](std::size_t i) {
    NewTile& tile = made[i];
    const QRect pixels = pixels_of(tile.row, tile.column);
    tile.cover = stamp_coverage(
        visible_path_strokes(way.x(), way.y(), tile.strokes, scale, QRectF(pixels), reach),
        look_.width, pixels);
  });
  for (NewTile& tile : made) tiles_.emplace(Index(tile.row, tile.column), std::move(tile.cover));
}

void PathTiles::draw(QPainter& painter, const PathIndex& way, const PathPlacement& place,
                     const QPen& pen) {
  if (!is_raster_painter(painter) || pen.style() != Qt::SolidLine) {
    draw_lines(painter, visible_path_strokes(way.x(), way.y(), place.scale, place.area), place.area,
               pen);
    return;
  }
  const QTransform& device = painter.deviceTransform();
  const Look look{device.m11() * place.scale.x_per, device.m22() * place.scale.y_per,
                  device.m11() * pen.widthF(), place.anchor};
  if (!look.same_as(look_)) {
    look_ = look;
    tiles_.clear();
  }
  const QPointF at = device.map(place.scale.place(place.anchor.x(), place.anchor.y()));
  const QPoint origin(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  const QRect seen = device.mapRect(place.area).toAlignedRect().translated(-origin);
  if (seen.isEmpty()) return;
  // Half a frame around it may be seen again soon.
  const QRect near = tiles_of(
      seen.adjusted(-seen.width() / 2, -seen.height() / 2, seen.width() / 2, seen.height() / 2));
  std::erase_if(tiles_, [&near](const auto& tile) {
    return !near.contains(QPoint(tile.first.second, tile.first.first));
  });
  make(way, seen);
  QImage image(seen.size(), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  const std::array<QRgb, 256> inks = premultiplied_inks(pen.color());
  const QRect tiles = tiles_of(seen);
  for (int r = tiles.top(); r <= tiles.bottom(); ++r)
    for (int c = tiles.left(); c <= tiles.right(); ++c) {
      const std::vector<std::uint8_t>& cover = tiles_.at({r, c});
      if (cover.empty()) continue;
      const QRect pixels = pixels_of(r, c), part = pixels & seen;
      for (int y = part.top(); y <= part.bottom(); ++y) {
        auto* const to = reinterpret_cast<QRgb*>(image.scanLine(y - seen.top())) - seen.left();
        const std::uint8_t* const from = cover.data() + (y - pixels.top()) * kTile - pixels.left();
        for (int x = part.left(); x <= part.right(); ++x) to[x] = inks[from[x]];
      }
    }
  painter.save();
  painter.setClipRect(place.area, Qt::IntersectClip);
  painter.drawImage(device.inverted().mapRect(QRectF(seen.translated(origin))), image,
                    QRectF(image.rect()));
  painter.restore();
}

}  // namespace adore::desktop
