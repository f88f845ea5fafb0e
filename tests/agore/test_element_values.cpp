#include "agore/agore_window.hpp"
#include "agore/element_panel.hpp"
#include "agore/example_run.hpp"
#include "agore/picture_words.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

#include <algorithm>

/// Values of an element picked by a click; contact ellipses and pressures on the raceways.
using namespace adore;
using namespace adore::agore;

namespace {

std::string row(const std::vector<ElementRow>& rows, const std::string& name, std::size_t race) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const ElementRow& one) { return one.name == name; });
  if (found == rows.end()) return {};
  return race == 0 ? found->outer : found->inner;
}

}  // namespace

TEST_CASE("agore_window: click on an element → its values, which equal those of the file",
          "[gui][agore][slow]") {
  test::use_qt();
  AgoreWindow window;
  window.resize(1280, 800);
  window.show();
  REQUIRE(window.openFile(test::example_run("ball")));
  auto* canvas = window.findChild<PictureWidget*>();
  canvas->grab();
  const Animation& animation = window.picture()->animation();
  CHECK_FALSE(window.panel().isVisible());
  window.setFrame(animation.frames() - 1);
  constexpr std::size_t kBall = 4;
  const auto find = [&] {  // a pixel of the ball, from the picture itself
    for (int y = 0; y < canvas->height(); y += 4)
      for (int x = 0; x < canvas->width(); x += 4)
        if (window.picture()->elementAt(canvas->rect(), QPointF(x, y), window.currentFrame(),
                                        window.options()) == kBall)
          return QPoint(x, y);
    return QPoint();
  };
  for (const View view : {View::Bearing, View::Solid}) {
    window.setView(view, 1);
    window.setValuesShown(false);
    const QPoint place = find();
    REQUIRE_FALSE(place.isNull());
    QTest::mouseClick(canvas, Qt::LeftButton, {}, place);
    CHECK(window.options().element == kBall + 1);
    REQUIRE(window.panel().isVisible());
    CHECK(window.panel().text().startsWith("Ball 5"));
  }
  const auto rows = element_rows(animation, window.currentFrame(), kBall + 1);
  const auto value = [&](const char* channel, std::size_t race) {
    return animation.value(channel, window.currentFrame(), 2 * kBall + race);
  };
  for (const std::size_t race : {0U, 1U}) {
    CHECK(row(rows, "contact load", race) ==
          desktop::pretty_quantity(value("contact.load", race), "N", 4));
    CHECK(row(rows, "largest pressure", race) ==
          desktop::pretty_quantity(value("contact.pressure", race), "Pa", 4));
    CHECK(window.panel().text().contains(
        QString::fromStdString(row(rows, "largest pressure", race))));
  }
  const std::string frequencies = fault_frequency_text(animation);
  CHECK(frequencies.starts_with("BPFO "));
  CHECK(window.panel().text().contains(QString::fromStdString(frequencies)));
  // Dragging picks nothing; the button closes.
  window.setView(View::Bearing, 1);
  const QPoint place = find();
  QTest::mousePress(canvas, Qt::LeftButton, {}, place);
  QMouseEvent move(QEvent::MouseMove, place + QPoint(60, 0), canvas->mapToGlobal(place),
                   Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(canvas, &move);
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, place + QPoint(60, 0));
  CHECK(window.options().element == 1);
  QTest::mouseClick(window.findChild<QToolButton*>("elementClose"), Qt::LeftButton);
  CHECK_FALSE(window.panel().isVisible());
  CHECK_FALSE(window.findChild<QAction*>("valuesAction")->isChecked());
}

TEST_CASE("raceway view: every type → ellipses with the pressures of the file in GPa",
          "[gui][agore][slow]") {
  test::use_qt();
  for (const std::string& type : test::kTypes) {
    INFO(type);
    MotionPicture picture(open_motion(test::example_run(type)));
    const Animation& animation = picture.animation();
    const std::size_t frame = animation.frames() - 1;
    ViewOptions options;
    options.view = View::Raceways;
    int colours = 0;
    for (options.element = 1; options.element <= std::min(4, animation.file.elements);
         ++options.element) {
      const QString words = test::all_words(picture.svg({1280, 800}, frame, options));
      CHECK(words.contains("Outer raceway"));
      const auto k = static_cast<std::size_t>(options.element - 1);
      for (const std::size_t race : {0U, 1U}) {
        if (!(animation.value("contact.load", frame, 2 * k + race) > 0.0)) continue;
        ++colours;
        const std::string pressure = desktop::pretty_quantity(
            animation.value("contact.pressure", frame, 2 * k + race), "Pa", 3);
        CHECK(words.contains(QString::fromStdString(pressure)));
      }
      CHECK(words.contains("Pa"));
    }
    CHECK(colours > 0);
    options.element = 1;
    CHECK(picture.image({1280, 800}, frame, options) != picture.image({1280, 800}, 0, options));
    // Elements are colored by the same quantity.
    const ElementColors by = element_colors(animation, frame, ColourBy::Pressure, {});
    REQUIRE(by.any());
    CHECK(by.unit == "Pa");
    CHECK(by.high_end_label().ends_with("Pa"));
  }
  CHECK_FALSE(why_not(View::Raceways, prepare(test::synthetic_sol8())).empty());
}
