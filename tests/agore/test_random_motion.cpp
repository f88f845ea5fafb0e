#include "agore/agore_window.hpp"
#include "core/results/synthetic.hpp"
#include "results/results_h5.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"
#include "support/walk.hpp"

#include <QAction>
#include <QDialog>
#include <QMenu>
#include <QTest>
#include <QWheelEvent>
#include <catch2/catch.hpp>

#include <random>

using namespace adore;
using namespace adore::agore;

namespace {

/// Content that can be shown: a SOL8 of some balls, or RESULTS.h5 with sections and the 3D view.
Animation any_animation(const std::filesystem::path& folder, int number) {
  using namespace adore::testing;
  if (number % 3 == 0) {
    test::SyntheticRun run;
    run.steps = 2 + number % 60;
    run.balls = 3 + number % 20;
    return prepare(test::synthetic_sol8(run));
  }
  const int balls = 3 + number % 12;
  const bool with_cage = number % 4 != 1;
  const auto path = folder / "RESULTS.h5";
  std::filesystem::remove(path);
  const bearing::Bearing bearing = make_bearing(balls, with_cage);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(path, bearing, channel_table());
  for (long step = 0; step <= number % 40; ++step)
    h5.write(recorder.record(make_snapshot(bearing, step)));
  h5.close();
  return open_motion(path);
}

}  // namespace

TEST_CASE("agore_window: random user actions → no crash", "[gui][slow]") {
  test::use_qt();
  AgoreWindow window;
  test::SyntheticRun run;
  run.steps = 50;
  window.setAnimation(prepare(test::synthetic_sol8(run)));
  window.resize(900, 600);
  window.show();
  const testing::TemporaryFolder folder;
  std::mt19937 random = test::walk_random();
  const auto any = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  auto* canvas = window.findChild<PictureWidget*>();
  const QStringList left_out{"Quit", "Print...", "Save Picture...", "Save Movie...", "Open..."};
  const int actions_to_do = test::walk_actions();
  for (int i = 0; i < actions_to_do; ++i) {
    INFO("action " << i);
    const QPoint place(any(canvas->width()), any(canvas->height()));
    if (any(60) == 0) window.setAnimation(any_animation(folder / "", any(1000)));
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
        window.setView(static_cast<View>(any(9)), 1 + any(20));
        if (any(2) == 0) window.setAdditionalView(static_cast<View>(any(9)), any(3) > 0);
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
