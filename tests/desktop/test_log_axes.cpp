#include "desktop/chart_scene.hpp"
#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsEllipseItem>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <catch2/catch.hpp>

#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>

/// Values that a logarithmic axis cannot show are reported, not drawn as missing.
using namespace adore;
using namespace adore::desktop;
using Catch::Matchers::Contains;

namespace {

std::string words_of(const ChartScene& scene) {
  QString out;
  for (QGraphicsItem* item : scene.items(Qt::AscendingOrder))
    if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item)) out += text->text() + " ";
  return out.replace(QChar(QChar::Nbsp), ' ').toStdString();
}

qsizetype dots_of(const ChartScene& scene) {
  qsizetype out = 0;
  for (QGraphicsItem* item : scene.items())
    out += qgraphicsitem_cast<QGraphicsEllipseItem*>(item) != nullptr ? 1 : 0;
  return out;
}

constexpr std::size_t kValues = 1000;

/// Two panels: of every `of` values of "first" the last `below` are at or below 0, "second" is
/// above 0.
ChartPage page_of(std::size_t of, std::size_t below) {
  ChartPage page;
  page.title = "Loads", page.x_title = "Time", page.x_unit = "s";
  ChartCurve first{"first", {}, {}}, second{"second", {}, {}};
  for (std::size_t i = 0; i < kValues; ++i) {
    page.x.push_back(static_cast<double>(i) * 1e-3);
    const std::size_t place = i % of;
    first.y.push_back(place < of - below ? 10.0 + static_cast<double>(i % 7)
                      : place % 2 == 0   ? 0.0
                                         : -5.0);
    second.y.push_back(3.0);
  }
  page.panels = {{"Force", "N", {first, second}}, {"Moment", "N.m", {second}}};
  return page;
}

void set_log(ChartPage& page) {
  for (ChartPanel& panel : page.panels) panel.log = true;
}

}  // namespace

TEST_CASE("chart_scene: values at or below 0 on a logarithmic axis are counted", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({1280, 800});
  for (const auto& [of, below, told] : {std::tuple{2U, 1U, "50 %"},
                                        {4U, 3U, "75 %"},
                                        {10U, 1U, "10 %"},
                                        {1000U, 2U, "0.2 %"},
                                        {1000U, 999U, "over 99 %"}}) {
    ChartPage page = page_of(of, below);
    page.note = "A note of the page.";
    scene.setPage(page);
    CHECK_THAT(words_of(scene), !Contains("logarithmic"));
    set_log(page);
    scene.setPage(page);
    CHECK_THAT(words_of(scene), Contains("A note of the page. Not shown on the logarithmic axis"));
    CHECK_THAT(words_of(scene), Contains(std::string(told) + " of \"first\" in \"Force\"."));
    scene.showCurve(0, 0, false);
    CHECK_THAT(words_of(scene), !Contains("Not shown on the log"));
    scene.showCurve(0, 0, true);
    CHECK_THAT(words_of(scene), Contains("Not shown on the log"));
  }
  // Values that are not there are none of them.
  ChartPage page = page_of(1000, 1);
  set_log(page);
  page.panels[0].curves[0].y.back() = std::numeric_limits<double>::quiet_NaN();
  scene.setPage(page);
  CHECK_THAT(words_of(scene), !Contains("Not shown on the log"));
}

TEST_CASE("chart_scene: line leaving a logarithmic axis → ends at its lower end, no dots",
          "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({1280, 800});
  ChartPage page = page_of(2, 1);
  set_log(page);
  scene.setPage(page);
  CHECK(dots_of(scene) == 0);
  // 100, 30, below 0, 30, 100: just above the foot the line is seen on both sides of the middle.
  page = ChartPage();
  page.x = {0.0, 1.0, 2.0, 3.0, 4.0};
  page.panels = {{"Force", "N", {{"first", {100.0, 30.0, -5.0, 30.0, 100.0}, {}}}}};
  set_log(page);
  scene.setPage(page);
  const QImage image = scene.image({1280, 800});
  const QColor colour = current_theme().curves[0];
  const auto inked = [&](double from, double to, int above_foot) {
    const int y = static_cast<int>(scene.plotAreas()[0].bottom()) - above_foot;
    int out = 0;
    for (int x = static_cast<int>(scene.sceneXAt(from)); x < scene.sceneXAt(to); ++x) {
      const QColor seen = image.pixelColor(x, y);
      out += std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                         std::abs(seen.blue() - colour.blue()) <
                     90
                 ? 1
                 : 0;
    }
    return out;
  };
  CHECK(inked(1.0, 1.9, 5) > 0);
  CHECK(inked(2.1, 3.0, 5) > 0);
  CHECK(inked(1.9, 2.1, 5) == 0);
  CHECK(inked(0.0, 1.0, 5) == 0);
}

TEST_CASE("chart_scene: single value between missing ones → dot on a logarithmic axis", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({1280, 800});
  ChartPage page = page_of(1000, 0);
  page.panels.resize(1);
  auto& y = page.panels[0].curves[0].y;
  y[500] = y[502] = std::numeric_limits<double>::quiet_NaN();
  set_log(page);
  scene.setPage(page);
  CHECK(dots_of(scene) == 1);
}

TEST_CASE("chart_scene: places that a logarithmic abscissa leaves out are counted", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({1280, 800});
  ChartPage page = page_of(2, 0);
  page.log_x = true;
  scene.setPage(page);
  CHECK_THAT(words_of(scene),
             Contains("The value at 0 s is not drawn: the abscissa is logarithmic."));
  page.log_x = false;
  scene.setPage(page);
  CHECK_THAT(words_of(scene), !Contains("logarithmic"));
  page.log_x = true;
  for (double& x : page.x) x -= 0.2505;
  scene.setPage(page);
  CHECK_THAT(words_of(scene), Contains("251 of 1000 points at or below 0 are not drawn"));
}
