#include "desktop/chart_scene.hpp"
#include "desktop/way_tiles.hpp"
#include "many_turns.hpp"
#include "support/qt_app.hpp"

#include <QImage>
#include <QPainter>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

/// Ways of very many points that are moved about in their frame.
using namespace adore;
using namespace adore::desktop;
using adore::test::many_turns;
using adore::test::Way;

namespace {

constexpr int kSize = 400;

/// How far two pictures differ, of 255.
int most_apart(const QImage& one, const QImage& other) {
  REQUIRE(one.size() == other.size());
  int most = 0;
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x)
      most = std::max(most, std::abs(qGreen(one.pixel(x, y)) - qGreen(other.pixel(x, y))));
  return most;
}

QImage paper(int width = kSize, int height = kSize) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  return image;
}

const QPen& ink() {
  static const QPen pen(Qt::black, 1.2);
  return pen;
}

QImage drawn(PathTiles& tiles, const PathIndex& runs, const PathPlacement& place) {
  QImage image = paper();
  QPainter painter(&image);
  tiles.draw(painter, runs, place, ink());
  return image;
}

/// Turns without the point far outside.
Way near_turns(int turns, double noise) {
  Way way = many_turns(turns, noise);
  const std::size_t far = way.x.size() / 2 + 50;
  way.x[far] = way.y[far] = std::numeric_limits<double>::quiet_NaN();
  return way;
}

/// An orbit of many points as a page.
ChartPage page_of(const Way& way) {
  ChartPage page;
  page.title = "Orbit";
  page.equal_axes = true;
  page.x_title = "Y";
  page.panels = {{"Z", "", {{"mass center", way.y, way.x}}}};
  return page;
}

/// `scale`: pixels of the picture to one of the page.
QImage drawn(ChartScene& scene, int scale = 1) {
  constexpr int kWide = 500, kHigh = 420;
  QImage image = paper(scale * kWide, scale * kHigh);
  QPainter painter(&image);
  painter.scale(scale, scale);
  scene.paintPage(painter, QRectF(0, 0, kWide, kHigh));
  return image;
}

}  // namespace

TEST_CASE("way_tiles: tiles have ink wherever the whole way has, and nowhere else",
          "[gui][desktop]") {
  test::use_qt();
  const QRectF area(0.0, 0.0, kSize, kSize);
  for (const double noise : {0.0, 3.0})
    for (const int turns : {12, 40, 400}) {
      const Way way = many_turns(turns, noise);
      // The complete drawing at once, stroke by stroke; without strokes from far outside.
      const Way near = near_turns(turns, noise);
      QImage all = paper(), once = paper();
      {
        QPainter painter(&all);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(ink());
        for (std::size_t i = 1; i < near.x.size(); ++i)
          if (std::isfinite(near.x[i - 1] + near.x[i]))
            painter.drawLine(QPointF(near.x[i - 1], near.y[i - 1]), QPointF(near.x[i], near.y[i]));
        const StampImage stamps = stamp_image(visible_path_strokes(near.x, near.y, {}, area),
                                              ink().widthF(), Qt::black, area.toAlignedRect());
        QPainter other(&once);
        other.drawImage(stamps.place, stamps.image);
      }
      PathTiles tiles;
      const QImage seen = drawn(tiles, PathIndex(near.x, near.y), {{}, {0.0, 0.0}, area});
      const auto ink_at = [](const QImage& image, int x, int y) {
        return 255 - qGreen(image.pixel(x, y));
      };
      int lost = 0, made = 0, inked = 0, added = 0;
      for (int y = 1; y < kSize - 1; ++y)
        for (int x = 1; x < kSize - 1; ++x) {
          const auto around = [&](const QImage& image) {
            int most = 0;
            for (int dx = -1; dx <= 1; ++dx)
              for (int dy = -1; dy <= 1; ++dy) most = std::max(most, ink_at(image, x + dx, y + dy));
            return most;
          };
          inked += ink_at(all, x, y) > 128 ? 1 : 0;
          lost += ink_at(all, x, y) > 200 && around(seen) < 100 ? 1 : 0;
          made += ink_at(seen, x, y) > 60 && around(all) < 20 ? 1 : 0;
          added += ink_at(seen, x, y) > ink_at(once, x, y) + 2 ? 1 : 0;
        }
      INFO(noise << ", " << turns << " turns, " << inked << " pixels");
      CHECK(inked > 700);
      CHECK(lost == 0);
      CHECK(made == 0);
      // No stroke that the picture as a whole leaves out, but for rounding at the edges of tiles.
      CHECK(added < inked / 500);
      // Strokes from far outside cross all tiles in between.
      PathTiles others;
      const QImage crossed = drawn(others, PathIndex(way.x, way.y), {{}, {0.0, 0.0}, area});
      const std::size_t far = way.x.size() / 2 + 50;
      const QPointF from(way.x[far + 1], way.y[far + 1]),
          along = QPointF(way.x[far], way.y[far]) - from;
      for (double away = 5.0;; away += 10.0) {
        const QPointF at = from + away / std::hypot(along.x(), along.y()) * along;
        if (!area.adjusted(1, 1, -1, -1).contains(at)) break;
        INFO(at.x() << ", " << at.y());
        CHECK(ink_at(crossed, static_cast<int>(at.x()), static_cast<int>(at.y())) > 60);
      }
    }
}

