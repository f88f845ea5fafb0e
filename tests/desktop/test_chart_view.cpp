#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/chrome.hpp"
#include "desktop/gif_writer.hpp"
#include "desktop/mp4_writer.hpp"
#include "desktop/page_export.hpp"
#include "desktop/svg_writer.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QGraphicsLineItem>
#include <QGraphicsPolygonItem>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <QImageReader>
#include <QPainter>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::desktop;

namespace {

/// y = 2x and y = 100 - x over 0 .. 10 in one panel, 3 in another.
ChartPage lines_page() {
  ChartPage page;
  page.title = "Lines";
  page.x_title = "Time";
  page.x_unit = "s";
  ChartPanel force{"Force", "N", {{"rising", {}, {}}, {"falling", {}, {}}}, false};
  ChartPanel still{"Length", "m", {{"", {}, {}}}, false};
  for (int i = 0; i <= 100; ++i) {
    const double x = 0.1 * i;
    page.x.push_back(x);
    force.curves[0].y.push_back(2.0 * x);
    force.curves[1].y.push_back(100.0 - x);
    still.curves[0].y.push_back(3e-18 * std::sin(x));
  }
  page.panels = {force, still};
  return page;
}

void click(ChartView& view, QPointF place, Qt::KeyboardModifiers keys = Qt::NoModifier) {
  QTest::mouseClick(view.viewport(), Qt::LeftButton, keys, view.mapFromScene(place));
}

}  // namespace

TEST_CASE("statistics between two places have the values of a straight line", "[unit]") {
  std::vector<double> x, y;
  for (int i = 0; i <= 100; ++i) x.push_back(0.1 * i), y.push_back(6.0 * x.back());
  const CurveStatistics s = statistics_between(x, y, 3.0, 1.0);
  CHECK(s.count == 21);
  CHECK(s.lowest == Approx(6.0));
  CHECK(s.highest == Approx(18.0));
  CHECK(s.mean == Approx(12.0));
  // RMS of a trapezoidal sum: sqrt(36 (1/2) int x^2) + 36 h^2/6.
  CHECK(s.rms == Approx(std::sqrt(36.0 * (27.0 - 1.0) / 6.0 + 36.0 * 0.01 / 6.0)).epsilon(1e-6));
  // Unequal steps weigh by what they stand for.
  CHECK(statistics_between({0.0, 1.0, 9.0, 10.0}, {0.0, 0.0, 1.0, 1.0}, 0.0, 10.0).mean ==
        Approx(0.5));
  CHECK(statistics_between(x, y, 20.0, 30.0).count == 0);
  CHECK(nearest_index(x, 4.96) == 50);
  CHECK(nearest_index(x, -5.0) == 0);
}

