#include "desktop/chart_scene.hpp"
#include "desktop/lines_page.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsPolygonItem>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::desktop;
using adore::testing::lines_page;

TEST_CASE("chart_scene: extremes between stored values → min-max band", "[gui]") {
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
  CHECK(scene.valueAt(0, area.top()) >= 70.0);  // the axis has space for it
  const QImage image = scene.image({900, 600});
  const auto at = [&](double x, double y) {
    return image.pixelColor(static_cast<int>(scene.sceneXAt(x)),
                            static_cast<int>(scene.sceneYAt(0, y)));
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
    const int row = static_cast<int>(scene.sceneYAt(0, 18.0));
    const auto pale = [&](double x) {
      const QColor colour = image.pixelColor(static_cast<int>(scene.sceneXAt(x)), row);
      return colour.blue() - colour.red() > 30;
    };
    CHECK(pale(0.5 * (before + at)));
    if (steps < 10) CHECK_FALSE(pale(0.5 * (at + after)));
    int columns = 0;
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, row);
      columns += colour.blue() - colour.red() > 30 ? 1 : 0;
    }
    const double wide = scene.sceneXAt(at) - scene.sceneXAt(before);
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
    CHECK(covered.top() == Approx(scene.sceneYAt(0, 20.0)));
  }
  CHECK(bands == 1);
}

namespace {

constexpr const char* kSaid = "Min–max bands reach beyond.";

bool note_on_pale_bands(const ChartScene& scene) {
  QString out;
  for (const QGraphicsItem* item : scene.items())
    if (const auto* text = qgraphicsitem_cast<const QGraphicsSimpleTextItem*>(item))
      out += text->text() + " ";
  return out.contains("Min–max");
}

/// Pixels inside a panel that hold the paler color of an area, and no line's.
int pale_pixels(ChartScene& scene, const ChartPage& page, QSize size) {
  ChartPage bare = page;
  for (ChartPanel& panel : bare.panels)
    for (ChartCurve& curve : panel.curves) curve.low = curve.high = {};
  ChartScene other;
  other.setTheme(theme(ThemeKind::Light));
  other.setPageSize(size);
  bare.note += note_on_pale_bands(scene) ? kSaid : "";
  bare.band_note.clear();
  other.setPage(bare);
  // The same axes: what differs is the area alone.
  ChartZoom zoom = other.zoom();
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    const QRectF area = scene.plotAreas()[p];
    zoom.panels.at(p) = std::pair(scene.valueAt(p, area.bottom()), scene.valueAt(p, area.top()));
  }
  scene.setZoom(zoom);
  other.setZoom(zoom);
  const QImage with = scene.image(size);
  const QImage without = other.image(size);
  int out = 0;
  for (const QRectF& area : scene.plotAreas())
    for (int y = static_cast<int>(area.top()) + 2; y < area.bottom() - 2; ++y)
      for (int x = static_cast<int>(area.left()) + 2; x < area.right() - 2; ++x) {
        const QColor a = with.pixelColor(x, y), b = without.pixelColor(x, y);
        const int away = std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                         std::abs(a.blue() - b.blue());
        out += away > 60 ? 1 : 0;
      }
  return out;
}

}  // namespace

