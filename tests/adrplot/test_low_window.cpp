#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "support/low_window.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>
#include <catch2/catch.hpp>

#include <utility>

using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

TEST_CASE("plot_window: pages, readout, cursors and notes do not enlarge a low window",
          "[gui][adrplot]") {
  test::use_qt();
  for (const QSize size : test::kLowWindows) {
    PlotWindow window;
    window.resize(size);
    window.show();
    CHECK(test::grown(window, size).toStdString() == "");
    for (const auto kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
      results::SolFile file = test::synthetic_sol(kind);
      file.note = "it ends in the middle of a step, which is left out";
      window.addFile(std::move(file));
    }
    auto* tree = window.findChild<QTreeWidget*>("pages");
    auto* area = window.findChild<QScrollArea*>("chart");
    REQUIRE(area != nullptr);
    int seen = 0;
    for (int file = 0; file < window.fileCount(); ++file)
      for (int page = 0; page < tree->topLevelItem(file)->childCount(); ++page) {
        tree->setCurrentItem(tree->topLevelItem(file)->child(page));
        INFO(window.windowTitle().toStdString());
        CHECK(test::grown(window, size).toStdString() == "");
        auto& scene = window.view().chartScene();
        if (scene.plotAreas().empty()) continue;
        emit window.view().readoutChanged(scene.readoutParts(scene.plotAreas()[0].center()));
        CHECK(test::grown(window, size).toStdString() == "");
        const auto& x = scene.page().x;
        if (x.empty()) continue;
        window.view().setCursorAbscissa(0, x.front());
        window.view().setCursorAbscissa(1, x.back());
        CHECK_FALSE(window.findChild<QLabel*>("cursors")->text().isEmpty());
        CHECK(test::grown(window, size).toStdString() == "");
        // The chart is as high as it can be read, and all of it is reached by scrolling.
        CHECK(window.view().height() >= 300);
        CHECK(area->verticalScrollBar()->maximum() ==
              window.view().height() - area->viewport()->height());
        CHECK(window.view().width() <= area->viewport()->width());
        // So are the numbers of the cursors.
        const auto* cursors = window.findChild<QLabel*>("cursors");
        CHECK(cursors->height() >= cursors->heightForWidth(cursors->width()));
        window.view().clearCursors();
        ++seen;
      }
    CHECK(seen > 20);
  }
}
