#include "desktop/chart_scene.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// Texts and drawing of a curve that coincides with another one.
using namespace adore;
using namespace adore::desktop;

namespace {

ChartPage page_of(std::vector<double> lower, std::vector<double> upper) {
  ChartPage page;
  page.title = "Two curves";
  page.x_title = "Time";
  page.x_unit = "s";
  for (std::size_t i = 0; i < lower.size(); ++i) page.x.push_back(1e-3 * static_cast<double>(i));
  page.panels = {
      {"Load", "N", {{"outer race", std::move(lower), {}}, {"inner race", std::move(upper), {}}}}};
  return page;
}

QString legend_of(const ChartScene& scene) {
  QString out;
  for (QGraphicsItem* item : scene.items())
    if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item);
        text != nullptr && text->text().startsWith("inner race"))
      out = text->text();
  return out;
}

}  // namespace

TEST_CASE("chart_scene: lines side by side are whole, in every size of a picture",
          "[gui][desktop]") {
  test::use_qt();
  // A ramp, and the same a little higher over its second half: by parts of a line's width.
  constexpr std::size_t kPoints = 900;
  constexpr double kLine = 1.6;
  for (const QSizeF size : {QSizeF(700, 450), QSizeF(1000, 620), QSizeF(1280, 800)})
    for (const double lines : {0.1, 0.8, 1.0, 1.5, 3.0}) {
      ChartScene scene;
      scene.setPageSize(size);
      std::vector<double> lower, upper;
      for (std::size_t i = 0; i < kPoints; ++i) lower.push_back(static_cast<double>(i % 300));
      scene.setPage(page_of(lower, lower));
      const QRectF area = scene.plotAreas()[0];
      const double pixel =
          (scene.valueAt(0, area.top()) - scene.valueAt(0, area.bottom())) / area.height();
      for (std::size_t i = 0; i < kPoints; ++i)
        upper.push_back(lower[i] + (i < kPoints / 2 ? 30.0 : 0.0) * pixel +
                        (i < kPoints / 2 ? 0.0 : lines * kLine * pixel));
      scene.setPage(page_of(lower, upper));
      INFO(size.width() << " wide, " << lines
                        << " lines apart: " << legend_of(scene).toStdString());
      CHECK(legend_of(scene).contains("≈") == (lines < 0.3));
    }
}

TEST_CASE("chart_scene: both of two equal curves are seen along a line of any slope",
          "[gui][desktop]") {
  test::use_qt();
  constexpr double kFarthest = 48.0;  // a bend of the stripes, and one of them either side [px]
  const auto& colours = theme(ThemeKind::Light).curves;
  const auto away = [](const QColor& a, QRgb b) {
    return std::abs(a.red() - qRed(b)) + std::abs(a.green() - qGreen(b)) +
           std::abs(a.blue() - qBlue(b));
  };
  for (const bool rising : {true, false})
    for (const double slope : {0.2, 0.5, 0.8, 0.95, 1.0, 1.05, 1.3, 2.0, 5.0}) {
      ChartScene scene;
      scene.setTheme(theme(ThemeKind::Light));
      scene.setPageSize({1280, 800});
      const std::vector<double> line =
          rising ? std::vector<double>{0.0, 1.0} : std::vector<double>{1.0, 0.0};
      scene.setPage(page_of(line, line));
      const QRectF area = scene.plotAreas()[0];
      const double half = 0.5 * area.height() / (slope * area.width());
      scene.setPanelView(0, std::pair(0.5 - half, 0.5 + half));
      REQUIRE(legend_of(scene).contains("="));
      const QImage image = scene.image({1280, 800});
      const double step = 0.5 / std::hypot(1.0, slope);  // half a pixel of the way
      double farthest = 0.0, begun = area.left(), lengths[2] = {0.0, 0.0};
      int last = -1;
      for (double x = area.left() + 2.0; x < area.right() - 2.0; x += step) {
        const double y =
            scene.sceneYAt(0, (rising ? 1.0 : -1.0) * (x - area.center().x()) / area.width() + 0.5);
        if (y < area.top() + 3.0 || y > area.bottom() - 3.0) continue;
        const QRgb ink = image.pixel(QPointF(x, y).toPoint());
        const int own = away(colours[0], ink) < away(colours[1], ink) ? 0 : 1;
        if (own != last) begun = x;
        last = own;
        lengths[own] += 0.5;
        farthest = std::max(farthest, (x - begun) * std::hypot(1.0, slope));
      }
      INFO((rising ? "rising " : "falling ") << slope << ": " << farthest << " px of one colour");
      CHECK(farthest < kFarthest);
      CHECK(lengths[0] > 0.1 * (lengths[0] + lengths[1]));
      CHECK(lengths[1] > 0.1 * (lengths[0] + lengths[1]));
    }
}