TEST_CASE("chart_scene: visible min-max band → explained in every picture size",
          "[gui][step-band]") {
  test::use_qt();
  // One interval of a curve, or all, with extremes so many pixels beyond it.
  for (const QSize size : {QSize(700, 450), QSize(1280, 800)})
    for (const std::size_t panels : {1U, 3U})
      for (const double slope : {0.0, 4.0})
        for (const double pixels : {0.0, 0.4, 2.5, 6.0}) {
          ChartPage page;
          page.title = "Bands", page.x_title = "Time", page.x_unit = "s";
          ChartCurve curve{"", {}, {}};
          for (int i = 0; i < 200; ++i) {
            page.x.push_back(0.01 * i);
            curve.y.push_back(slope * std::sin(0.1 * i) + (i == 0 ? 100.0 : i == 1 ? -100.0 : 0.0));
          }
          for (std::size_t p = 0; p < panels; ++p) page.panels.push_back({"Force", "N", {curve}});
          ChartScene scene;
          scene.setTheme(theme(ThemeKind::Light));
          scene.setPageSize(size);
          scene.setPage(page);
          const QRectF area = scene.plotAreas()[0];
          const double pixel =
              (scene.valueAt(0, area.top()) - scene.valueAt(0, area.bottom())) / area.height();
          ChartCurve& last = page.panels.back().curves[0];
          last.low = last.high = last.y;
          // The stroke that sets the axis has no band: its area would be next to the long stroke.
          last.low[1] = last.high[1] = last.low[2] = last.high[2] = std::nan("");
          last.high[120] = std::max(last.y[119], last.y[120]) + (0.8 + pixels) * pixel;
          page.band_note = kSaid;
          scene.setPage(page);
          const bool said = note_on_pale_bands(scene);
          const int pale = pale_pixels(scene, page, size);
          INFO(size.width() << " wide, " << panels << " panels, slope " << slope << ", " << pixels
                            << " px: " << pale << " pale pixels");
          if (pixels > 1.0) CHECK(said);
          if (pixels == 0.0 && slope == 0.0) CHECK_FALSE(said);
          constexpr int kFew = 20;  // half covered ones next to a line
          if (pale == 0) CHECK_FALSE(said);
          if (pale > kFew) CHECK(said);
        }
}

TEST_CASE("chart_scene: min-max bands below all curves", "[gui][step-band]") {
  test::use_qt();
  // The area of a later curve stands across an earlier curve, which keeps its color there.
  for (const bool log : {false, true}) {
    ChartPage page;
    page.title = "Bands", page.x_title = "Time", page.x_unit = "s";
    ChartCurve flat{"flat", {}, {}}, wide{"wide", {}, {}};
    for (int i = 0; i <= 10; ++i) {
      page.x.push_back(0.1 * i);
      flat.y.push_back(10.0);
      wide.y.push_back(1000.0);
      wide.low.push_back(1.0);
      wide.high.push_back(2000.0);
    }
    page.panels = {{"Force", "N", {flat, wide}}};
    page.panels[0].log = log;
    const QSize size(900, 600);
    ChartScene scene;
    scene.setTheme(theme(ThemeKind::Light));
    scene.setPageSize(size);
    const auto colours = [&] {
      scene.setPage(page);
      const QImage image = scene.image(size);
      std::vector<QRgb> out;
      const int y = static_cast<int>(scene.sceneYAt(0, 10.0));
      for (int x = 0; x < image.width(); ++x) {
        QRgb darkest = image.pixel(x, y);
        for (const int row : {y - 1, y + 1})
          if (qGray(image.pixel(x, row)) < qGray(darkest)) darkest = image.pixel(x, row);
        out.push_back(darkest);
      }
      return out;
    };
    const std::vector<QRgb> over = colours();
    const QColor own = theme(ThemeKind::Light).curves[0];
    const QRectF area = scene.plotAreas()[0];
    INFO((log ? "logarithmic" : "linear"));
    // Next to it the area is visible.
    const QImage image = scene.image(size);
    const QColor beside = image.pixelColor(static_cast<int>(area.center().x()),
                                           static_cast<int>(scene.sceneYAt(0, 100.0)));
    CHECK(beside != theme(ThemeKind::Light).surface);
    int kept = 0, all = 0;
    for (int x = static_cast<int>(area.left()) + 3; x < area.right() - 3; ++x) {
      const QColor seen(over[static_cast<std::size_t>(x)]);
      ++all;
      kept += std::abs(seen.red() - own.red()) + std::abs(seen.green() - own.green()) +
                          std::abs(seen.blue() - own.blue()) <
                      40
                  ? 1
                  : 0;
    }
    CHECK(kept == all);
  }
}
