#include "agore/agore_window.hpp"
#include "agore/film_dialog.hpp"
#include "agore/shown_window.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QComboBox>
#include <QTest>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

/// The part of a run that is repeated.
using namespace adore;
using namespace adore::agore;
using test::pixels_of;
using test::short_run;

namespace {

QAction* action_of(AgoreWindow& window, const QString& text) {
  for (auto* action : window.findChildren<QAction*>())
    if (action->text().remove('&') == text) return action;
  return nullptr;
}

}  // namespace

TEST_CASE("agore_window: what is marked is repeated, offered as a film, and taken away again",
          "[gui][span]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8(short_run(60))));
  window.resize(1100, 700);
  window.show();
  const auto mark = [&](std::size_t frame, const char* what) {
    window.setFrame(frame);
    action_of(window, what)->trigger();
  };
  mark(20, "Repeat From Here");
  mark(29, "Repeat to Here");
  CHECK(action_of(window, "Repeat")->isChecked());
  window.setFrame(3);
  window.findChild<QComboBox*>("speed")->setCurrentText("1000");
  window.playForward();
  std::size_t least = 60, most = 0;
  int turns = 0;
  std::size_t before = 20;
  for (int i = 0; i < 400 && turns < 4; ++i) {
    QTest::qWait(5);
    const std::size_t now = window.currentFrame();
    least = std::min(least, now), most = std::max(most, now);
    turns += now < before;
    before = now;
  }
  CHECK(window.playing());
  window.pause();
  CHECK(turns >= 2);
  CHECK(least >= 20);
  CHECK(most <= 29);
  window.saveMovie();
  auto* film = window.findChild<MovieDialog*>("filmRange");
  REQUIRE(film != nullptr);
  CHECK(film->first() == 20);
  CHECK(film->last() == 29);
  film->reject();
  // It is seen on the time line, and not in what is saved.
  auto* canvas = window.findChild<PictureWidget*>();
  const auto shown = [&] { return canvas->grab().toImage(); };
  const QImage with = shown();
  action_of(window, "Delete Repeat Range")->trigger();
  CHECK_FALSE(window.options().span_from.has_value());
  CHECK(shown() != with);
  // An end that would be passed is given up.
  mark(20, "Repeat From Here");
  mark(10, "Repeat to Here");
  CHECK_FALSE(window.options().span_from.has_value());
  CHECK(window.options().span_to == window.picture()->animation().time[10]);
}

TEST_CASE("agore_window: Shift and a drag over the time bar or a curve mark what is repeated",
          "[gui][span]") {
  test::use_qt();
  AgoreWindow window;
  auto* canvas = test::show_painted(window);
  const QRectF bar = MotionPicture::timeBar(canvas->rect()),
               data = MotionPicture::dataArea(canvas->rect());
  const auto& time = window.picture()->animation().time;
  for (const QRectF& line : {bar, data}) {
    for (const bool backward : {false, true}) {
      QPoint from = QPointF(line.left() + 0.4 * line.width(), line.center().y()).toPoint(),
             to = QPointF(line.left() + 0.7 * line.width(), line.center().y()).toPoint();
      if (backward) std::swap(from, to);
      window.setRepeatRange({}, {});
      QTest::mousePress(canvas, Qt::LeftButton, Qt::ShiftModifier, from);
      QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                       Qt::ShiftModifier);
      QCoreApplication::sendEvent(canvas, &move);
      QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ShiftModifier, to);
      REQUIRE(window.options().span_from.has_value());
      REQUIRE(window.options().span_to.has_value());
      CHECK(window.currentFrame() == 0);  // it marks, and goes nowhere
      const double begin = *window.options().span_from, end = *window.options().span_to;
      CHECK(begin < end);
      if (line == bar) {
        CHECK(begin == Approx(time.front() + 0.4 * (time.back() - time.front())).epsilon(0.01));
        CHECK(end == Approx(time.front() + 0.7 * (time.back() - time.front())).epsilon(0.01));
      }
    }
  }
}
