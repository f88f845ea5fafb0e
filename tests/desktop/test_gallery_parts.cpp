#include "desktop/few_colours.hpp"
#include "desktop/text_faults.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsSimpleTextItem>
#include <QPainter>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;

TEST_CASE("few_colours: a picture of few colors stays as it is, others nearly", "[gui]") {
  test::use_qt();
  QImage plain(40, 30, QImage::Format_RGB32);
  plain.fill(QColor(250, 251, 252));
  for (int x = 0; x < 20; ++x) plain.setPixelColor(x, 3, QColor(10, 200, 30));
  const QImage few = desktop::reduce_colors(plain);
  CHECK(few.format() == QImage::Format_Indexed8);
  CHECK(few.convertToFormat(QImage::Format_RGB32) == plain);
  QImage many(256, 256, QImage::Format_RGB32);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) many.setPixelColor(x, y, QColor(x, y, 100));
  const QImage less = desktop::reduce_colors(many);
  CHECK(desktop::reduce_colors(many, 32).colorCount() == 32);
  CHECK(less.colorCount() == 256);
  int worst = 0;
  for (int y = 0; y < 256; y += 5)
    for (int x = 0; x < 256; x += 5)
      worst = std::max(worst, std::abs(less.pixelColor(x, y).red() - x));
  CHECK(worst < 48);  // 256 colors for 1,024 boxes of 8: a few boxes off
}

TEST_CASE("few_colours: mixed shading has no stripes, and paper, lines and letters stay clean",
          "[gui]") {
  test::use_qt();
  // A body lit from one side, on paper, with marks of many colors that want their own.
  QImage shaded(400, 300, QImage::Format_RGB32);
  shaded.fill(Qt::white);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 400; ++x)
      shaded.setPixelColor(x, y,
                           QColor(90 + x * 120 / 400, 100 + x * 115 / 400, 110 + x * 110 / 400));
  for (int i = 0; i < 400; ++i)
    shaded.setPixelColor(i, 250, QColor::fromHsv(i * 359 / 400, 255, 220));
  for (int x = 0; x < 400; ++x) shaded.setPixelColor(x, 280, Qt::black);
  const auto worst = [&](const QImage& few) {  // of the light that an eye sees: of 8 by 8 pixels
    double out = 0.0;
    for (int y = 8; y + 8 < 200; y += 8)
      for (int x = 0; x + 8 <= 400; x += 8) {
        double off = 0.0;
        for (int j = 0; j < 64; ++j)
          off += qGray(few.pixel(x + j % 8, y + j / 8)) - qGray(shaded.pixel(x + j % 8, y + j / 8));
        out = std::max(out, std::abs(off) / 64.0);
      }
    return out;
  };
  const QImage mixed = desktop::dither_colors(shaded);
  CHECK(mixed.colorCount() <= 256);
  CHECK(worst(mixed) < 1.5);
  CHECK(worst(desktop::reduce_colors(shaded, 64)) > 2.0);  // stripes
  for (int y = 201; y < 300; ++y)
    for (int x = 0; x < 400; x += 7)
      if (y != 250 && y != 249 && y != 251) REQUIRE(mixed.pixel(x, y) == shaded.pixel(x, y));
}

TEST_CASE("text_faults: words over each other and beyond the edge are named", "[gui]") {
  test::use_qt();
  desktop::ChartScene scene;
  scene.setPageSize(QSizeF(700, 450));
  desktop::ChartPage page;
  page.title = "A page";
  page.x_title = "Time";
  page.x_unit = "s";
  for (int i = 0; i < 50; ++i) page.x.push_back(i);
  page.panels.push_back({"Load", "N", {{"outer race", page.x, {}}}});
  scene.setPage(page);
  CHECK(desktop::text_faults(scene).empty());
  scene.addSimpleText("beyond")->setPos(690, 100);
  auto* first = scene.addSimpleText("first");
  first->setPos(300, 200);
  scene.addSimpleText("second")->setPos(305, 202);
  const auto faults = desktop::text_faults(scene);
  REQUIRE(faults.size() == 2);
  bool edge = false, over = false;
  for (const std::string& fault : faults) {
    edge = edge || fault == "\"beyond\" is cut off at the page's edge";
    over = over || fault.find("lies over") != std::string::npos;
  }
  CHECK(edge);
  CHECK(over);
  first->setVisible(false);
  CHECK(desktop::text_faults(scene).size() == 1);
}

