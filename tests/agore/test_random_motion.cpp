#include "agore/agore_window.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QAction>
#include <QDialog>
#include <QMenu>
#include <QTest>
#include <QWheelEvent>
#include <catch2/catch.hpp>

#include <random>

using namespace adore;
using namespace adore::agore;

TEST_CASE("agore_window: a random walk over everything that a hand can do leaves it alive",
          "[gui][slow]") {
  test::use_qt();
  AgoreWindow window;
  test::SyntheticRun run;
  run.steps = 50;
  window.setAnimation(prepare(test::synthetic_sol8(run)));
  window.resize(900, 600);
  window.show();
  std::mt19937 random(15);
  const auto any = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  auto* canvas = window.findChild<PictureWidget*>();
  const QStringList left_out{"Quit", "Print...", "Save Picture...", "Save Film...", "Open..."};
  constexpr int kActions = 3000;
  for (int i = 0; i < kActions; ++i) {
    INFO("action " << i);
    const QPoint place(any(canvas->width()), any(canvas->height()));
    switch (any(6)) {
      case 0: {
        QList<QAction*> actions;
        for (auto* action : window.findChildren<QAction*>())
          if (!action->menu() && !action->isSeparator() &&
              !left_out.contains(action->text().remove('&')))
            actions << action;
        actions[any(static_cast<int>(actions.size()))]->trigger();
        break;
      }
      case 1:
        QTest::mouseClick(canvas, Qt::LeftButton, {}, place);
        break;
      case 2: {
        QWheelEvent wheel(place, canvas->mapToGlobal(QPointF(place)), {},
                          {0, any(2) == 0 ? 240 : -240}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(canvas, &wheel);
        break;
      }
      case 3: {
        QTest::mousePress(canvas, Qt::LeftButton, {}, place);
        const QPoint end(any(canvas->width()), any(canvas->height()));
        QTest::mouseMove(canvas, end);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, end);
        break;
      }
      case 4:
        window.setView(static_cast<View>(any(6)), 1 + any(20));
        break;
      default:
        any(2) == 0 ? window.frameForward() : window.frameBackward();
    }
    if (any(20) == 0) window.playForward();
    QCoreApplication::processEvents();
    for (auto* dialog : window.findChildren<QDialog*>()) dialog->reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    REQUIRE(window.currentFrame() < window.frameCount());
    REQUIRE(window.options().zoom >= 1.0);
    if (i % 50 == 0) REQUIRE_FALSE(window.grab().isNull());
  }
}