TEST_CASE("chart_view: cursors stand on stored values and tell what lies between", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  view.showPage(lines_page());
  ChartScene& scene = view.chartScene();
  const QRectF area = scene.plotAreas()[0];
  click(view, {scene.positionOf(2.0), area.center().y()}, Qt::ControlModifier);
  click(view, {scene.positionOf(7.0), area.center().y()}, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(view.cursorAt(0) == Approx(2.0));
  CHECK(view.cursorAt(1) == Approx(7.0));
  const QString report = view.cursorReport();
  INFO(report.toStdString());
  CHECK(report.contains("B − A: 5 s"));
  CHECK(report.contains("rising:  A 4 N  B 14 N  B − A 10 N  min 4 N  max 14 N  mean 9 N"));
  CHECK(report.contains("falling:  A 98 N"));
  view.showPage(lines_page());  // the same abscissa: they stay
  CHECK(view.cursorAt(0) == Approx(2.0));
  ChartPage other = lines_page();
  other.x_unit = "rev";
  view.showPage(other);
  CHECK(std::isnan(view.cursorAt(0)));
}

TEST_CASE("chart_view: cursors tell a small motion about a large value", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  ChartPage page = lines_page();
  page.panels.resize(1);
  page.panels[0].unit = "m";
  page.panels[0].curves.resize(1);
  ChartCurve& curve = page.panels[0].curves[0];
  for (std::size_t i = 0; i < curve.y.size(); ++i)
    curve.y[i] = 0.030005 + 7e-7 * std::sin(0.3 * static_cast<double>(i));
  curve.y[20] = 0.0300051234;
  view.showPage(page);
  const QRectF area = view.chartScene().plotAreas()[0];
  click(view, {view.chartScene().positionOf(page.x[20]), area.center().y()}, Qt::ControlModifier);
  INFO(view.cursorReport().toStdString());
  CHECK(view.cursorReport().contains("30.0051234 mm"));
}

TEST_CASE("chart_view: a box zooms both ways, views come back, and outlive a change of page",
          "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  view.showPage(lines_page());
  ChartScene& scene = view.chartScene();
  const auto place = [&](double x, double y) {
    return view.mapFromScene(QPointF(scene.positionOf(x), scene.heightOf(0, y)));
  };
  const QPoint from = place(2.0, 80.0), to = place(6.0, 20.0);
  QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, from);
  QTest::mouseMove(view.viewport(), to);
  QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, to);
  CHECK(scene.viewLow() == Approx(2.0).margin(0.05));
  CHECK(scene.viewHigh() == Approx(6.0).margin(0.05));
  REQUIRE(scene.zoom().panels[0].has_value());
  CHECK(scene.zoom().panels[0]->first == Approx(20.0).margin(1.0));
  CHECK(scene.zoom().panels[0]->second == Approx(80.0).margin(1.0));
  CHECK_FALSE(scene.zoom().panels[1].has_value());
  CHECK(scene.valueAt(0, scene.heightOf(0, 50.0)) == Approx(50.0));
  ChartPage next = lines_page();
  next.panels.pop_back();
  view.showPage(next);  // another page over the same time
  CHECK(scene.viewLow() == Approx(2.0).margin(0.05));
  view.zoomBack();
  CHECK(scene.viewLow() == 0.0);
  CHECK(scene.viewHigh() == Approx(10.0));
  view.zoomForward();
  CHECK(scene.viewHigh() == Approx(6.0).margin(0.05));
  view.zoomAll();
  CHECK_FALSE(scene.zoomed());
}

TEST_CASE("chart_view: everything is more than the part that a page begins with", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  ChartPage page = lines_page();
  page.view_low = 1.0;
  page.view_high = 3.0;
  view.showPage(page);
  const ChartScene& scene = view.chartScene();
  CHECK_FALSE(scene.whole());
  CHECK(scene.viewHigh() == 3.0);
  view.zoomAll();
  CHECK(scene.whole());
  CHECK(scene.viewLow() == page.x.front());
  CHECK(scene.viewHigh() == page.x.back());
  view.zoomAll();  // and back to the part
  CHECK(scene.viewLow() == 1.0);
  CHECK(scene.viewHigh() == 3.0);
  view.zoomAll();
  view.zoomBack();
  CHECK(scene.viewHigh() == 3.0);
}

TEST_CASE("chart_view: a click in the legend hides a curve, and the axis follows the others",
          "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  view.showPage(lines_page());
  ChartScene& scene = view.chartScene();
  REQUIRE(scene.legend().size() == 2);  // of the panel with two curves
  const auto entry = [&](std::size_t curve) {
    for (const LegendEntry& e : scene.legend())
      if (e.curve == curve) return e.place.center();
    return QPointF();
  };
  CHECK(scene.linesOf(0) == 2);
  click(view, entry(1));
  CHECK(scene.page().panels[0].curves[1].hidden);
  CHECK(scene.linesOf(0) == 1);
  const QRectF area = scene.plotAreas()[0];
  CHECK(scene.valueAt(0, area.top()) < 25.0);  // the rising curve ends at 20
  click(view, entry(1));
  CHECK_FALSE(scene.page().panels[0].curves[1].hidden);
  // A cursor's click never hides one.
  click(view, entry(1), Qt::ControlModifier);
  click(view, entry(1), Qt::ControlModifier | Qt::ShiftModifier);
  CHECK_FALSE(scene.page().panels[0].curves[1].hidden);
}