TEST_CASE("chart_scene: an axis title too long for its panel stands above it, whole", "[gui]") {
  test::use_qt();
  desktop::ChartScene scene;
  scene.setPageSize(QSizeF(700, 450));
  desktop::ChartPage page;
  page.title = "A page";
  page.note = "A remark of this page, which takes room.";
  page.x_title = "Bearing rotation";
  for (int i = 0; i < 50; ++i) page.x.push_back(i);
  for (const char* title : {"Contact temperature rise", "Race contact temperature", "Load"})
    page.panels.push_back({title, "K", {{"outer race", page.x, {}}, {"inner race", page.x, {}}}});
  page.panels.push_back({"A difference from a large value", "K", {{"", {}, {}}}});
  for (int i = 0; i < 50; ++i) page.panels.back().curves[0].y.push_back(1000.0 + 1e-4 * i);
  scene.setPage(page);
  CHECK(desktop::text_faults(scene).empty());
  const auto shown = [&](const QString& text) {
    for (const QGraphicsItem* item : scene.items())
      if (const auto* words = dynamic_cast<const QGraphicsSimpleTextItem*>(item);
          words != nullptr && words->text() == text)
        return words;
    return static_cast<const QGraphicsSimpleTextItem*>(nullptr);
  };
  QStringList all;
  for (const QGraphicsItem* item : scene.items())
    if (const auto* words = dynamic_cast<const QGraphicsSimpleTextItem*>(item))
      all << words->text();
  INFO(all.join(" / ").toStdString());
  REQUIRE(shown("Contact temperature rise [K]") != nullptr);
  CHECK(shown("Contact temperature rise [K]")->rotation() == 0.0);
  CHECK(shown("Race contact temperature [K]") != nullptr);
  REQUIRE(shown("Load [K]") != nullptr);
  CHECK(shown("Load [K]")->rotation() == 0.0);  // all of a page stand one way
}

TEST_CASE("chart_scene: the base of an axis hides no curve while one corner of its panel is free",
          "[gui]") {
  test::use_qt();
  desktop::ChartScene scene(desktop::ChartStyle::Compact);
  // A curve that leaves one corner free, which depends on its shape; names leave little room.
  for (const auto& [width, names] : {std::pair{300.0, "at -x"}, {300.0, "a longer name"}})
    for (int shape = 0; shape < 4; ++shape) {
      desktop::ChartPage page;
      page.x_title = "Time";
      std::vector<double> y;
      for (int i = 0; i <= 200; ++i) {
        page.x.push_back(i);
        const double along = shape % 2 == 0 ? i / 200.0 : 1.0 - i / 200.0;
        const double rise = 1.0 - std::exp(-8.0 * along);
        y.push_back(25e-6 + 4e-8 * (shape < 2 ? rise : 1.0 - rise));
      }
      page.panels.push_back({"Gap", "m", {{names, y, {}}, {names, y, {}}}});
      scene.setPageSize(QSizeF(width, 240));
      scene.setPage(page);
      const QGraphicsSimpleTextItem* base = nullptr;
      for (const QGraphicsItem* item : scene.items())
        if (const auto* words = dynamic_cast<const QGraphicsSimpleTextItem*>(item);
            words != nullptr && words->text().contains("from 25"))
          base = words;
      REQUIRE(base != nullptr);
      INFO(names << ", shape " << shape);
      int hidden = 0;
      for (std::size_t i = 0; i < y.size(); ++i)
        if (base->sceneBoundingRect().contains(scene.sceneXAt(page.x[i]), scene.sceneYAt(0, y[i])))
          ++hidden;
      CHECK(hidden == 0);
      CHECK(desktop::text_faults(scene).empty());
    }
}
