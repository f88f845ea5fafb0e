#include "desktop/chart_view.hpp"
#include "support/qt_app.hpp"

#include <QApplication>
#include <QGraphicsEllipseItem>
#include <QGraphicsTextItem>
#include <QImage>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace adore;
using namespace adore::desktop;

namespace {

/// A cage that slides along its land: four turns a thousandth inside the circle of its clearance.
ChartPage orbit_page(const std::string& across = "Y position / clearance") {
  ChartPage page;
  page.title = "Orbit";
  page.equal_axes = true;
  page.guide_radius = 1.0;
  page.x_title = across;
  page.along_title = "Time", page.along_unit = "s";
  ChartPanel panel{"Z position / clearance", "", {{"mass center", {}, {}}}, false};
  for (int i = 0; i <= 400; ++i) {
    const double a = 2.0 * std::numbers::pi * 0.01 * i;
    panel.curves[0].x.push_back(0.999 * std::sin(a));
    panel.curves[0].y.push_back(0.999 * std::cos(a));
    page.along.push_back(1e-3 * i);
  }
  page.panels = {panel};
  return page;
}

void wheel(ChartView& view, QPointF place, int notches, Qt::KeyboardModifiers keys = {}) {
  const QPoint at = view.mapFromScene(place);
  QWheelEvent event(at, view.viewport()->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                    keys, Qt::NoScrollPhase, false);
  QApplication::sendEvent(view.viewport(), &event);
}

/// Sent directly: a headless platform has no pointer that QTest could move.
void move(ChartView& view, QPoint at, Qt::MouseButtons buttons = Qt::NoButton) {
  QMouseEvent event(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton, buttons,
                    Qt::NoModifier);
  QApplication::sendEvent(view.viewport(), &event);
}

/// Units of both axes to a pixel.
std::pair<double, double> scales(const ChartScene& scene) {
  const QRectF area = scene.plotAreas().front();
  return {(scene.abscissaAt(area.right()) - scene.abscissaAt(area.left())) / area.width(),
          (scene.valueAt(0, area.top()) - scene.valueAt(0, area.bottom())) / area.height()};
}

void check_equal(const ChartScene& scene) {
  const auto [across, up] = scales(scene);
  CHECK(across == Approx(up).epsilon(1e-9));
}

}  // namespace

