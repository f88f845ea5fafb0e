#include "agore/agore_window.hpp"
#include "core/results/synthetic.hpp"
#include "results/results_h5.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QAction>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::agore;

namespace {

/// A cage in three pieces of three pockets, each with its own place, turning, speed and lands; the
/// first piece begins with the second element.
Animation three_segments(const testing::TemporaryFolder& folder) {
  using namespace adore::testing;
  constexpr int kPieces = 3;
  bearing::Bearing bearing = make_bearing(9);
  bearing.cage->segments = {kPieces, false, 1, 0.01};
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= 20; ++step) {
    scene::Snapshot snapshot = make_snapshot(bearing, step);
    const scene::CageSnapshot whole = snapshot.cages.front();
    snapshot.cages.clear();
    for (int k = 0; k < kPieces; ++k) {
      scene::CageSnapshot piece = whole;
      const double middle = 2.0 * std::numbers::pi * (3.0 * k + 2.0) / 9.0;
      piece.position = {0.0, 1e-5 * (k + 1), 0.0};
      piece.orientation = turn_about_x(middle + 400.0 * snapshot.time);
      piece.omega = {400.0 + 10.0 * k, 0.0, 0.0};
      for (std::size_t land = 0; land < 2; ++land)
        piece.lands[land] = {10.0 * (k + 1) + static_cast<double>(land), 1e-5, 0.1 * (k + 1)};
      snapshot.cages.push_back(piece);
    }
    h5.write(recorder.record(snapshot));
  }
  h5.close();
  return open_motion(folder / "RESULTS.h5");
}

}  // namespace

TEST_CASE("segments: each has its own lands, turning and curves, chosen by the element",
          "[gui][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  const Animation a = three_segments(folder);
  REQUIRE(a.segments == 3);
  CHECK(a.pocket_part == std::vector<int>{2, 0, 0, 0, 1, 1, 1, 2, 2});
  for (int k = 0; k < 3; ++k) {
    for (std::size_t land = 0; land < 2; ++land) {
      const double force = 10.0 * (k + 1) + static_cast<double>(land);
      CHECK(a.land_contact(7, k, land).force == Approx(force));
      CHECK(land_force(a, land, k).value.at(7) == Approx(force));
    }
    CHECK(a.land_contact(7, k, 0).angle == Approx(0.1 * (k + 1)));
    CHECK(a.part(7, k).position[1] == Approx(1e-5 * (k + 1)));
    CHECK(cage_speed(a, k).value.at(7) == Approx(0.4 + 0.01 * k));
  }
  ViewOptions options;
  options.element = 1;
  CHECK(data_page(a, options).title == "Guide land force, segment 3 of 3");
  CHECK(data_page(a, options).panels.front().curves.front().y.at(3) == Approx(30.0));
  options.element = 5;
  CHECK(data_page(a, options).title == "Guide land force, segment 2 of 3");
  options.view = View::Cage;
  CHECK(data_page(a, options).title.ends_with(", segment 2 of 3"));
  CHECK(data_page(a, options).panels.at(1).curves.front().y.at(3) == Approx(0.41));
}

TEST_CASE("segments: the picture follows the segment of the chosen element", "[gui][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  MotionPicture picture(three_segments(folder));
  for (const View view : {View::Bearing, View::Cage, View::Pocket, View::Section, View::Solid}) {
    ViewOptions options;
    options.view = view;
    options.element = 1;
    const QImage third = picture.image({1000, 640}, 4, options);
    options.element = 5;
    CHECK(picture.image({1000, 640}, 4, options) != third);
  }
}

TEST_CASE("agore_window: held key → continues frame by frame; keys zoom, move and rotate",
          "[gui]") {
  test::use_qt();
  AgoreWindow window;
  test::SyntheticRun run;
  run.steps = 60;
  window.setAnimation(prepare(test::synthetic_sol8(run)));
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&window, key, modifiers);
  };
  for (int i = 0; i < 8; ++i) press(Qt::Key_Right);
  CHECK(window.currentFrame() == 8);
  for (int i = 0; i < 3; ++i) press(Qt::Key_Left);
  CHECK(window.currentFrame() == 5);
  CHECK(window.findChild<QAction*>("frameAction")->autoRepeat());
  press(Qt::Key_Plus);
  press(Qt::Key_Plus);
  CHECK(window.options().zoom == Approx(1.25 * 1.25));
  press(Qt::Key_Left, Qt::ControlModifier);
  CHECK(window.options().pan.x() == Approx(-0.1));
  press(Qt::Key_0);
  CHECK(window.options().zoom == 1.0);
  CHECK(window.options().pan.isNull());
  press(Qt::Key_C);
  CHECK(window.options().colour == ColourBy::Load);
  const double yaw = window.options().yaw;
  window.setView(View::Solid);
  if (window.options().view == View::Solid) {
    press(Qt::Key_Right, Qt::ControlModifier);
    CHECK(window.options().yaw != yaw);
  }
}

TEST_CASE("agore_window: everything can be reached at 700x450", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.resize(700, 450);
  window.show();
  CHECK(window.minimumSizeHint().width() <= 700);
  CHECK(window.minimumSizeHint().height() <= 450);
  auto* scroll = window.findChild<QScrollArea*>();
  REQUIRE(scroll != nullptr);
  CHECK(scroll->isAncestorOf(window.findChild<QPushButton*>("quit")));
}