TEST_CASE("way_tiles: a frame that moves over a way shows the same as one that has not moved",
          "[gui][desktop]") {
  test::use_qt();
  const Way way = many_turns(300, 2.0);
  const PathIndex runs(way.x, way.y);
  PathTiles kept;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  PathPlacement place{{0.0, 1.0, 0.0, -1.0}, {200.0, 200.0}, {30.0, 20.0, 150.0, 120.0}};
  PlaneScale& scale = place.scale;
  std::size_t most_kept = 0;
  int seen = 0;
  for (int move = 0; move < 60; ++move) {
    // Small moves, some far ones, and twice another scale.
    const double far = move % 8 == 0 ? 150.0 : 9.0;
    scale.x_at = std::clamp(scale.x_at + far * some(random), -200.0, 100.0);
    scale.y_at = std::clamp(scale.y_at + far * some(random), 100.0, 400.0);
    if (move == 15 || move == 30) scale.x_per *= 1.01, scale.y_per *= 1.01;
    PathTiles fresh;
    const QImage one = drawn(kept, runs, place), other = drawn(fresh, runs, place);
    INFO("move " << move << " to " << scale.x_at << ", " << scale.y_at);
    CHECK(most_apart(one, other) <= 1);
    seen += most_apart(other, paper()) > 200 ? 1 : 0;
    most_kept = std::max(most_kept, kept.kept());
  }
  CHECK(seen > 40);
  CHECK(most_kept < 40);  // of 64 pixels each: the frame and half as much around it
}

TEST_CASE("way_tiles: an orbit that was moved is drawn as one that was built there",
          "[gui][desktop]") {
  test::use_qt();
  const ChartPage page = page_of(near_turns(100, 2.0));
  for (const int scale : {1, 2}) {
    ChartScene moved;
    moved.setPage(page);
    (void)drawn(moved, scale);
    const QRectF area = moved.plotAreas().front();
    moved.setPlaneView(QRectF(area.center(), 0.13 * area.size()));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> some(-40.0, 40.0);
    int inked = 0;
    for (int move = 0; move < 12; ++move) {
      const bool dragged = move % 3 != 0;  // by whole pixels
      QPointF by(some(random), some(random));
      if (dragged) by = by.toPoint();
      moved.setPlaneView(area.translated(by));
      ChartScene built;
      built.setPage(page);
      (void)drawn(built, scale);
      built.setZoom(moved.zoom());
      INFO("move " << move << " by " << by.x() << ", " << by.y());
      const QImage one = drawn(moved, scale);
      CHECK(most_apart(one, drawn(built, scale)) <= 1);
      built.showCurve(0, 0, false);
      inked += most_apart(one, drawn(built, scale)) > 60 ? 1 : 0;
    }
    CHECK(inked > 9);
  }
}