TEST_CASE("chart_view: an orbit is zoomed, moved and boxed, and its axes stay equal", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  view.showPage(orbit_page());
  ChartScene& scene = view.chartScene();
  const double whole = scales(scene).first;
  CHECK_FALSE(scene.zoomed());
  CHECK(scene.whole());

  // At the position of the wheel nothing moves, also with a key. Pointer positions are whole
  // pixels.
  const QPointF top =
      view.mapToScene(view.mapFromScene(QPointF(scene.sceneXAt(0.1), scene.sceneYAt(0, 0.98))));
  const double across = scene.abscissaAt(top.x()), up = scene.valueAt(0, top.y());
  wheel(view, top, 5);
  wheel(view, top, 5, Qt::ControlModifier);
  CHECK(scales(scene).first == Approx(whole * std::pow(0.8, 10)));
  check_equal(scene);
  CHECK(scene.sceneXAt(across) == Approx(top.x()).margin(0.01));
  CHECK(scene.sceneYAt(0, up) == Approx(top.y()).margin(0.01));
  CHECK(scene.zoomed());

  // A drag takes the picture with it.
  const QPoint from = view.mapFromScene(top), to = from + QPoint(40, 25);
  QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::NoModifier, from);
  move(view, to, Qt::LeftButton);
  QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::NoModifier, to);
  CHECK(scene.sceneXAt(across) == Approx(top.x() + 40.0).margin(0.01));
  CHECK(scene.sceneYAt(0, up) == Approx(top.y() + 25.0).margin(0.01));
  check_equal(scene);

  // Earlier views, and another size of the window.
  const ChartZoom moved = scene.zoom();
  view.zoomBack();
  CHECK(scene.sceneXAt(across) == Approx(top.x()).margin(0.01));
  view.zoomForward();
  CHECK(scene.zoom() == moved);
  view.resize(700, 640);
  check_equal(scene);
  CHECK(scene.zoom() == moved);

  // Another page has its own view; this one's comes back with it.
  view.showPage(orbit_page("X position / clearance"));
  CHECK_FALSE(scene.zoomed());
  view.showPage(orbit_page());
  CHECK(scene.zoom() == moved);
  view.zoomAll();
  CHECK_FALSE(scene.zoomed());
  CHECK(scene.whole());

  // A box of any shape is completely visible; nothing beyond the whole is.
  const QPoint corner = view.mapFromScene(QPointF(scene.sceneXAt(-0.2), scene.sceneYAt(0, 1.05))),
               other = view.mapFromScene(QPointF(scene.sceneXAt(0.2), scene.sceneYAt(0, 0.95)));
  QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, corner);
  QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::ShiftModifier, other);
  check_equal(scene);
  const QRectF area = scene.plotAreas().front();
  CHECK(scene.abscissaAt(area.left()) == Approx(-0.2).margin(0.01));
  CHECK(scene.abscissaAt(area.right()) == Approx(0.2).margin(0.01));
  CHECK(scene.valueAt(0, area.top()) <= 1.0801);
  CHECK(scene.valueAt(0, area.bottom()) < 0.95);
  wheel(view, area.center(), -30);
  CHECK_FALSE(scene.zoomed());
  const double smallest = scales(scene).first;                        // of this size of the window
  wheel(view, {scene.sceneXAt(0.0), scene.sceneYAt(0, 0.999)}, 100);  // to the limit
  CHECK(scales(scene).first == Approx(1e-4 * smallest).epsilon(1e-6));
  check_equal(scene);
}

TEST_CASE("chart_scene: an enlarged orbit has its circle and its directions where they are",
          "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({700, 600});
  ChartPage page = orbit_page();
  // A straight way from one corner to the other, through (0.5, 0.5) ...
  page.panels[0].curves[0].x = {-1.0, 1.0};
  page.panels[0].curves[0].y = {-1.0, 1.0};
  page.along = {0.0, 1.0};
  scene.setPage(page);
  const auto near_point = [&](double x, double y, double half) {
    scene.setZoom({0.0, 1.0, {std::pair(y - half, y + half), std::pair(x - half, x + half)}});
    return scene.image({700, 600});
  };
  const QRectF area = scene.plotAreas().front();
  const auto is_drawn = [&](const QImage& picture, QPointF at, const QColor& colour) {
    for (int dx = -2; dx <= 2; ++dx)
      for (int dy = -2; dy <= 2; ++dy) {
        const QPoint p = at.toPoint() + QPoint(dx, dy);
        if (!picture.rect().contains(p)) continue;
        const QColor seen = picture.pixelColor(p);
        if (std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                std::abs(seen.blue() - colour.blue()) <
            120)
          return true;
      }
    return false;
  };
  const QColor line = current_theme().curves[0], circle = current_theme().curves[1];
  const QImage close = near_point(0.5, 0.5, 1e-3);
  int on = 0;
  for (double part = 0.1; part < 0.95; part += 0.1) {  // from the lower left to the upper right
    const QPointF at(area.left() + part * area.width(), area.bottom() - part * area.height());
    on += is_drawn(close, at, line) ? 1 : 0;
  }
  CHECK(on == 9);
  // ... and the circle at 45 degrees, between two of the points that draw it as a whole.
  const double a = 0.25 * std::numbers::pi + std::numbers::pi / 180.0;
  const QImage round = near_point(std::sin(a), std::cos(a), 1e-3);
  int hits = 0, places = 0;
  for (double b = a - 6e-4; b <= a + 6e-4; b += 1e-5) {  // broken: half of it
    const auto at = scene.planePosition(std::sin(b), std::cos(b));
    REQUIRE(at.has_value());
    ++places;
    hits += is_drawn(round, *at, circle) ? 1 : 0;
  }
  CHECK(hits > places / 3);
}

