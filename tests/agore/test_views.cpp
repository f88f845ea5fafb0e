#include "agore/motion_picture.hpp"
#include "agore/render.hpp"
#include "agore/short_run.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_options.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QPainter>
#include <catch2/catch.hpp>

#include <array>
#include <ctime>
#include <numbers>

/// Objects of SOL8 alone in the views, with their places.
using namespace adore;
using namespace adore::agore;
using test::pixels_of;
using test::short_run;

namespace {

const QRect kPicture(0, 60, 780, 620);

}  // namespace

TEST_CASE("views: bearing picture shows the frames, the arrow, the dashed circle and the asterisks",
          "[gui]") {
  test::use_qt();
  MotionPicture picture(prepare(test::synthetic_sol8()));
  const ViewOptions options;
  const auto& t = theme_of(options);
  const QImage start = picture.image({1280, 800}, 0, options),
               later = picture.image({1280, 800}, 1200, options);
  for (const QColor& colour : {t.red, t.green, t.blue, t.light_blue})
    CHECK(pixels_of(later, kPicture, colour) > 60);
  CHECK(start != later);
  // No land force in the first frame: the arrow is missing there, and it is long.
  CHECK(pixels_of(later, kPicture, t.red) > pixels_of(start, kPicture, t.red) + 250);
  CHECK(picture.image({1280, 800}, 1200, options) ==
        later);  // a picture depends on its frame alone
}

TEST_CASE("views: an arrow appears exactly where the land contact is", "[gui]") {
  test::use_qt();
  auto file = test::synthetic_sol8(short_run(3));
  for (auto& frame : file.frames) {
    frame.cage.angles[0] = 0.0;
    frame.cage.position = {0, 0, 0};
    for (auto& e : frame.elements) e.pocket_force = 0.0;
    frame.land_force = {10.0, 0.0};
    frame.land_angle = {-0.5 * std::numbers::pi, 0.0};  // azimuth -90 degrees: +y, to the right
  }
  MotionPicture picture(prepare(file));
  ViewOptions options;
  options.view = View::Cage;
  const QImage image = picture.image({1280, 800}, 1, options);
  const auto& red = theme_of(options).red;
  const QRectF area = MotionPicture::pictureAreas(QRectF(0, 0, 1280, 800), 1).front();
  const QPoint middle = picture_middle(picture.animation(), options, area).toPoint();
  CHECK(pixels_of(image, QRect(middle + QPoint(110, -20), QSize(110, 40)), red) > 100);
  CHECK(pixels_of(image, QRect(middle + QPoint(-220, -20), QSize(110, 40)), red) < 20);
}

TEST_CASE("views: a round picture leaves the corner to its key, and no more than that", "[gui]") {
  test::use_qt();
  const Animation animation = prepare(test::synthetic_sol8());
  ViewOptions options;
  for (const View view : {View::Bearing, View::Element, View::OuterRace, View::InnerRace}) {
    options.view = view;
    const QRectF narrow(0, 0, 700, 684), wide(0, 0, 1500, 600);
    INFO(view_title(view));
    CHECK(picture_middle(animation, options, narrow).y() < narrow.center().y());
    CHECK(picture_middle(animation, options, narrow).y() > 0.43 * narrow.height());
    CHECK(picture_middle(animation, options, wide) == wide.center());
  }
}

TEST_CASE("views: arrows of race loads stay clear of the numbers and of the words above", "[gui]") {
  test::use_qt();
  Animation animation = prepare(test::synthetic_sol8(short_run(3)));
  ContactFrames contacts{"N", "m/s", {}, 200.0};
  contacts.frames.assign(3, std::vector<ContactFrame>(12, {{200.0, 200.0}, {1, 2}}));
  animation.contacts = contacts;
  MotionPicture picture(animation);
  ViewOptions options;
  options.contacts = true;
  const QColor blue = theme_of(options).curves[0];
  for (const QSize size : {QSize(1280, 800), QSize(700, 450)}) {
    INFO(size.width() << " x " << size.height());
    const QRect words(0, 0, size.width() / 2, 56);
    options.view = View::Element;  // element 1 is at the top
    const QImage element = picture.image(size, 0, options);
    CHECK(pixels_of(element, words, blue) == 0);
    CHECK(pixels_of(element, QRect(0, 56, size.width() / 2, size.height() / 2), blue) > 40);
    // The numbers are in a margin of 26 pixels around the rings.
    options.view = View::Bearing;
    const QImage bearing = picture.image(size, 0, options);
    const QRectF area = MotionPicture::pictureAreas(QRectF(QPointF(0, 0), size), 1).front();
    const QPointF middle = picture_middle(animation, options, area);
    const double radius =
        0.5 * std::min(area.width(),
                       area.height() - legend_height_below(animation, options, area.size()));
    const QRect number(QPointF(middle.x() - 12, middle.y() - radius).toPoint(), QSize(24, 20));
    CHECK(pixels_of(bearing, number, blue) == 0);
    CHECK(pixels_of(bearing, number.translated(0, 26), blue) > (size.width() > 1000 ? 10 : 2));
  }
}

