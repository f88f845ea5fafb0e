#include "agore/agore_window.hpp"
#include "agore/made_run.hpp"
#include "agore/picture_words.hpp"
#include "agore/short_run.hpp"
#include "agore/shown_window.hpp"
#include "agore/view_bar.hpp"
#include "core/results/synthetic.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

#include <cmath>

/// Parts of the picture that can be hidden, the view bar, and the whirl near the axis.
using namespace adore;
using namespace adore::agore;

namespace {

double area_of(const QRectF& rect) { return rect.width() * rect.height(); }

}  // namespace

TEST_CASE("motion picture: hidden heading, chart and legend → the bodies get their space",
          "[gui][agore]") {
  test::use_qt();
  const QRectF all(0, 0, 1280, 800);
  const auto picture = [&](const ShownParts& shown, std::size_t views) {
    return MotionPicture::pictureAreas(all, views, shown).front();
  };
  for (const std::size_t views : {1U, 4U}) {
    const double whole = area_of(picture({}, views));
    CHECK(area_of(picture({false, true, true}, views)) > 1.05 * whole);
    // The chart has more than a fifth of the height.
    CHECK(area_of(picture({true, false, true}, views)) > 1.25 * whole);
    CHECK(picture({false, false, false}, views).top() < 20.0);
    for (const ShownParts& shown :
         {ShownParts{true, false, true}, ShownParts{false, false, true}}) {
      const QRectF key = MotionPicture::sharedLegendArea(all, views, shown);
      for (const QRectF& tile : MotionPicture::pictureAreas(all, views, shown)) {
        CHECK_FALSE(tile.intersects(key));
        CHECK(all.contains(tile));
      }
    }
  }
  CHECK(MotionPicture::dataArea(all, 1, {true, false, true}).isEmpty());
  CHECK(MotionPicture::sharedLegendArea(all, 4, {true, true, false}).isEmpty());
  MotionPicture motion(prepare(test::synthetic_sol8(test::short_run(61))));
  ViewOptions options;
  const auto words = [&] { return test::all_words(motion.svg({1280, 800}, 3, options)); };
  const QString before = words();
  CHECK(before.contains("Bearing motion"));
  CHECK(before.contains("inner race frame"));
  CHECK(before.contains("Time [ms]"));
  options.shown = {false, false, false};
  const QString after = words();
  for (const char* part : {"Bearing motion", "inner race frame", "Time [ms]"})
    CHECK_FALSE(after.contains(part));
  CHECK(after.contains("frame 4 of 61"));
  // Kept pictures follow.
  const QImage hidden = motion.image({900, 600}, 3, options);
  options.shown = {};
  CHECK(motion.image({900, 600}, 3, options) != hidden);
}

TEST_CASE("agore_window: keys hide heading, chart and legend, and a later window remembers it",
          "[gui][agore]") {
  test::use_qt();
  QSettings("Adore", kApp).remove("shown");
  {
    AgoreWindow window;
    PictureWidget* canvas = test::show_painted(window);
    const QImage whole = canvas->grab().toImage();
    for (const Qt::Key key : {Qt::Key_H, Qt::Key_G, Qt::Key_K}) QTest::keyClick(canvas, key);
    CHECK(window.options().shown == ShownParts{false, false, false});
    CHECK(canvas->grab().toImage() != whole);
    // A click where the chart was goes to no time.
    const QRectF data = MotionPicture::dataArea(canvas->rect());
    QTest::mouseClick(canvas, Qt::LeftButton, {}, data.center().toPoint());
    CHECK(window.currentFrame() == 0);
  }
  {
    AgoreWindow window;
    window.show();
    CHECK(window.options().shown == ShownParts{false, false, false});
    for (const char* name : {"headingAction", "chartAction", "keyAction"}) {
      CHECK_FALSE(window.findChild<QAction*>(name)->isChecked());
      window.findChild<QAction*>(name)->trigger();
    }
    CHECK(window.options().shown == ShownParts{});
    auto* bar = window.findChild<ViewBar*>();
    CHECK(bar->isVisible());
    window.findChild<QAction*>("barAction")->trigger();
    CHECK_FALSE(bar->isVisible());
    window.findChild<QAction*>("barAction")->trigger();
  }
  QSettings("Adore", kApp).remove("shown");
}

TEST_CASE("agore_window: view bar → one click per view, disabled ones with the reason",
          "[gui][agore]") {
  test::use_qt();
  AgoreWindow window;
  test::show_painted(window);
  auto* bar = window.findChild<ViewBar*>();
  for (const View view :
       {View::Cage, View::Pocket, View::Element, View::OuterRace, View::Bearing}) {
    QTest::mouseClick(bar->button(view), Qt::LeftButton);
    CHECK(window.options().view == view);
    CHECK(bar->button(view)->isChecked());
  }
  CHECK_FALSE(bar->button(View::Flange)->isEnabled());
  CHECK(bar->button(View::Flange)->toolTip() == "Ball bearings have no flanges.");
  window.setView(View::Cage);
  CHECK(bar->button(View::Cage)->isChecked());
  CHECK_FALSE(bar->button(View::Bearing)->isChecked());
}

TEST_CASE("cage whirl: center near the axis → no value, and the page states the limit",
          "[gui][agore][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  const bearing::Bearing bearing = testing::make_bearing(8);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, testing::channel_table());
  results::H5Writer h5 =
      results::H5Writer::create(folder / "RESULTS.h5", bearing, testing::channel_table());
  constexpr std::size_t kNear = 12;
  for (std::size_t step = 0; step <= 30; ++step) {
    scene::Snapshot snapshot = testing::make_snapshot(bearing, static_cast<long>(step));
    // The radial clearance is 0.3 mm: 5 % of it are 15 µm.
    if (step == kNear) snapshot.cages.at(0).position *= 0.1;
    h5.write(recorder.record(snapshot));
  }
  h5.close();
  const Animation animation = open_motion(folder / "RESULTS.h5");
  const History whirl = cage_whirl(animation);
  CHECK(whirl.least_radius == Approx(15e-6));
  for (std::size_t i = 0; i < whirl.value.size(); ++i)
    CHECK(std::isfinite(whirl.value[i]) == (i != kNear));
  ViewOptions options;
  options.view = View::Cage;
  const desktop::ChartPage page = data_page(animation, options);
  CHECK(page.panels.at(0).title == "Whirl (r > 15 µm)");
  MotionPicture picture(open_motion(folder / "RESULTS.h5"));
  CHECK(test::all_words(picture.svg({1280, 800}, kNear, options))
            .contains("Whirl (r > 15 µm): none"));
  CHECK_FALSE(
      test::all_words(picture.svg({1280, 800}, kNear + 1, options)).contains("15 µm): none"));
}