TEST_CASE("chart_scene: rounding below an atom's size fills no axis", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(lines_page());
  const QRectF area = scene.plotAreas()[1];
  CHECK(scene.valueAt(1, area.top()) - scene.valueAt(1, area.bottom()) >= 1e-10);
  // Zero, and zero but for rounding: a micrometre and the axis' margin, no picometres.
  CHECK(scene.valueAt(1, area.top()) == Approx(1.06e-6));
  CHECK(scene.valueAt(1, area.bottom()) == Approx(-1.06e-6));
}

TEST_CASE("chart_scene: a logarithmic axis has equal decades and no place for zero", "[gui]") {
  test::use_qt();
  ChartPage page = lines_page();
  page.panels[0].log = true;
  for (std::size_t i = 0; i < page.x.size(); ++i)
    page.panels[0].curves[0].y[i] = i == 50 ? 0.0 : std::pow(10.0, 0.1 * static_cast<double>(i));
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(page);
  const double decade = scene.heightOf(0, 10.0) - scene.heightOf(0, 100.0);
  CHECK(scene.heightOf(0, 1e4) - scene.heightOf(0, 1e5) == Approx(decade));
  CHECK(scene.linesOf(0) == 2);  // one that leaves at the foot and comes back, and the other
  page.log_x = true;
  scene.setPage(page);
  CHECK(scene.positionOf(1.0) - scene.positionOf(0.1) ==
        Approx(scene.positionOf(10.0) - scene.positionOf(1.0)));
}

TEST_CASE("axis_scale: logarithmic ticks are decades, with 2 and 5 where there is room", "[unit]") {
  const AxisScale wide = log_axis(3e-9, 2.0, "m");
  CHECK(wide.min == Approx(-9.0));
  CHECK(wide.max == Approx(1.0));
  CHECK(wide.value(wide.shown(3e-9)) == Approx(3e-9));
  for (const AxisTick& tick : axis_ticks(wide)) CHECK(tick.at == Approx(std::round(tick.at)));
  const std::vector<AxisTick> narrow = axis_ticks(log_axis(1.0, 80.0, "N"));
  REQUIRE(narrow.size() == 7);
  CHECK(narrow[1].text == "2");
  CHECK(narrow[6].text == "100");
}

TEST_CASE("chart_scene: the view that a page begins with is kept where it is set again", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x = {250.0, 500.0, 750.0, 1000.0};
  page.view_low = 0.0, page.view_high = 800.0;
  page.panels = {{"Amplitude", "N", {{"", {1.0, 2.0, 3.0, 4.0}, {}}}}};
  ChartScene shown, exported;
  shown.setPage(page);
  exported.setPage(page);
  exported.setZoom(shown.zoom());
  CHECK(exported.viewLow() == 0.0);
  CHECK(exported.zoom() == shown.zoom());
}

TEST_CASE("axis_scale: decades of frequency are told in kHz, with 2 and 5 as there is room",
          "[unit]") {
  const AxisScale wide = log_axis(20.0, 56e3, "Hz", true, 26.0);
  CHECK(wide.unit == "kHz");
  std::vector<std::string> texts;
  for (const AxisTick& tick : axis_ticks(wide)) texts.push_back(tick.text);
  CHECK(texts == std::vector<std::string>{"0.02", "0.05", "0.1", "0.2", "0.5", "1", "2", "5", "10",
                                          "20", "50"});
  CHECK(wide.value(wide.shown(1234.0)) == Approx(1234.0));
  // Little room: powers of ten. Below 10 kHz, and where the small end got long: the unit itself.
  CHECK(axis_ticks(log_axis(20.0, 56e3, "Hz", true, 8.0)).size() == 3);
  CHECK(log_axis(2.0, 9e3, "Hz", true).unit == "Hz");
  CHECK(log_axis(1e-4, 2e4, "N", true).unit == "N");
}