TEST_CASE("views: each view has its data curves", "[gui]") {
  test::use_qt();
  const Animation a = prepare(test::synthetic_sol8(short_run()));
  const auto panels = [&](View view) {
    ViewOptions options;
    options.view = view;
    options.element = 3;
    const auto page = data_page(a, options);
    for (const auto& panel : page.panels)
      for (const auto& curve : panel.curves) CHECK(curve.y.size() == a.frames());
    return page.panels.size();
  };
  CHECK(panels(View::Bearing) == 1);
  CHECK(panels(View::Cage) == 2);
  CHECK(panels(View::Pocket) == 1);
  CHECK(panels(View::Element) == 2);
  CHECK(panels(View::OuterRace) == 3);
  ViewOptions wrong;
  wrong.element = 13;
  QImage image(100, 100, QImage::Format_RGB32);
  QPainter painter(&image);
  CHECK_THROWS_AS(paint_picture(painter, {0, 0, 100, 100}, a, 0, wrong), InputError);
}

TEST_CASE("views: a frame is drawn within a twenty-fifth of a second of processor time", "[gui]") {
  test::use_qt();
  MotionPicture picture(prepare(test::synthetic_sol8()));
  QImage image = picture.image({1280, 800}, 0, {});
  constexpr int kFrames = 20;
  const std::clock_t start = std::clock();
  for (int i = 0; i < kFrames; ++i)
    image = picture.image({1280, 800}, static_cast<std::size_t>(50 * i), {});
  const double per_frame =
      1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kFrames;
  INFO("one frame takes " << per_frame << " ms");
  CHECK_FALSE(image.isNull());
  CHECK(per_frame < 40.0);  // processor time, so that a busy machine does not fail it
}

TEST_CASE("views: RESULTS.h5 in the folder → element view shows contact loads", "[gui]") {
  test::use_qt();
  const auto picture = [](bool with_contacts) {
    Animation animation = prepare(test::synthetic_sol8(short_run(30)));
    CHECK_FALSE(
        animation.contacts.has_value());  // a file in memory has no other files in its folder
    CHECK_FALSE(animation.no_contacts.empty());
    if (with_contacts) {
      ContactFrames contacts{"N", "m/s", {}, 200.0};
      contacts.frames.assign(30, std::vector<ContactFrame>(12, {{200.0, 100.0}, {1, 2}}));
      animation.contacts = contacts;
    }
    ViewOptions options;
    options.view = View::Element;
    options.element = 4;
    return MotionPicture(std::move(animation)).image({780, 680}, 29, options);
  };
  const QImage with = picture(true), without = picture(false);
  const auto& curves = theme_of({}).curves;
  const QRect drawing(0, 0, 780, 560);  // above the key
  const int outer = pixels_of(with, drawing, curves[0]) - pixels_of(without, drawing, curves[0]);
  const int inner = pixels_of(with, drawing, curves[1]) - pixels_of(without, drawing, curves[1]);
  CHECK(inner > 20);
  CHECK(outer > 1.4 * inner);  // twice the load, twice the shaft
}

TEST_CASE("views: a load has its arrow in the picture, or words in the key that it is too small",
          "[gui]") {
  test::use_qt();
  int least = -1;  // pixels of its color without an arrow: the key's, and a curve's
  bool any_said = false, any_drawn = false;
  for (const double load : {0.001, 0.1, 1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0, 15.0, 50.0, 200.0}) {
    Animation animation = prepare(test::synthetic_sol8(short_run(30)));
    ContactFrames contacts{"N", "m/s", {}, 200.0};
    contacts.frames.assign(30, std::vector<ContactFrame>(12, {{load, 0.0}, {1, 0}}));
    animation.contacts = contacts;
    ViewOptions options;
    options.view = View::Element;
    options.element = 4;
    MotionPicture picture(std::move(animation));
    const bool said = picture.svg({780, 680}, 29, options).contains("too small");
    const int drawn =
        pixels_of(picture.image({780, 680}, 29, options), {0, 0, 780, 560}, theme_of({}).curves[0]);
    if (least < 0) least = drawn;
    INFO(load << " N: " << drawn << " pixels, without " << least);
    CHECK(said == (drawn == least));
    any_said = any_said || said, any_drawn = any_drawn || !said;
  }
  CHECK(any_said);
  CHECK(any_drawn);
}
