#include "desktop/chart_scene.hpp"
#include "support/qt_app.hpp"

#include <QFontMetricsF>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

/// Frames and titles hide nothing.
using namespace adore;
using namespace adore::desktop;

TEST_CASE("chart_scene: ends of a curve → distance from the frame", "[gui]") {
  test::use_qt();
  // A spike at the first and at the last value of a flat curve.
  for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark})
    for (const QSize size : {QSize(700, 450), QSize(1280, 800)}) {
      ChartPage page;
      page.title = "Spikes", page.x_title = "Time", page.x_unit = "s";
      ChartCurve curve{"", {}, {}};
      for (int i = 0; i < 2000; ++i) {
        page.x.push_back(1e-3 * i);
        curve.y.push_back(i == 0 || i == 1999 ? -10.0 : 0.0);
      }
      page.panels = {{"Moment", "N.m", {curve}}};
      ChartScene scene;
      scene.setTheme(theme(kind));
      scene.setPageSize(size);
      scene.setPage(page);
      const QImage image = scene.image(size);
      const QRectF area = scene.plotAreas()[0];
      const int row = static_cast<int>(scene.sceneYAt(0, -4.3));
      const auto is = [&](int x, const QColor& colour, int most) {
        const QColor seen = image.pixelColor(x, row);
        return std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                   std::abs(seen.blue() - colour.blue()) <
               most;
      };
      const QColor line = theme(kind).curves[0], paper = theme(kind).surface;
      INFO(size.width() << " wide");
      for (const qreal end : {area.left(), area.right()}) {
        const int at = static_cast<int>(std::floor(end));
        int inked = 0;
        for (int x = at - 2; x <= at + 2; ++x) inked += is(x, line, 120) ? 1 : 0;
        CHECK(inked >= 1);
        // Background on both sides: not mistaken for an axis.
        CHECK(is(at - 3, paper, 30));
        CHECK(is(at + 3, paper, 30));
      }
    }
}

TEST_CASE("chart_scene: long titles are written whole", "[gui]") {
  test::use_qt();
  const std::string longest =
      "Life, original Lundberg-Palmgren, Life, Gupta-Zaretsky type, Life from the loads of the "
      "run, "
      "Mean of the largest contact load over initCageVelRatio";
  for (const int width : {700, 1000, 1280})
    for (const std::size_t length : {std::size_t{20}, std::size_t{70}, longest.size()}) {
      ChartPage page;
      page.title = longest.substr(0, length);
      page.subtitle = "4 runs";
      page.x = {0.0, 1.0};
      page.panels = {{"Force", "N", {{"", {1.0, 2.0}, {}}}}};
      ChartScene scene;
      scene.setPageSize(QSizeF(width, 450));
      scene.setPage(page);
      QString words;
      for (const QGraphicsItem* item : scene.items(Qt::AscendingOrder))
        if (const auto* text = qgraphicsitem_cast<const QGraphicsSimpleTextItem*>(item)) {
          if (!text->font().bold()) continue;
          words += (words.isEmpty() ? "" : " ") + text->text();
          CHECK(text->sceneBoundingRect().right() <= width);
          CHECK(text->sceneBoundingRect().bottom() <= 42.0);  // above the subtitle
          CHECK(text->sceneBoundingRect().top() >= 0.0);
        }
      CHECK(words == QString::fromStdString(page.title).trimmed());
    }
}
