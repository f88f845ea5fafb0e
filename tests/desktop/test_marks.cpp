#include "desktop/chart_scene.hpp"
#include "desktop/text_faults.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsLineItem>
#include <QGraphicsSimpleTextItem>
#include <QPen>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

/// Names of frequencies above a chart, and the leaders from them to their lines.
using namespace adore;
using namespace adore::desktop;

namespace {

ChartPage page_with(std::vector<ChartMark> marks, bool log) {
  ChartPage page;
  page.x_title = "Frequency", page.x_unit = "Hz";
  for (int i = 0; i <= 1000; ++i) page.x.push_back(10.0 + 10.0 * i);
  page.log_x = log;
  for (const char* const title : {"X", "Y", "Z"})
    page.panels.push_back({title, "N", {{"", page.x, {}}}});
  page.marks = std::move(marks);
  return page;
}

/// Solid lines above the first panel.
std::vector<QLineF> leaders(const ChartScene& scene) {
  const QRectF area = scene.plotAreas().front();
  std::vector<QLineF> out;
  for (QGraphicsItem* item : scene.items())
    if (auto* line = qgraphicsitem_cast<QGraphicsLineItem*>(item);
        line != nullptr && line->parentItem() == nullptr && line->pen().style() == Qt::SolidLine &&
        std::max(line->line().y1(), line->line().y2()) <= area.top())
      out.push_back(line->line());
  return out;
}

bool overlap(double a1, double a2, double b1, double b2) {
  return std::max(std::min(a1, a2), std::min(b1, b2)) + 0.1 <
         std::min(std::max(a1, a2), std::max(b1, b2));
}

}  // namespace

TEST_CASE("chart_scene: leaders of marks neither merge nor cross, nor go through a name",
          "[gui][desktop]") {
  test::use_qt();
  std::mt19937 random(5);
  const std::vector<std::string> kinds{"FTF", "BSF", "BPFO", "BPFI", "whirl", "shaft"};
  int steps = 0;
  for (int round = 0; round < 60; ++round) {
    const bool log = round % 2 == 0;
    const int count = 2 + round % 15;
    std::vector<ChartMark> marks;
    for (int i = 0; i < count; ++i) {
      const double part = std::uniform_real_distribution<double>(0.0, 1.0)(random);
      marks.push_back({10.0 * std::pow(round % 3 == 0 ? 30.0 : 900.0, part),
                       (i > 5 ? std::to_string(i / 6 + 1) + " " : "") +
                           kinds[static_cast<std::size_t>(i) % kinds.size()]});
    }
    ChartScene scene;
    for (const QSizeF size : {QSizeF(700, 450), QSizeF(1280, 800)}) {
      scene.setPageSize(size);
      scene.setPage(page_with(marks, log));
      std::string told;
      std::vector<QRectF> names;
      const QRectF area = scene.plotAreas().front();
      for (QGraphicsItem* item : scene.items())
        if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item);
            text != nullptr && !text->toolTip().isEmpty()) {
          told += text->text().toStdString() + " | ";
          names.push_back(text->sceneBoundingRect().adjusted(1.0, 3.0, -1.0, -3.0));
        }
      INFO(size.width() << (log ? ", log, " : ", ") << count << " marks: " << told);
      for (const ChartMark& mark : marks) CHECK(told.find(mark.label) != std::string::npos);
      CHECK(told.find("more") == std::string::npos);
      CHECK(text_faults(scene) == std::vector<std::string>());
      const auto near_mark = [&](double x) {
        return std::any_of(marks.begin(), marks.end(), [&](const ChartMark& mark) {
          return std::abs(scene.sceneXAt(mark.x) - x) < 0.01;
        });
      };
      const std::vector<QLineF> lines = leaders(scene);
      int merged = 0, crossed = 0, through = 0;
      for (const QLineF& a : lines) {
        const bool upright = a.x1() == a.x2();
        steps += upright ? 0 : 1;
        const QRectF box = QRectF(a.p1(), a.p2()).normalized();
        for (const QRectF& name : names)
          through += box.right() > name.left() && box.left() < name.right() &&
                             box.bottom() > name.top() && box.top() < name.bottom()
                         ? 1
                         : 0;
        for (const QLineF& b : lines) {
          if (&a == &b || upright != (b.x1() == b.x2())) {
            if (upright && b.y1() == b.y2())  // inside both
              crossed += a.x1() > std::min(b.x1(), b.x2()) + 0.1 &&
                                 a.x1() < std::max(b.x1(), b.x2()) - 0.1 &&
                                 b.y1() > std::min(a.y1(), a.y2()) + 0.1 &&
                                 b.y1() < std::max(a.y1(), a.y2()) - 0.1
                             ? 1
                             : 0;
            continue;
          }
          if (upright && overlap(a.y1(), a.y2(), b.y1(), b.y2()) && a.x1() != b.x1() &&
              std::abs(a.x1() - b.x1()) < 2.0)
            merged += near_mark(a.x1()) && near_mark(b.x1()) ? 0 : 1;  // lines of one name
          if (!upright && overlap(a.x1(), a.x2(), b.x1(), b.x2()) && a.y1() != b.y1())
            merged += std::abs(a.y1() - b.y1()) < 1.3 ? 1 : 0;
        }
      }
      CHECK(merged == 0);
      CHECK(crossed == 0);
      CHECK(through == 0);
      for (const QRectF& panel : scene.plotAreas()) CHECK(panel.height() > 40.0);
      CHECK(area.height() > 40.0);
    }
  }
  CHECK(steps > 50);
}

TEST_CASE("chart_scene: marks have their names also where the first panel has no values",
          "[gui][desktop]") {
  test::use_qt();
  for (const bool all : {false, true}) {
    ChartPage page = page_with({{1000.0, "FTF"}, {4000.0, "BPFO"}}, false);
    for (ChartPanel& panel : page.panels) {
      if (!all && &panel != &page.panels.front()) continue;
      panel.message = "No vibration: " + panel.title;
      panel.curves.front().y.assign(page.x.size(), std::numeric_limits<double>::quiet_NaN());
    }
    ChartScene scene;
    scene.setPage(page);
    int names = 0, lines = 0;
    for (QGraphicsItem* item : scene.items()) {
      if (const auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item))
        names += text->text() == "FTF" || text->text() == "BPFO" ? 1 : 0;
      if (const auto* line = qgraphicsitem_cast<QGraphicsLineItem*>(item))
        lines += line->pen().style() == Qt::DashLine ? 1 : 0;
    }
    INFO("all panels without values " << all);
    CHECK(names == (all ? 0 : 2));
    CHECK(lines == (all ? 0 : 4));  // of the two panels that are drawn
  }
}
