#include "base/errors.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/lines_page.hpp"
#include "desktop/page_export.hpp"
#include "desktop/svg_writer.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::desktop;
using adore::testing::lines_page;

TEST_CASE("page_export: numbers come back from CSV as they were", "[unit]") {
  ChartPage page = lines_page();
  page.panels[0].curves[0].y[1] = 1.0 / 3.0;
  page.panels[0].curves[1].y[1] = std::nan("");
  page.panels[0].curves[0].name = "a, \"b\"";
  const QStringList rows = QString::fromStdString(page_csv(page)).split('\n');
  REQUIRE(rows.size() == 103);  // head, 101 rows, nothing behind the last line
  CHECK(rows[0] == "Time [s],\"Force, a, \"\"b\"\" [N]\",\"Force, falling [N]\",Length [m]");
  const QStringList row = rows[2].split(',');
  CHECK(row[1].toDouble() == 1.0 / 3.0);
  CHECK(row[2].isEmpty());
}

TEST_CASE("page_export: SVG and PDF hold lines and text, not pixels", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(lines_page());
  save_page(scene, base / "page.svg", {900, 600});
  QFile svg(folder.filePath("page.svg"));
  REQUIRE(svg.open(QIODevice::ReadOnly));
  const QByteArray text = svg.readAll();
  QXmlStreamReader xml(text);
  int paths = 0, words = 0, images = 0;
  QString all;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    paths += xml.name() == QLatin1String("path");
    images += xml.name() == QLatin1String("image");
    if (xml.name() == QLatin1String("text")) {
      ++words;
      all += xml.readElementText() + "|";
    }
  }
  CHECK_FALSE(xml.hasError());
  CHECK(paths > 10);
  CHECK(images == 0);
  CHECK(all.contains("Lines|"));
  CHECK(all.contains("rising|"));
  CHECK(words > 15);
  save_pdf(scene, base / "pages.pdf", 3, {900, 600}, [](std::size_t) {});
  QFile pdf(folder.filePath("pages.pdf"));
  REQUIRE(pdf.open(QIODevice::ReadOnly));
  const QByteArray bytes = pdf.readAll();
  CHECK(bytes.startsWith("%PDF"));
  CHECK(bytes.count("/Type /Page\n") == 3);
  save_page(scene, base / "page.png", {500, 400});
  CHECK(QImage(folder.filePath("page.png")).size() == QSize(500, 400));
  CHECK(scene.sceneRect().size() == QSizeF(900, 600));  // the visible part stays
  CHECK_THROWS_WITH(save_page(scene, base / "page.gif", {500, 400}), Catch::Contains(".svg"));
  CHECK_THROWS_AS(save_page(scene, base / "no" / "page.svg", {500, 400}), InputError);
}

TEST_CASE("svg_writer: clips and gradients as drawn", "[gui]") {
  test::use_qt();
  const QByteArray svg = render_svg({200, 100}, [](QPainter& p) {
    p.translate(10, 0);
    p.save();
    p.setClipRect(QRectF(0.5, 0, 50, 50));
    p.setClipRect(QRectF(20, 20, 100, 100), Qt::IntersectClip);
    p.scale(2.0, 2.0);
    p.drawLine(QPointF(-100, -100), QPointF(100, 100));
    p.restore();
    QLinearGradient shade(0, 0, 40, 0);
    shade.setColorAt(0, Qt::red);
    shade.setColorAt(1, Qt::blue);
    p.setPen(Qt::NoPen);
    p.setBrush(shade);
    p.drawRect(QRectF(60, 10, 40, 40));
  });
  QXmlStreamReader xml(svg);
  QString clip, gradient;
  QStringList paths, clips, fills, stops;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    const auto attribute = [&](const char* name) {
      return xml.attributes().value(QLatin1String(name)).toString();
    };
    if (xml.name() == QLatin1String("clipPath")) clip = attribute("id");
    if (xml.name() == QLatin1String("linearGradient")) gradient = attribute("id");
    if (xml.name() == QLatin1String("stop")) stops << attribute("stop-color");
    if (xml.name() != QLatin1String("path")) continue;
    paths << attribute("d");
    clips << attribute("clip-path");
    fills << attribute("fill");
  }
  INFO(svg.toStdString());
  REQUIRE_FALSE(xml.hasError());
  REQUIRE(paths.size() == 3);  // of the clip, of the line, of the shaded square
  for (const char* corner : {"30,20", "60.5,50"}) CHECK(paths[0].contains(corner));
  CHECK(clips[1] == "url(#" + clip + ")");
  CHECK(clips[2].isEmpty());
  CHECK(fills[2] == "url(#" + gradient + ")");
  CHECK(stops == QStringList{"#ff0000", "#0000ff"});
}

TEST_CASE("page_export: a zoomed chart's curves stay in their panels as SVG", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(lines_page());
  save_page(scene, folder.filePath("page.svg").toStdString(), {900, 600});
  QFile svg(folder.filePath("page.svg"));
  REQUIRE(svg.open(QIODevice::ReadOnly));
  // Each curve is drawn inside the clip of its panel.
  CHECK(svg.readAll().count("clip-path=") >= 2);
}
