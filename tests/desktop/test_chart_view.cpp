#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/chrome.hpp"
#include "desktop/gif_writer.hpp"
#include "desktop/lines_page.hpp"
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
using adore::testing::lines_page;

namespace {

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

TEST_CASE("chart_view: cursors on stored values → statistics in between", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  view.showPage(lines_page());
  ChartScene& scene = view.chartScene();
  const QRectF area = scene.plotAreas()[0];
  click(view, {scene.sceneXAt(2.0), area.center().y()}, Qt::ControlModifier);
  click(view, {scene.sceneXAt(7.0), area.center().y()}, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(view.cursorAbscissa(0) == Approx(2.0));
  CHECK(view.cursorAbscissa(1) == Approx(7.0));
  const QString report = view.cursorReport();
  INFO(report.toStdString());
  CHECK(report.contains("B − A: 5 s"));
  CHECK(report.contains("rising:  A 4 N  B 14 N  B − A 10 N  min 4 N  max 14 N  mean 9 N"));
  CHECK(report.contains("falling:  A 98 N"));
  view.showPage(lines_page());  // the same abscissa: they stay
  CHECK(view.cursorAbscissa(0) == Approx(2.0));
  ChartPage other = lines_page();
  other.x_unit = "rev";
  view.showPage(other);
  CHECK(std::isnan(view.cursorAbscissa(0)));
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
  click(view, {view.chartScene().sceneXAt(page.x[20]), area.center().y()}, Qt::ControlModifier);
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
    return view.mapFromScene(QPointF(scene.sceneXAt(x), scene.sceneYAt(0, y)));
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
  CHECK(scene.valueAt(0, scene.sceneYAt(0, 50.0)) == Approx(50.0));
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
  CHECK(scene.lineCount(0) == 2);
  click(view, entry(1));
  CHECK(scene.page().panels[0].curves[1].hidden);
  CHECK(scene.lineCount(0) == 1);
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
  const double decade = scene.sceneYAt(0, 10.0) - scene.sceneYAt(0, 100.0);
  CHECK(scene.sceneYAt(0, 1e4) - scene.sceneYAt(0, 1e5) == Approx(decade));
  CHECK(scene.lineCount(0) == 2);  // one that leaves at the foot and comes back, and the other
  page.log_x = true;
  scene.setPage(page);
  CHECK(scene.sceneXAt(1.0) - scene.sceneXAt(0.1) ==
        Approx(scene.sceneXAt(10.0) - scene.sceneXAt(1.0)));
}

TEST_CASE("axis_scale: logarithmic ticks → decades, with 2 and 5 if they fit", "[unit]") {
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

TEST_CASE("axis_scale: decades of frequency → in kHz, with 2 and 5 if they fit", "[unit]") {
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
      return view.mapFromScene(QPointF(scene.sceneXAt(x), area.bottom() - part * area.height()));
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

TEST_CASE("zoom history: entries that do not apply to a page → kept", "[gui]") {
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