TEST_CASE("chart_view: an orbit's stored points are read off, and cursors stand on them", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(900, 600);
  view.show();
  ChartPage history;
  history.title = "History";
  history.x_title = "Time", history.x_unit = "s";
  history.x = orbit_page().along;
  history.panels = {{"Radius", "m", {{"", std::vector<double>(history.x.size(), 2.0), {}}}, false}};
  view.showPage(history);
  view.setCursorAbscissa(0, 0.1);  // a quarter of the first turn later: back at the top after 0.1 s
  view.showPage(orbit_page());
  ChartScene& scene = view.chartScene();
  const ChartCurve& curve = scene.page().panels[0].curves[0];
  const QPointF point(scene.sceneXAt(curve.x[30]), scene.sceneYAt(0, curve.y[30]));
  const QString told = scene.readout(point + QPointF(2.0, 1.0));
  INFO(told.toStdString());
  CHECK(told.contains("30 ms"));
  CHECK(told.contains(QString::fromStdString(pretty_quantity(curve.x[30], "", 5))));
  CHECK(told.contains(QString::fromStdString(pretty_quantity(curve.y[30], "", 5))));
  CHECK(scene.readout({scene.sceneXAt(0.0), scene.sceneYAt(0, 0.0)}).startsWith("here:"));
  CHECK(scene.readout({5.0, 5.0}).isEmpty());
  // As many digits as an enlarged picture resolves.
  scene.setZoom({0.0,
                 1.0,
                 {std::pair(curve.y[30] - 1e-4, curve.y[30] + 1e-4),
                  std::pair(curve.x[30] - 1e-4, curve.x[30] + 1e-4)}});
  const QString close =
      scene.readout({scene.sceneXAt(curve.x[30]), scene.sceneYAt(0, curve.y[30])});
  INFO(close.toStdString());
  CHECK(close.contains(QString::fromStdString(pretty_quantity(curve.x[30], "", 8))));
  scene.showAll();

  CHECK(view.cursorAbscissa(0) == Approx(0.1));  // that of the page before
  QTest::mouseClick(view.viewport(), Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier,
                    view.mapFromScene(QPointF(scene.sceneXAt(0.0), scene.sceneYAt(0, -0.9))));
  const QString report = view.cursorReport();
  INFO(report.toStdString());
  CHECK(report.contains("A: 100 ms"));
  CHECK(report.contains("Z position / clearance:  A 0.999  B −0.999  B − A −1.998"));
  CHECK(report.contains("A to B:  1.998"));
}

TEST_CASE("chart_scene: values under the mouse have the digits that their panel resolves",
          "[gui]") {
  test::use_qt();
  ChartScene scene;
  ChartPage page;
  page.title = "Small motion";
  page.x_title = "Time", page.x_unit = "s";
  page.panels = {{"Radius", "m", {{"", {}, {}}}, false}};
  for (int i = 0; i <= 100; ++i) {
    page.x.push_back(0.1 * i);
    page.panels[0].curves[0].y.push_back(0.030005 + 7e-7 * std::sin(0.3 * i));
  }
  page.panels[0].curves[0].y[20] = 0.0300051234;
  scene.setPage(page);
  const auto read = [&] {
    return scene.readout({scene.sceneXAt(2.0), scene.plotAreas()[0].center().y()});
  };
  INFO(read().toStdString());
  CHECK(read().contains("30.0051234 mm"));
  // A curve that fills its axis needs no more than five.
  for (double& y : page.panels[0].curves[0].y) y -= 0.030005;
  scene.setPage(page);
  INFO(read().toStdString());
  CHECK(read().contains("123.4 nm"));
  scene.setPanelView(0, std::pair(1.2339e-7, 1.2341e-7));
  CHECK(scene.digitsOf(0, 0) == 8);
}

