#include "desktop/chart_page.hpp"
#include "desktop/chart_scene.hpp"
#include "support/qt_app.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace adore::desktop;

namespace {

constexpr std::size_t kSteps = 100'000;

struct Curve {
  std::vector<double> x, y;
};

/// A wave with a single high step, a single low one, and gaps.
Curve long_curve() {
  Curve out;
  std::mt19937 random(15);
  double x = 0.0;
  for (std::size_t i = 0; i < kSteps; ++i) {
    x += 1e-6 * (1.0 + static_cast<double>(random() % 100U) / 100.0);
    out.x.push_back(x);
    out.y.push_back(std::sin(1e-3 * static_cast<double>(i)));
  }
  out.y[51'234] = 7.0;
  out.y[60'001] = -9.0;
  for (std::size_t i = 70'000; i < 70'300; ++i) out.y[i] = std::numeric_limits<double>::quiet_NaN();
  return out;
}

/// Lowest and highest y of each of so many columns of the view.
std::map<int, std::pair<double, double>> columns_of(const std::vector<Polyline>& pieces, double low,
                                                    double high, int columns) {
  std::map<int, std::pair<double, double>> out;
  for (const Polyline& piece : pieces)
    for (std::size_t i = 0; i < piece.x.size(); ++i) {
      if (piece.x[i] < low || piece.x[i] > high) continue;
      const int c = static_cast<int>(std::floor((piece.x[i] - low) / (high - low) * columns));
      const auto [at, fresh] = out.try_emplace(c, piece.y[i], piece.y[i]);
      at->second.first = std::min(at->second.first, piece.y[i]);
      at->second.second = std::max(at->second.second, piece.y[i]);
    }
  return out;
}

double extreme(const std::vector<Polyline>& pieces, bool highest) {
  double out = 0.0;
  for (const Polyline& piece : pieces)
    for (const double y : piece.y) out = highest ? std::max(out, y) : std::min(out, y);
  return out;
}

}  // namespace

TEST_CASE("chart_page: a long curve drawn by its blocks hides no peak and keeps its gaps",
          "[unit][desktop]") {
  const Curve curve = long_curve();
  const CurveBlocks blocks = blocks_of(curve.y, false);
  constexpr int kColumns = 500;
  for (const auto& [from, to] :
       {std::pair{0.0, 1.0}, {0.31, 0.72}, {0.512, 0.5126}, {0.69, 0.71}}) {
    const double low = from * curve.x.back(), high = to * curve.x.back();
    INFO(from << " to " << to);
    const auto quick = drawable_polylines(curve.x, curve.y, low, high, kColumns, false, &blocks);
    const auto exact = drawable_polylines(curve.x, curve.y, low, high, kColumns, false);
    CHECK(quick.size() == exact.size());
    CHECK(extreme(quick, true) == extreme(exact, true));
    CHECK(extreme(quick, false) == extreme(exact, false));
    // Values of a column may be off by one block at most, where the wave changes by 0.26.
    const auto a = columns_of(quick, low, high, kColumns),
               b = columns_of(exact, low, high, kColumns);
    for (const auto& [column, range] : a) {
      const auto found = b.find(column);
      if (found == b.end()) continue;
      CHECK(range.first >= found->second.first - 0.26);
      CHECK(range.second <= found->second.second + 0.26);
    }
  }
}

TEST_CASE("chart_page: angles that wrap are broken where they wrap, also in blocks",
          "[unit][desktop]") {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < 20'000; ++i) {
    x.push_back(static_cast<double>(i));
    y.push_back(std::remainder(0.1 * static_cast<double>(i), 360.0));  // wraps every 3,600
  }
  const CurveBlocks blocks = blocks_of(y, true);
  const auto quick = drawable_polylines(x, y, 0.0, 20'000.0, 300, true, &blocks);
  CHECK(quick.size() == drawable_polylines(x, y, 0.0, 20'000.0, 300, true).size());
  for (const Polyline& piece : quick)
    for (std::size_t i = 1; i < piece.y.size(); ++i) CHECK(piece.y[i] >= piece.y[i - 1]);
}

TEST_CASE("chart_page: pieces of a long curve are counted as they are drawn", "[unit][desktop]") {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < 20'000; ++i) {
    x.push_back(static_cast<double>(i));
    y.push_back(std::remainder(0.7 * static_cast<double>(i), 360.0));
    if (i % 1'777 < 40) y.back() = std::numeric_limits<double>::quiet_NaN();
  }
  for (const bool wraps : {false, true}) {
    const CurveBlocks blocks = blocks_of(y, wraps);
    for (const auto& [from, to] :
         {std::pair<std::size_t, std::size_t>{0, 20'000}, {31, 33}, {1'780, 9'999}, {64, 128}}) {
      INFO(from << " to " << to << ", wraps " << wraps);
      CHECK(count_pieces_between(y, from, to, wraps, blocks) ==
            drawable_polylines(
                {x.begin() + static_cast<long>(from), x.begin() + static_cast<long>(to)},
                {y.begin() + static_cast<long>(from), y.begin() + static_cast<long>(to)}, 0.0,
                20'000.0, 300, wraps)
                .size());
    }
  }
}

TEST_CASE("chart_page: an angle of very many wraps is joined, a few points to a column",
          "[unit][desktop]") {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < 1'000'000; ++i) {
    x.push_back(static_cast<double>(i));
    y.push_back(std::remainder(3.0 * static_cast<double>(i), 360.0));
  }
  y[500'007] = 200.0;  // the only value beyond half a turn
  const CurveBlocks blocks = blocks_of(y, true);
  constexpr int kColumns = 1'000;
  const auto pieces = drawable_polylines(x, y, 0.0, 1e6, kColumns, true, &blocks);
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0].x.size() <= 8 * kColumns);
  CHECK(extreme(pieces, true) == 200.0);
  CHECK(extreme(pieces, false) < -179.0);
}

TEST_CASE("chart_page: an angle of some hundred wraps has few points, its wraps and its extremes",
          "[unit][desktop]") {
  constexpr int kColumns = 1'000;
  for (const unsigned seed : {1U, 2U, 3U}) {
    // A turn that is uneven, now forwards, now backwards; and some jumps of less than a wrap.
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> even(-1.0, 1.0);
    std::vector<double> x, y;
    double angle = 0.0, speed = 0.3;
    for (std::size_t i = 0; i < 600'000; ++i) {
      speed = std::clamp(speed + 0.002 * even(random), -0.4, 0.4);
      angle += speed;
      if (i % 91'000 == 90'000) angle += 150.0;
      x.push_back(static_cast<double>(i));
      y.push_back(std::remainder(angle, 360.0));
    }
    const CurveBlocks blocks = blocks_of(y, true);
    const auto quick = drawable_polylines(x, y, 0.0, 6e5, kColumns, true, &blocks);
    const auto exact = drawable_polylines(x, y, 0.0, 6e5, kColumns, true);
    INFO("seed " << seed << ", " << exact.size() << " pieces");
    REQUIRE(exact.size() > 10);
    CHECK(quick.size() == exact.size());
    CHECK(extreme(quick, true) == extreme(exact, true));
    CHECK(extreme(quick, false) == extreme(exact, false));
    std::size_t points = 0;
    for (const Polyline& piece : quick) {
      points += piece.x.size();
      for (std::size_t i = 1; i < piece.y.size(); ++i)
        CHECK(std::abs(piece.y[i] - piece.y[i - 1]) <= 180.0);
    }
    CHECK(points <= 8 * kColumns + 100 * exact.size());
    const auto a = columns_of(quick, 0.0, 6e5, kColumns), b = columns_of(exact, 0.0, 6e5, kColumns);
    for (const auto& [column, range] : a) {  // off by the change of one column at most
      const auto found = b.find(column);
      if (found == b.end()) continue;
      CHECK(range.first >= found->second.first - 0.4 * 600.0);
      CHECK(range.second <= found->second.second + 0.4 * 600.0);
    }
  }
}

TEST_CASE("chart_scene: the axis of a long curve reaches its only peak", "[gui]") {
  adore::test::use_qt();
  const Curve curve = long_curve();
  ChartPage page;
  page.x = curve.x;
  page.panels.push_back({"Load", "N", {{"", curve.y, {}}}});
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(page);
  const auto top = [&] { return scene.valueAt(0, scene.plotAreas()[0].top()); };
  CHECK(top() >= 7.0);
  CHECK(scene.valueAt(0, scene.plotAreas()[0].bottom()) <= -9.0);
  CHECK(scene.lineCount(0) == 2);
  scene.setView(0.0, 0.5 * curve.x.back());  // before the peak at half of it
  CHECK(top() < 2.0);
  scene.setView(0.5 * curve.x.back(), 0.52 * curve.x.back());
  CHECK(top() >= 7.0);
}

TEST_CASE("chart_page: the range of any part of a long curve is that of its values",
          "[unit][desktop]") {
  const Curve curve = long_curve();
  const CurveBlocks blocks = blocks_of(curve.y, false);
  const std::size_t span = CurveBlocks::kSpan, count = curve.y.size();
  REQUIRE(count > 4 * span);
  for (const std::size_t from :
       {std::size_t{0}, std::size_t{1}, span - 1, span, span + 7, 2 * span})
    for (const std::size_t to :
         {from, from + 1, 2 * span - 1, 2 * span, 3 * span + 5, count - 1, count, count + 5}) {
      if (to < from) continue;
      Extent exact;
      for (std::size_t i = from; i < std::min(to, count); ++i) exact.include(curve.y[i]);
      const Extent quick = extent_between(curve.y, from, to, blocks);
      INFO(from << " to " << to);
      CHECK(quick.low == exact.low);
      CHECK(quick.high == exact.high);
    }
}
