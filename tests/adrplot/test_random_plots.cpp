#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"
#include "support/walk.hpp"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QMenu>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>
#include <catch2/catch.hpp>

#include <random>

using namespace adore;
using namespace adore::adrplot;

namespace {

/// Actions on the window, by number.
void act(PlotWindow& window, std::mt19937& random) {
  const auto any = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  auto& view = window.view();
  const QPoint place(any(view.viewport()->width()), any(view.viewport()->height()));
  const Qt::KeyboardModifiers keys[] = {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier,
                                        Qt::ShiftModifier | Qt::ControlModifier};
  switch (any(17)) {
    case 0:
    case 1:
      window.showPage(1 + any(std::max(1, window.pageCount())));
      break;
    case 2:
      QTest::mouseClick(view.viewport(), Qt::LeftButton, keys[any(4)], place);
      break;
    case 3: {
      const auto key = keys[any(2)];
      QTest::mousePress(view.viewport(), Qt::LeftButton, key, place);
      const QPoint end(any(view.viewport()->width()), any(view.viewport()->height()));
      QTest::mouseMove(view.viewport(), end);
      QTest::mouseRelease(view.viewport(), Qt::LeftButton, key, end);
      break;
    }
    case 4:
    case 5: {
      QWheelEvent wheel(place, view.viewport()->mapToGlobal(QPointF(place)), {},
                        {0, any(2) == 0 ? 240 : -240}, Qt::NoButton, keys[any(2) * 2],
                        Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(view.viewport(), &wheel);
      break;
    }
    case 6:
      QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, place);
      break;
    case 7:
      any(2) == 0 ? view.zoomBack() : view.zoomForward();
      break;
    case 8:
      window.setDomain(static_cast<Domain>(any(3)));
      break;
    case 9:
      window.setLogAxes(any(2) == 0, any(2) == 0);
      break;
    case 10:
      window.findChild<QComboBox*>("abscissa")->setCurrentIndex(any(3));
      break;
    case 11:
      window.findChild<QComboBox*>("orbit")->setCurrentIndex(any(3));
      break;
    case 12:
      any(2) == 0 ? window.nextPage() : window.previousPage();
      break;
    case 13:
      if (any(8) == 0 && window.fileCount() > 1) window.closeFile();
      if (any(8) == 0 && window.fileCount() < 5) {
        test::SyntheticRun run;
        run.steps = 1 + any(200);
        window.addFile(test::synthetic_sol(static_cast<results::SolKind>(any(4)), run));
      }
      break;
    case 14: {
      QList<QAction*> actions;
      const QStringList left_out{"Quit", "Print..."};
      for (auto* action : window.findChildren<QAction*>())
        if (!action->menu() && !action->isSeparator() && action->isEnabled() &&
            !left_out.contains(action->text().remove('&')))
          actions << action;
      actions[any(static_cast<int>(actions.size()))]->trigger();
      break;
    }
    case 15:
      window.resize(500 + any(900), 380 + any(500));
      break;
    case 16: {
      auto* tree = window.findChild<QTreeWidget*>("pages")->viewport();
      const QPoint in_tree(any(tree->width()), any(tree->height()));
      any(2) == 0 ? QTest::mouseClick(tree, Qt::LeftButton, {}, in_tree)
                  : QTest::mouseDClick(tree, Qt::LeftButton, {}, in_tree);
      break;
    }
    default:
      break;
  }
  if (window.fileCount() == 0) window.addFile(test::synthetic_sol(results::SolKind::Cage));
  for (auto* dialog : window.findChildren<QDialog*>()) dialog->reject();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

}  // namespace

TEST_CASE("plot_window: random user actions → no crash", "[gui][slow]") {
  test::use_qt();
  PlotWindow window;
  window.resize(900, 600);
  window.show();
  window.addFile(test::synthetic_sol(results::SolKind::Cage));
  std::mt19937 random = test::walk_random();
  const int actions_to_do = test::walk_actions();
  for (int i = 0; i < actions_to_do; ++i) {
    INFO("action " << i);
    act(window, random);
    auto& scene = window.view().chartScene();
    REQUIRE(window.currentPage() >= 1);
    REQUIRE(window.currentPage() <= window.pageCount());
    REQUIRE(scene.viewLow() <= scene.viewHigh());
    if (i % 50 == 0) REQUIRE_FALSE(window.grab().isNull());
  }
}

TEST_CASE("plot_window: a click on a file's name in the tree shows its first page", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.resize(1000, 700);
  window.show();
  window.addFile(test::synthetic_sol(results::SolKind::Cage));
  window.addFile(test::synthetic_sol(results::SolKind::Power));
  window.showPage(2);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  for (const int file : {0, 1, 0}) {
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                      tree->visualItemRect(tree->topLevelItem(file)).center());
    CHECK(window.currentPage() == 1);
    CHECK(window.windowTitle().contains("page 1 of"));
    CHECK(window.pageCount() == tree->topLevelItem(file)->childCount());
  }
  QTest::keyClick(tree, Qt::Key_Down);  // keyboard navigation starts at the root
  CHECK(window.currentPage() == 1);
}