TEST_CASE("chart_scene: a panel's size and shape change no word for curves that lie together",
          "[gui][desktop]") {
  test::use_qt();
  // Steep loads, 1 % apart: over a narrow and high panel their values differ by more than a line
  // width, although they look equal. Their extremes are separate.
  constexpr std::size_t kPoints = 6000;
  std::vector<double> lower, upper;
  for (std::size_t i = 0; i < kPoints; ++i) {
    lower.push_back(750.0 + 750.0 * std::cos(2e-3 * static_cast<double>(i)));
    upper.push_back(750.0 + 750.0 * std::cos(2e-3 * (static_cast<double>(i) + 8.0)));
  }
  for (const ChartStyle style : {ChartStyle::Page, ChartStyle::Compact})
    for (const QSizeF size : {QSizeF(700, 450), QSizeF(420, 1200)})
      for (const bool bands : {false, true}) {
        ChartScene scene(style);
        scene.setPageSize(size);
        ChartPage page = page_of(lower, upper);
        for (ChartCurve& curve : page.panels[0].curves)
          if (bands) curve.low = curve.high = curve.y;
        scene.setPage(page);
        INFO(size.width() << " wide: " << legend_of(scene).toStdString());
        CHECK(legend_of(scene).contains("≈"));
      }
}

TEST_CASE("chart_scene: what scatters about the bound is one stretch, not many", "[gui][desktop]") {
  test::use_qt();
  // As far apart as 0.2 to 0.5 of a line: a bound between the two would cut it all over.
  constexpr std::size_t kPoints = 1200;
  const auto lines_of = [&](double low, double high) {
    ChartScene scene;
    scene.setPageSize({1280, 800});
    std::vector<double> lower(kPoints), upper(kPoints);
    for (std::size_t i = 0; i < kPoints; ++i) lower[i] = static_cast<double>(i);
    scene.setPage(page_of(lower, lower));
    const QRectF area = scene.plotAreas()[0];
    const double line =
        1.6 * (scene.valueAt(0, area.top()) - scene.valueAt(0, area.bottom())) / area.height();
    for (std::size_t i = 0; i < kPoints; ++i)
      upper[i] = lower[i] + (i < kPoints / 2 ? 40.0 : i % 20 < 10 ? low : high) * line;
    scene.setPage(page_of(lower, upper));
    return legend_of(scene);
  };
  CHECK(lines_of(0.2, 0.5).contains("partly ≈"));
  CHECK_FALSE(lines_of(0.5, 0.55).contains("≈"));  // nowhere near enough to begin
  CHECK_FALSE(lines_of(0.2, 5.0).contains("≈"));   // crossings
}

TEST_CASE("chart_scene: spike of a partly covered curve → complete", "[gui][desktop]") {
  test::use_qt();
  // 20,000 values, 30 of them a spike: many to a pixel, so that lines are thinned.
  for (const QSize size : {QSize(700, 450), QSize(1280, 800)})
    for (const std::size_t at : {7001UL, 9500UL, 12013UL, 15020UL}) {
      std::vector<double> lower(20'000, 0.0), upper(20'000, 0.0);
      for (std::size_t k = 0; k < 30; ++k)
        upper[at + k] = 100.0 - 6.0 * std::abs(static_cast<double>(k) - 15.0);
      upper[at - 1] = upper[at + 30] = 4.0;
      ChartScene scene;
      const Theme& colours = theme(ThemeKind::Light);
      scene.setTheme(colours);
      scene.setPageSize(size);
      scene.setPage(page_of(lower, upper));
      REQUIRE(legend_of(scene).contains("partly"));
      const QImage image = scene.image(size);
      const int x = static_cast<int>(scene.sceneXAt(1e-3 * static_cast<double>(at + 15)));
      const int top = static_cast<int>(scene.sceneYAt(0, 95.0)),
                bottom = static_cast<int>(scene.sceneYAt(0, 3.0));
      int bare = 0;
      for (int y = top; y <= bottom; ++y) {
        bool ink = false;
        for (int dx = -4; dx <= 4; ++dx) {
          const QColor pixel = image.pixelColor(x + dx, y);
          ink = ink || (pixel.red() > pixel.blue() + 80 && pixel.red() > 180);
        }
        bare += ink ? 0 : 1;
      }
      INFO(size.width() << " wide, spike at " << at);
      CHECK(bare == 0);
    }
}