TEST_CASE("chart_scene: lines above each other have a bar for their values, and no numbers",
          "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x_title = "Frequency", page.x_unit = "Hz";
  ChartPanel panel{"Spectra", "N", {}};
  panel.one_colour = panel.scale_bar = true;
  for (int k = 0; k < 10; ++k) {
    ChartCurve curve{std::to_string(k) + " ms", {}, {}};
    curve.lift = 3.0 * k;
    for (int i = 0; i < 50; ++i) curve.y.push_back(curve.lift + (i == 10 ? 7.0 : 0.0));
    panel.curves.push_back(std::move(curve));
  }
  for (int i = 0; i < 50; ++i) page.x.push_back(100.0 * i);
  page.panels = {panel};
  ChartScene scene;
  scene.setPageSize({1280, 800});
  scene.setPage(page);
  const QRectF area = scene.plotAreas()[0];
  int beside = 0;
  qreal bar = 0.0;
  for (QGraphicsItem* item : scene.items()) {
    if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item);
        text != nullptr && text->text() == "5 N")
      ++beside;
    else if (text != nullptr && text->rotation() == 0.0 && text->pos().x() < area.left() - 4.0 &&
             text->pos().y() > area.top() && text->pos().y() < area.bottom())
      FAIL_CHECK("a number beside the panel: " << text->text().toStdString());
    if (auto* line = qgraphicsitem_cast<QGraphicsLineItem*>(item);
        line != nullptr && line->line().x1() < area.left() && line->line().dx() == 0.0)
      bar = std::abs(line->line().dy());
  }
  CHECK(beside == 1);
  CHECK(bar == Approx(scene.heightOf(0, 0.0) - scene.heightOf(0, 5.0)));
}

TEST_CASE("chart_scene: the extremes between stored values are a pale area", "[gui]") {
  test::use_qt();
  ChartPage page = lines_page();
  page.panels.pop_back();
  page.panels[0].curves.pop_back();
  ChartCurve& curve = page.panels[0].curves[0];
  for (const double y : curve.y) curve.low.push_back(y - 5.0), curve.high.push_back(y + 50.0);
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(page);
  const QRectF area = scene.plotAreas()[0];
  CHECK(scene.valueAt(0, area.top()) >= 70.0);  // the axis has room for it
  const QImage image = scene.image({900, 600});
  const auto at = [&](double x, double y) {
    return image.pixelColor(static_cast<int>(scene.positionOf(x)),
                            static_cast<int>(scene.heightOf(0, y)));
  };
  CHECK(at(5.03, 35.0) != at(5.03, 68.0));
  CHECK(at(5.03, 35.0).blue() > at(5.03, 35.0).red());
}

TEST_CASE(
    "chart_scene: extremes stand over the interval that has them, and are never too thin to see",
    "[gui][step-band]") {
  test::use_qt();
  ChartPage page = lines_page();
  page.panels.resize(1);
  page.panels[0].curves.resize(1);
  page.panels[0].message.clear();
  ChartCurve& curve = page.panels[0].curves[0];
  for (const int steps : {5, 20'001}) {
    INFO(steps << " steps");
    const int peak = steps / 2;
    page.x.clear(), curve.y.clear();
    for (int i = 0; i < steps; ++i) {
      page.x.push_back(10.0 * i / (steps - 1));
      curve.y.push_back(i % 2 == 0 ? 0.0 : 1.0);
    }
    curve.low = curve.high = curve.y;
    curve.high[static_cast<std::size_t>(peak)] = 20.0;
    ChartScene scene;
    scene.setPageSize({900, 600});
    scene.setPage(page);
    const QImage image = scene.image({900, 600});
    const double before = page.x[static_cast<std::size_t>(peak - 1)],
                 after = page.x[static_cast<std::size_t>(peak + 1)];
    const double at = page.x[static_cast<std::size_t>(peak)];
    const int row = static_cast<int>(scene.heightOf(0, 18.0));
    const auto pale = [&](double x) {
      const QColor colour = image.pixelColor(static_cast<int>(scene.positionOf(x)), row);
      return colour.blue() - colour.red() > 30;
    };
    CHECK(pale(0.5 * (before + at)));
    if (steps < 10) CHECK_FALSE(pale(0.5 * (at + after)));
    int columns = 0;
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, row);
      columns += colour.blue() - colour.red() > 30 ? 1 : 0;
    }
    const double wide = scene.positionOf(at) - scene.positionOf(before);
    CHECK(columns >= 1);
    CHECK(columns <= wide + 2.0);
  }
}

