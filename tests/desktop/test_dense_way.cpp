#include "desktop/dense_line.hpp"
#include "desktop/dense_way.hpp"
#include "many_turns.hpp"
#include "support/qt_app.hpp"

#include <QImage>
#include <QPainter>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Drawing of paths with very many points.
using namespace adore;
using namespace adore::desktop;
using adore::test::many_turns;
using adore::test::Way;

namespace {

/// Distance of the nearest drawn stroke, by a grid of their points.
class Drawn {
 public:
  explicit Drawn(const std::vector<QPolygonF>& parts) : near_(kSize * kSize) {
    for (const QPolygonF& part : parts)
      for (qsizetype i = 1; i < part.size(); ++i) {
        const QPointF way = part[i] - part[i - 1];
        const int steps = 1 + static_cast<int>(4.0 * std::hypot(way.x(), way.y()));
        for (int k = 0; k <= steps; ++k) put(part[i - 1] + k / double(steps) * way);
      }
  }
  [[nodiscard]] double away(const QPointF& p) const {
    double least = 1e9;
    for (int dx = -2; dx <= 2; ++dx)
      for (int dy = -2; dy <= 2; ++dy) {
        const int c = int(p.x()) + dx, r = int(p.y()) + dy;
        if (c < 0 || r < 0 || c >= kSize || r >= kSize) continue;
        for (const QPointF& q : near_[std::size_t(r * kSize + c)])
          least = std::min(least, std::hypot(q.x() - p.x(), q.y() - p.y()));
      }
    return least;
  }

 private:
  static constexpr int kSize = 420;
  void put(const QPointF& p) {
    if (p.x() >= 0.0 && p.y() >= 0.0 && p.x() < kSize && p.y() < kSize)
      near_[std::size_t(int(p.y()) * kSize + int(p.x()))].push_back(p);
  }
  std::vector<std::vector<QPointF>> near_;
};

}  // namespace

TEST_CASE("dense_way: every place of a way is within a pixel of a stroke that is drawn",
          "[unit][desktop]") {
  const QRectF area(0.0, 0.0, 400.0, 400.0);
  for (const double noise : {0.0, 4.0}) {
    const Way way = many_turns(500, noise);
    const auto parts = visible_path_strokes(way.x, way.y, {}, area);
    std::size_t points = 0;
    for (const QPolygonF& part : parts) points += static_cast<std::size_t>(part.size());
    INFO(noise << ": " << points << " points of " << way.x.size());
    CHECK(points < (noise > 0.0 ? 9 : 6) * way.x.size() / 10);
    const Drawn drawn(parts);
    double farthest = 0.0;
    for (std::size_t i = 1; i < way.x.size(); ++i) {
      const QPointF p(way.x[i - 1], way.y[i - 1]), q(way.x[i], way.y[i]);
      if (!std::isfinite(p.x() + q.x()) || std::abs(p.x()) > 1e4 || std::abs(q.x()) > 1e4) continue;
      for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const QPointF at = p + part * (q - p);
        if (area.contains(at)) farthest = std::max(farthest, drawn.away(at));
      }
    }
    CHECK(farthest < 1.0);
    // The stroke from far outside crosses the picture where it does; none is drawn over the gap.
    const std::size_t middle = way.x.size() / 2;
    const QPointF inside(way.x[middle + 51], way.y[middle + 51]);
    const QPointF towards = QPointF(-1e7, 5e6) - inside;
    CHECK(drawn.away(inside + 100.0 / std::hypot(towards.x(), towards.y()) * towards) < 1.0);
    CHECK(drawn.away({390.0, 12.0}) < 0.3);
  }
  // A path with one turn is complete for any density of points; further turns add almost nothing.
  Way once, again;
  for (int i = 0; i <= 100'000; ++i) {
    const double a = 2.0 * 3.14159265358979 * i / 50'000.0;
    (i <= 50'000 ? once : again).add(200.0 + 150.0 * std::cos(a), 200.0 + 100.0 * std::sin(a));
  }
  const auto length = [](const std::vector<QPolygonF>& parts) {
    double out = 0.0;
    for (const QPolygonF& part : parts)
      for (qsizetype i = 1; i < part.size(); ++i)
        out += std::hypot(part[i].x() - part[i - 1].x(), part[i].y() - part[i - 1].y());
    return out;
  };
  const double whole = length(visible_path_strokes(once.x, once.y, {}, area));
  CHECK(whole == Approx(793.3).epsilon(2e-3));
  once.x.insert(once.x.end(), again.x.begin(), again.x.end());
  once.y.insert(once.y.end(), again.y.begin(), again.y.end());
  CHECK(length(visible_path_strokes(once.x, once.y, {}, area)) < 1.02 * whole);
}

TEST_CASE("dense_way: a picture has ink wherever the whole way has, and nowhere else",
          "[gui][desktop]") {
  test::use_qt();
  const QRectF area(0.0, 0.0, 400.0, 400.0);
  const auto image_of = [&](auto&& paint) {
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
    return image;
  };
  const QPen pen(Qt::black, 1.2);
  for (const double noise : {0.0, 3.0})
    for (const int turns : {1, 40, 400}) {
      Way way = many_turns(turns, noise);
      const QImage all = image_of([&](QPainter& painter) {
        painter.setPen(pen);
        for (std::size_t i = 1; i < way.x.size(); ++i)
          if (std::isfinite(way.x[i - 1] + way.x[i]) && std::abs(way.x[i - 1]) < 1e4 &&
              std::abs(way.x[i]) < 1e4)
            painter.drawLine(QPointF(way.x[i - 1], way.y[i - 1]), QPointF(way.x[i], way.y[i]));
      });
      way.x[way.x.size() / 2 + 50] = std::numeric_limits<double>::quiet_NaN();
      const QImage seen = image_of([&](QPainter& painter) {
        draw_lines(painter, visible_path_strokes(way.x, way.y, {}, area), area, pen);
      });
      const auto ink = [](const QImage& image, int x, int y) {
        return 255 - qRed(image.pixel(x, y));
      };
      int lost = 0, made = 0, inked = 0;
      for (int y = 1; y < 399; ++y)
        for (int x = 1; x < 399; ++x) {
          const auto around = [&](const QImage& image) {
            int most = 0;
            for (int dx = -1; dx <= 1; ++dx)
              for (int dy = -1; dy <= 1; ++dy) most = std::max(most, ink(image, x + dx, y + dy));
            return most;
          };
          inked += ink(all, x, y) > 128 ? 1 : 0;
          lost += ink(all, x, y) > 200 && around(seen) < 100 ? 1 : 0;
          made += ink(seen, x, y) > 60 && around(all) < 20 ? 1 : 0;
        }
      INFO(noise << ", " << turns << " turns, " << inked << " pixels");
      CHECK(inked > 700);
      CHECK(lost == 0);
      CHECK(made == 0);
    }
}
