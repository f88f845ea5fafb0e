#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "support/chart_texts.hpp"
#include "support/low_window.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTreeWidget>
#include <catch2/catch.hpp>

#include <cmath>

/// Pages of all types of files in windows of many sizes: their texts are read.
using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

constexpr qreal kLeastPanel = 44.0;
constexpr int kLeastChart = 100;  // of the place in which a chart scrolls

QRect place_in(const QWidget& window, const QWidget& widget) {
  return {widget.mapTo(&window, QPoint()), widget.size()};
}

enum class State { Nothing, Pointed, Cursors };

void check(PlotWindow& window, QSize size, State state) {
  CHECK(test::grown(window, size).toStdString() == "");
  const auto& scene = window.view().chartScene();
  CHECK(test::unreadable(scene, kLeastPanel).join("; ").toStdString() == "");
  const auto* area = window.findChild<QScrollArea*>("chart");
  const auto* readout = window.findChild<QLabel*>("readout");
  const QRect chart = place_in(window, *area);
  CHECK(window.rect().contains(chart));
  CHECK(chart.height() >= kLeastChart);
  CHECK(area->verticalScrollBar()->maximum() ==
        window.view().height() - area->viewport()->height());
  // Without values the foot has a line, or leaves the chart whole.
  if (state == State::Nothing) {
    CHECK(readout->isHidden());
    const bool line = window.statusBar()->height() < 2 * readout->fontMetrics().lineSpacing();
    CHECK((line || area->verticalScrollBar()->maximum() == 0));
  }
  if (state == State::Pointed && !readout->text().isEmpty()) {
    CHECK(readout->isVisible());
    CHECK(window.rect().contains(place_in(window, *readout)));
  }
  if (state == State::Cursors) {
    const auto* cursors = window.findChild<QLabel*>("cursors");
    const auto* numbers = qobject_cast<const QWidget*>(cursors->parent()->parent());
    CHECK(window.rect().contains(place_in(window, *numbers)));
    CHECK_FALSE(place_in(window, *numbers).intersects(chart));
    CHECK(cursors->height() >= cursors->heightForWidth(cursors->width()));
  }
}

}  // namespace

TEST_CASE("plot_window: panels, numbers and titles are read at any size, pointed at or measured",
          "[gui][adrplot]") {
  test::use_qt();
  int seen = 0;
  for (const QSize size : {QSize(640, 400), QSize(700, 450), QSize(800, 600), QSize(1280, 800)}) {
    PlotWindow window;
    window.resize(size);
    window.show();
    for (const auto kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power})
      window.addFile(test::synthetic_sol(kind));
    auto* tree = window.findChild<QTreeWidget*>("pages");
    for (int file = 0; file < window.fileCount(); ++file)
      for (int page = 0; page < tree->topLevelItem(file)->childCount(); ++page) {
        tree->setCurrentItem(tree->topLevelItem(file)->child(page));
        INFO(size.width() << " x " << size.height() << ", " << window.windowTitle().toStdString());
        check(window, size, State::Nothing);
        const auto& scene = window.view().chartScene();
        if (scene.plotAreas().empty()) continue;
        emit window.view().readoutChanged(scene.readoutParts(scene.plotAreas()[0].center()));
        check(window, size, State::Pointed);
        emit window.view().readoutChanged({});
        const auto& x = scene.page().x;
        if (x.empty()) continue;
        window.view().setCursorAbscissa(0, x.front());
        window.view().setCursorAbscissa(1, x.back());
        check(window, size, State::Cursors);
        window.view().clearCursors();
        ++seen;
      }
  }
  CHECK(seen > 80);
}

TEST_CASE("plot_window: values over a low chart leave when the pointer does", "[gui][adrplot]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Power));
  window.resize(700, 450);
  window.show();
  QCoreApplication::processEvents();
  const auto* readout = window.findChild<QLabel*>("readout");
  const auto* area = window.findChild<QScrollArea*>("chart");
  const int before = area->height();
  emit window.view().readoutChanged({"2.5 rev: X 1 N", "   Y 2 N"});
  CHECK(readout->isVisible());
  QCoreApplication::processEvents();
  CHECK(area->height() == before);  // nothing moves under the pointer
  window.statusBar()->showMessage("Saved.");
  CHECK(readout->isHidden());
  window.statusBar()->clearMessage();
  CHECK(readout->isVisible());
  emit window.view().readoutChanged({});
  CHECK(readout->isHidden());
}