TEST_CASE("chart_scene: extremes end with the view, wherever it cuts their intervals",
          "[gui][step-band]") {
  test::use_qt();
  ChartPage page = lines_page();
  page.panels.resize(1);
  page.panels[0].curves.resize(1);
  ChartCurve& curve = page.panels[0].curves[0];
  page.x = {0.0, 4.0, 8.0};
  curve.y = {1.0, 1.0, 1.0};
  curve.low = {1.0, 0.0, 0.0};
  curve.high = {1.0, 20.0, 20.0};
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(page);
  scene.setView(3.0, 5.0);
  const QRectF area = scene.plotAreas()[0];
  int bands = 0;
  for (const QGraphicsItem* item : scene.items()) {
    const auto* band = qgraphicsitem_cast<const QGraphicsPolygonItem*>(item);
    if (band == nullptr) continue;
    ++bands;
    CHECK(band->polygon().boundingRect().left() == Approx(area.left()));
    CHECK(band->polygon().boundingRect().right() == Approx(area.right()));
  }
  CHECK(bands == 1);
}

TEST_CASE("chart_scene: extremes of 0 and less begin at the lower edge of a logarithmic panel",
          "[gui][step-band]") {
  test::use_qt();
  ChartPage page = lines_page();
  page.panels.resize(1);
  page.panels[0].curves.resize(1);
  page.panels[0].log = true;
  ChartCurve& curve = page.panels[0].curves[0];
  page.x = {0.0, 4.0, 8.0, 9.0};
  curve.y = {1.0, 1.0, 1.0, 1.0};
  curve.low = {1.0, 0.0, -2.0, -3.0};
  curve.high = {1.0, 20.0, 20.0, 5.0};
  ChartScene scene;
  scene.setPageSize({900, 600});
  scene.setPage(page);
  const QRectF area = scene.plotAreas()[0];
  int bands = 0;
  for (const QGraphicsItem* item : scene.items()) {
    const auto* band = qgraphicsitem_cast<const QGraphicsPolygonItem*>(item);
    if (band == nullptr) continue;
    ++bands;
    const QRectF covered = band->polygon().boundingRect();
    CHECK(area.adjusted(-1.0, -1.0, 1.0, 1.0).contains(covered));
    CHECK(covered.bottom() == Approx(area.bottom()));
    CHECK(covered.top() == Approx(scene.heightOf(0, 20.0)));
  }
  CHECK(bands == 1);
}

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
  CHECK(scene.sceneRect().size() == QSizeF(900, 600));  // what is seen stays
  CHECK_THROWS_WITH(save_page(scene, base / "page.gif", {500, 400}), Catch::Contains(".svg"));
  CHECK_THROWS_AS(save_page(scene, base / "no" / "page.svg", {500, 400}), InputError);
}