TEST_CASE("plane_zoom: start and end of an orbit are of two shapes, in the picture and in its key",
          "[gui][desktop]") {
  test::use_qt();
  ChartPage page = orbit_page();
  page.panels[0].curves[0].x.back() += 0.5;  // ends elsewhere
  ChartScene scene;
  scene.setPage(page);
  const Theme& theme = current_theme();
  int starts = 0, ends = 0;
  QString key;
  for (const QGraphicsItem* item : scene.items()) {
    if (const auto* round = dynamic_cast<const QGraphicsEllipseItem*>(item))
      starts += round->brush().color() == theme.green ? 1 : 0;
    if (const auto* square = dynamic_cast<const QGraphicsRectItem*>(item))
      ends += square->brush().color() == theme.red ? 1 : 0;
    if (const auto* text = dynamic_cast<const QGraphicsTextItem*>(item)) key += text->toPlainText();
  }
  CHECK(starts == 1);
  CHECK(ends == 1);
  CHECK(key.contains(QString::fromUtf8("● start")));
  CHECK(key.contains(QString::fromUtf8("■ end")));
}

TEST_CASE("chart_view: what is read below the pointer is of the view that is there now",
          "[gui][desktop]") {
  test::use_qt();
  ChartPage lines;
  lines.title = "Lines";
  lines.x_title = "Time", lines.x_unit = "s";
  ChartPanel panel{"Load", "N", {{"load", {}, {}}}};
  for (int i = 0; i <= 1000; ++i) {
    lines.x.push_back(0.01 * i);
    panel.curves[0].y.push_back(0.3 * i);
  }
  lines.panels = {panel};
  for (const ChartPage& page : {lines, orbit_page()}) {
    ChartView view;
    view.resize(900, 600);
    view.show();
    view.showPage(page);
    ChartScene& scene = view.chartScene();
    QStringList told;
    QObject::connect(&view, &ChartView::readoutChanged,
                     [&](const QStringList& parts) { told = parts; });
    const QRectF area = scene.plotAreas()[0];
    const QPoint at = view.mapFromScene(area.center() + QPointF(0.31, 0.12) * area.height());
    move(view, at);
    const auto now = [&] { return scene.readoutParts(view.mapToScene(at)); };
    CHECK(told == now());
    const QStringList whole = told;
    wheel(view, view.mapToScene(at), 3);
    wheel(view, area.center(), 2);
    CHECK(told != whole);
    CHECK(told == scene.readoutParts(view.mapToScene(at)));
    view.zoomAll();
    CHECK(told == now());
    view.zoomBack();
    CHECK(told == now());
    view.zoomForward();
    CHECK(told == now());
    view.resize(700, 450);
    CHECK(told == now());
    view.showPage(page);
    view.zoomAll();
  }
}

TEST_CASE("chart_view: curve ending between the cursors → range of the mean given",
          "[gui][desktop]") {
  test::use_qt();
  ChartPage page;
  page.title = "Lines";
  page.x_title = "Time", page.x_unit = "s";
  ChartPanel panel{"Load", "N", {{"long", {}, {}}, {"short", {}, {}}}};
  for (int i = 0; i <= 100; ++i) {
    page.x.push_back(i);
    panel.curves[0].y.push_back(2.0);
    panel.curves[1].y.push_back(i <= 60 ? 3.0 : std::numeric_limits<double>::quiet_NaN());
  }
  page.panels = {panel};
  ChartView view;
  view.showPage(page);
  view.setCursorAbscissa(0, 80.0);
  view.setCursorAbscissa(1, 20.0);
  const QStringList lines = view.cursorReport().split('\n');
  INFO(view.cursorReport().toStdString());
  REQUIRE(lines.size() == 3);
  CHECK_FALSE(lines[1].contains("(20 s to"));
  CHECK(lines[2].contains("mean 3 N  RMS 3 N (20 s to 60 s)"));
}