TEST_CASE("chart_scene: covering curve without values → curve complete", "[gui][desktop]") {
  test::use_qt();
  for (const std::size_t count : {300UL, 20'000UL}) {
    std::vector<double> lower(count, 5.0), upper(count, 5.0);
    lower[0] = upper[0] = 0.0;
    for (std::size_t i = count / 3; i < 2 * count / 3; ++i)
      lower[i] = std::numeric_limits<double>::quiet_NaN();
    ChartScene scene;
    scene.setTheme(theme(ThemeKind::Light));
    scene.setPageSize({1280, 800});
    const ChartPage page = page_of(lower, upper);
    scene.setPage(page);
    INFO(count << " values, " << legend_of(scene).toStdString());
    REQUIRE(legend_of(scene).contains("partly = outer race"));
    const QImage image = scene.image({1280, 800});
    const int y = static_cast<int>(scene.sceneYAt(0, 5.0));
    const int left = static_cast<int>(scene.sceneXAt(page.x[count / 3])) + 4,
              right = static_cast<int>(scene.sceneXAt(page.x[2 * count / 3])) - 4;
    int bare = 0;
    for (int x = left; x <= right; ++x) {
      bool ink = false;
      for (int dy = -2; dy <= 2; ++dy) {
        const QColor pixel = image.pixelColor(x, y + dy);
        ink = ink || (pixel.red() > pixel.blue() + 80 && pixel.red() > 180);
      }
      bare += ink ? 0 : 1;
    }
    CHECK(bare == 0);
  }
}

TEST_CASE("chart_scene: label identical only for equal values, in every picture size",
          "[gui][desktop]") {
  test::use_qt();
  // Equal to the last digit over a part of the run, before they part at some slope, or never.
  constexpr std::size_t kPoints = 4000;
  for (const double part : {0.1, 0.5, 1.0})
    for (const double slope : {0.0, 0.3, 3.0, 300.0})
      for (const QSizeF size : {QSizeF(700, 450), QSizeF(860, 510), QSizeF(1000, 620),
                                QSizeF(1280, 800), QSizeF(420, 1200)}) {
        std::vector<double> lower, upper;
        for (std::size_t i = 0; i < kPoints; ++i) {
          const double t = static_cast<double>(i) / kPoints;
          lower.push_back(100.0 * std::sin(9.0 * t));
          upper.push_back(lower.back() + slope * std::max(0.0, t - part));
        }
        if (slope > 0.0 && part < 1.0) upper.back() = 150.0;  // nowhere within a line of it
        ChartScene scene;
        scene.setPageSize(size);
        scene.setPage(page_of(lower, upper));
        INFO(size.width() << " wide, " << part << " of the run, slope " << slope << ": "
                          << legend_of(scene).toStdString());
        CHECK(legend_of(scene).contains("="));
        CHECK_FALSE(legend_of(scene).contains("≈"));
      }
}

TEST_CASE("chart_scene: curves that lie together share the way over time and over frequency",
          "[gui][desktop]") {
  test::use_qt();
  // Two spectra: one peak each, otherwise both near 0.
  for (const char* const unit : {"s", "Hz"})
    for (const bool log_x : {false, true}) {
      std::vector<double> lower, upper;
      for (std::size_t i = 0; i < 1000; ++i) {
        const auto at = static_cast<double>(i);
        lower.push_back(std::exp(-std::pow((at - 100.0) / 20.0, 2)) + 1e-5);
        upper.push_back(std::exp(-std::pow((at - 160.0) / 20.0, 2)) + 2e-5);
      }
      ChartPage page = page_of(lower, upper);
      page.x_unit = unit;
      for (double& x : page.x) x += 1e-3;
      page.log_x = log_x;
      const QSize size(1000, 620);
      ChartScene scene;
      scene.setTheme(theme(ThemeKind::Light));
      scene.setPageSize(size);
      scene.setPage(page);
      INFO(unit << (log_x ? ", logarithmic: " : ": ") << legend_of(scene).toStdString());
      CHECK(legend_of(scene).contains("partly ≈"));
      const QImage image = scene.image(size);
      const auto& colours = theme(ThemeKind::Light).curves;
      int of[2] = {0, 0};
      const int from = static_cast<int>(scene.sceneXAt(0.4)),
                to = static_cast<int>(scene.sceneXAt(0.9)),
                y = static_cast<int>(scene.sceneYAt(0, 0.0));
      for (int x = from; x < to; ++x)
        for (const int row : {y - 1, y})
          for (const int c : {0, 1}) {
            const QColor a = image.pixelColor(x, row), b = colours[static_cast<std::size_t>(c)];
            of[c] += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                                 std::abs(a.blue() - b.blue()) <
                             90
                         ? 1
                         : 0;
          }
      CHECK(of[0] > (to - from) / 5);
      CHECK(of[1] > (to - from) / 5);
    }
}
