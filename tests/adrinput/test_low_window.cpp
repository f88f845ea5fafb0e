#include "adrinput/deck_window.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/solution_charts.hpp"
#include "desktop/chart_view.hpp"
#include "support/low_window.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>

/// Low and narrow windows of AdrInput with everything that they tell more.
using namespace adore;
using namespace adore::adrinput;

namespace {

void solve(DeckWindow& window) {
  window.runQuasiStatic();
  REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
  REQUIRE(window.staticsPanel().tables() != nullptr);
}

}  // namespace

TEST_CASE("adrinput: docks, solution, panels and search do not enlarge a low window",
          "[gui][adrinput]") {
  test::use_qt();
  // List, form and dock side by side need 700 pixels, except on narrower screens.
  for (const QSize size : {QSize(700, 450), QSize(700, 402)}) {
    DeckWindow window;
    window.resize(size);
    window.show();
    CHECK(test::grown(window, size).toStdString() == "");
    for (const char* deck : {"ball", "tapered"}) {
      INFO(deck);
      window.newDeck(deck);
      CHECK(test::grown(window, size).toStdString() == "");
      solve(window);
      CHECK(test::grown(window, size).toStdString() == "");
      for (const char* name : {"drawing-dock", "solution-dock", "lubricant-dock"}) {
        auto* dock = window.findChild<QDockWidget*>(name);
        REQUIRE(dock != nullptr);
        if (dock->isHidden()) dock->toggleViewAction()->trigger();  // as its key does
        dock->show();
        dock->raise();
        INFO(name);
        CHECK(test::grown(window, size).toStdString() == "");
      }
      for (int page = 0; page < window.solutionCharts().pages().size(); ++page) {
        window.solutionCharts().choosePage(page);
        CHECK(test::grown(window, size).toStdString() == "");
      }
      auto* tabs = window.findChild<QTabWidget*>("panels");
      for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        INFO(tabs->tabText(tab).toStdString());
        CHECK(test::grown(window, size).toStdString() == "");
      }
      for (const std::string& record : window.document().pages()) {
        window.showRecord(record);
        INFO("record " << record);
        CHECK(test::grown(window, size).toStdString() == "");
      }
      auto* search = window.findChild<QLineEdit*>("search");
      search->setText("clearance");
      CHECK(test::grown(window, size).toStdString() == "");
      search->clear();
    }
  }
}

TEST_CASE("adrinput: a chart of the solution is whole in its dock, or scrolls to its edges",
          "[gui][adrinput]") {
  test::use_qt();
  for (const auto& [size, whole] : {std::pair{QSize(700, 450), false},
                                    {QSize(944, 492), true},  // 1920x1080 at a scale factor of 2
                                    {QSize(1264, 770), true}}) {
    DeckWindow window;
    window.resize(size);
    window.show();
    QCoreApplication::processEvents();
    if (size.width() < 1000)  // as wide as the drawing is where the window opens on such a screen
      window.resizeDocks({window.findChild<QDockWidget*>("drawing-dock")}, {200}, Qt::Horizontal);
    QCoreApplication::processEvents();
    window.newDeck("ball");
    solve(window);
    INFO(size.width());
    CHECK(test::grown(window, size).toStdString() == "");
    auto& view = window.solutionCharts().view();
    const auto* area = window.solutionCharts().findChild<QScrollArea*>();
    REQUIRE(view.isVisible());
    for (int page = 0; page < window.solutionCharts().pages().size(); ++page) {
      window.solutionCharts().choosePage(page);
      QCoreApplication::processEvents();
      INFO(window.solutionCharts().pages()[page].toStdString());
      CHECK(area->horizontalScrollBar()->maximum() ==
            std::max(0, view.width() - area->viewport()->width()));
      CHECK((view.width() <= area->viewport()->width()) == whole);
    }
  }
}