TEST_CASE("chart_view: ranges and hidden curves are those of their page, after others and a reload",
          "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  ChartPage power = lines_page(), moment = lines_page();
  power.title = "Power", moment.title = "Moment";
  moment.panels.front().unit = "N.m";
  auto& scene = view.chartScene();
  view.showPage(power);
  const double first = scene.viewLow(), last = scene.viewHigh();
  const double quarter = first + 0.25 * (last - first), half = first + 0.5 * (last - first);
  const auto zoom = [&](double low, double high, double bottom, double top) {
    // As a box does.
    const QRectF area = scene.plotAreas().front();
    const auto at = [&](double x, double part) {
      return view.mapFromScene(QPointF(scene.positionOf(x), area.bottom() - part * area.height()));
    };
    QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, at(low, bottom));
    QTest::mouseMove(view.viewport(), at(high, top));
    QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, at(high, top));
  };
  zoom(quarter, half, 0.2, 0.8);
  const ChartZoom box = scene.zoom();
  REQUIRE(box.panels.front().has_value());
  scene.showCurve(0, 0, false);

  view.showPage(moment);  // keeps the abscissa, not the range of another quantity
  CHECK(scene.viewLow() == box.low);
  CHECK_FALSE(scene.zoom().panels.front().has_value());
  CHECK_FALSE(scene.page().panels[0].curves[0].hidden);
  view.showPage(power);
  CHECK(scene.zoom() == box);
  CHECK(scene.page().panels[0].curves[0].hidden);
  view.showPage(power);  // read again
  CHECK(scene.zoom() == box);
  CHECK(scene.page().panels[0].curves[0].hidden);

  view.showPage(moment);
  view.zoomBack();
  CHECK(scene.viewLow() == first);
  CHECK(scene.viewHigh() == last);
  CHECK_FALSE(scene.zoom().panels.front().has_value());
  view.zoomForward();
  CHECK(scene.viewLow() == box.low);
  CHECK_FALSE(scene.zoom().panels.front().has_value());
  view.showPage(power);
  CHECK(scene.zoom() == box);
  view.zoomBack();
  CHECK(scene.viewHigh() == last);
  CHECK_FALSE(scene.zoom().panels.front().has_value());
  view.zoomForward();
  CHECK(scene.zoom() == box);

  ChartPage others = power;  // of other curves
  others.panels[0].curves[0].name = "level";
  view.showPage(others);
  CHECK_FALSE(scene.zoom().panels.front().has_value());
  CHECK_FALSE(scene.page().panels[0].curves[0].hidden);
}

TEST_CASE("chart_view: what a page cannot go back to stays for the page that can", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  auto& scene = view.chartScene();
  view.showPage(lines_page());
  const QPoint middle = view.mapFromScene(scene.plotAreas().front().center());
  QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, middle);
  QTest::mouseMove(view.viewport(), middle + QPoint(80, 40));
  QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, middle + QPoint(80, 40));
  REQUIRE(scene.zoomed());
  ChartPage turns = lines_page();
  turns.title = "Turns", turns.x_unit = "rev";
  view.showPage(turns);
  const ChartZoom seen = scene.zoom();
  view.zoomBack();
  CHECK(scene.zoom() == seen);
  view.showPage(lines_page());
  const ChartZoom before = scene.zoom();
  view.zoomBack();
  CHECK_FALSE(scene.zoom() == before);
}