TEST_CASE("way_tiles: a point of a long orbit is drawn where its axes say, wherever it is moved",
          "[gui][desktop]") {
  test::use_qt();
  // Off the ring, between gaps: its dot is alone.
  Way way = near_turns(12, 0.0);
  const double none = std::numeric_limits<double>::quiet_NaN();
  way.add(none, none);
  for (int i = 0; i < 3; ++i) way.add(210.0, 205.0);
  way.add(none, none);
  for (int i = 0; i < 3; ++i) way.add(320.0, 200.0);  // the mark of the end is not there
  ChartScene scene, without;
  scene.setPage(page_of(way));
  for (std::size_t i = 1; i <= 3; ++i) way.x[way.x.size() - 4 - i] = none;
  without.setPage(page_of(way));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  for (int view = 0; view < 20; ++view) {
    (void)drawn(scene), (void)drawn(without);
    if (view > 0) {
      const double half = 20.0 + 16.0 * some(random);
      const double x = 210.0 + 3.0 * some(random), y = 205.0 + 3.0 * some(random);
      scene.setZoom({0.0, 1.0, {std::pair(y - half, y + half), std::pair(x - half, x + half)}});
      without.setZoom(scene.zoom());
    }
    const QImage with_dot = drawn(scene), empty = drawn(without);
    const auto at = scene.planePosition(210.0, 205.0);
    REQUIRE(at);
    QPointF sum;
    double weight = 0.0;
    for (int y = 0; y < empty.height(); ++y)
      for (int x = 0; x < empty.width(); ++x) {
        const double ink = std::abs(qRed(with_dot.pixel(x, y)) - qRed(empty.pixel(x, y)));
        sum += ink * QPointF(x + 0.5, y + 0.5);
        weight += ink;
      }
    INFO("view " << view << ", " << at->x() << ", " << at->y());
    REQUIRE(weight > 100.0);
    CHECK(std::hypot(sum.x() / weight - at->x(), sum.y() / weight - at->y()) < 0.1);
  }
}

TEST_CASE("way_runs: the point that is nearest to a place is found as by a look at all of them",
          "[unit][desktop]") {
  const Way way = many_turns(7, 2.0);
  const PathIndex runs(way.x, way.y);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> some(0.0, 400.0);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const double x = some(random), y = some(random), reach = i % 2 == 0 ? 400.0 : 1e12;
    std::optional<std::size_t> nearest;
    double least = reach, most = reach;
    for (std::size_t k = 0; k < way.x.size(); ++k) {
      const double dx = way.x[k] - x, dy = way.y[k] - y;
      if (dx * dx + dy * dy <= least) least = dx * dx + dy * dy, nearest = k;
    }
    CHECK(runs.nearest(x, y, most) == nearest);
    CHECK(most == least);
    found += nearest ? 1 : 0;
  }
  CHECK(found > 200);
  CHECK(found < 300);
}

TEST_CASE("way_tiles: an orbit shows its own points after another page, curve by curve",
          "[gui][desktop]") {
  test::use_qt();
  const auto page = [](double radius, bool first_hidden) {
    ChartPage out;
    out.title = "Orbit";
    out.equal_axes = true;
    out.x_title = "Y";
    ChartPanel panel{"Z", "", {}};
    for (const double r : {radius, 0.5 * radius}) {
      ChartCurve curve{r == radius ? "outer" : "inner", {}, {}};
      for (int i = 0; i <= 6000; ++i) {
        const double a = 2.0 * 3.14159265358979 * i / 2000.0;
        curve.x.push_back(r * std::cos(a) + (i == 0 ? 1.0 : 0.0));  // one scale for all pages
        curve.y.push_back(r * std::sin(a) + (i == 1 ? 1.0 : 0.0));
      }
      panel.curves.push_back(std::move(curve));
    }
    panel.curves[0].hidden = first_hidden;
    out.panels = {panel};
    return out;
  };
  const auto drawn = [&](ChartScene& scene, const ChartPage& of) {
    scene.setPage(of);
    return scene.image(QSize(700, 450));
  };
  ChartScene scene;
  for (const bool hidden : {false, true})
    for (const double radius : {1.0, 0.9, 1.0}) {
      ChartScene own;
      CHECK(drawn(scene, page(radius, hidden)) == drawn(own, page(radius, hidden)));
    }
  CHECK(drawn(scene, page(1.0, false)) != drawn(scene, page(0.9, false)));
}