TEST_CASE("svg_writer: what is drawn inside a clip stays there, and shades are shades", "[gui]") {
  test::use_qt();
  const QByteArray svg = svg_of({200, 100}, [](QPainter& p) {
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

TEST_CASE("gif_writer: pictures come back with their colours and pauses", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("film.gif").toStdString();
  GifWriter writer(path, {96, 64}, 20);
  const QList<QColor> colours{Qt::red, Qt::green, Qt::blue};
  for (const QColor& colour : colours) {
    QImage image(96, 64, QImage::Format_RGB32);
    image.fill(colour);
    for (int x = 0; x < 96; ++x)  // noise, so that the table of codes fills up
      for (int y = 0; y < 32; ++y)
        image.setPixelColor(x, y, QColor::fromHsv((x * 37 + y * 91) % 360, 200, 200));
    writer.add(image);
  }
  CHECK_FALSE(std::filesystem::exists(path));  // only a whole film
  writer.finish();
  QImageReader reader(folder.filePath("film.gif"));
  REQUIRE(reader.canRead());
  for (const QColor& colour : colours) {
    const QImage image = reader.read();
    INFO(reader.errorString().toStdString());
    REQUIRE(image.size() == QSize(96, 64));
    const QColor got = image.pixelColor(50, 50);
    CHECK(std::abs(got.red() - colour.red()) + std::abs(got.green() - colour.green()) +
              std::abs(got.blue() - colour.blue()) <
          12);
    CHECK(reader.nextImageDelay() == 50);
  }
  CHECK(reader.read().isNull());
}

TEST_CASE("gif_writer: shaded metal stays grey beside the colours of a scale", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QImage image(256, 200, QImage::Format_RGB32);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 256; ++x)
      image.setPixelColor(x, y,
                          y < 100 ? QColor(x * 9 / 10, x * 9 / 10 + y / 20, x * 9 / 10 + y / 10)
                                  : QColor::fromHsv(x * 300 / 256, 100 + y / 2, 60 + y / 2));
  GifWriter writer(folder.filePath("film.gif").toStdString(), image.size(), 20);
  writer.add(image);
  writer.finish();
  const QImage got = QImageReader(folder.filePath("film.gif")).read();
  REQUIRE(got.size() == image.size());
  int worst = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 256; ++x) {
      const QColor a = image.pixelColor(x, y), b = got.pixelColor(x, y);
      worst = std::max({worst, std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                        std::abs(a.blue() - b.blue())});
    }
  CHECK(worst < 24);  // a fixed cube of colours, dithered, is up to 51 off
}

TEST_CASE("mp4_writer: without ffmpeg the reason is a sentence", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("film.mp4").toStdString();
  if (!ffmpeg_found()) {
    CHECK_THROWS_WITH(Mp4Writer(path, {64, 64}, 25), Catch::Contains("ffmpeg"));
    return;
  }
  Mp4Writer writer(path, {64, 64}, 25);
  for (int i = 0; i < 10; ++i) writer.add(QImage(64, 64, QImage::Format_RGB32));
  writer.finish();
  CHECK(std::filesystem::file_size(path) > 100);
}

TEST_CASE("recent files: the newest first, each once, those that are gone left out", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QSettings("Adore", "recent-test").clear();
  for (const char* name : {"a", "b", "c"}) {
    QFile file(folder.filePath(name));
    REQUIRE(file.open(QIODevice::WriteOnly));
    remember_file("recent-test", folder.filePath(name));
  }
  remember_file("recent-test", folder.filePath("a"));
  CHECK(recent_files("recent-test") ==
        QStringList{folder.filePath("a"), folder.filePath("c"), folder.filePath("b")});
  QFile::remove(folder.filePath("c"));
  CHECK(recent_files("recent-test").size() == 2);
  // A folder is one entry, however many of its files are opened; none where nothing was.
  remember_as_folder("recent-test", folder.path(), [&] {
    for (const char* name : {"b", "a", "b"}) remember_file("recent-test", folder.filePath(name));
  });
  const QStringList one{folder.path(), folder.filePath("a"), folder.filePath("b")};
  CHECK(recent_files("recent-test") == one);
  remember_as_folder("recent-test", "/", [] {});
  CHECK(recent_files("recent-test") == one);
  QSettings("Adore", "recent-test").clear();
}

TEST_CASE("recent files: the files of one run do not take the places of others", "[gui]") {
  test::use_qt();
  QTemporaryDir folder, other;
  QSettings("Adore", "recent-test").clear();
  const auto open = [](const QString& path) {
    QFile file(path);
    REQUIRE(file.open(QIODevice::WriteOnly));
    remember_part_of_run("recent-test", path);
  };
  open(other.filePath("SOL1"));
  for (int i = 1; i <= 8; ++i) open(folder.filePath(QString("SOL%1").arg(i)));
  CHECK(recent_files("recent-test") == QStringList{folder.filePath("SOL8"), folder.filePath("SOL7"),
                                                   folder.filePath("SOL6"),
                                                   other.filePath("SOL1")});
  QSettings("Adore", "recent-test").clear();
}
