#include "agore/motion_picture.hpp"
#include "agore/pocket_outline.hpp"
#include "agore/render.hpp"
#include "agore/ring_profile.hpp"
#include "agore/short_run.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_options.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/axis_scale.hpp"
#include "results/results_h5.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QPainter>
#include <catch2/catch.hpp>
#include <hdf5.h>

#include <array>
#include <ctime>
#include <map>
#include <numbers>

using namespace adore;
using namespace adore::agore;
using test::pixels_of;
using test::short_run;

namespace {

const QRect kPicture(0, 60, 780, 620);

/// RESULTS.h5 of eight balls over 31 steps.
void write_run(const testing::TemporaryFolder& folder) {
  using namespace adore::testing;
  const bearing::Bearing bearing = make_bearing(8);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= 30; ++step) h5.write(recorder.record(make_snapshot(bearing, step)));
  h5.close();
}

/// Sizes of its bearing, in place of those that it has.
void write_sizes(const std::filesystem::path& file, const std::map<std::string, double>& sizes) {
  const hid_t h5 = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  REQUIRE(h5 >= 0);
  const hid_t group = H5Gopen2(h5, "geometry", H5P_DEFAULT), scalar = H5Screate(H5S_SCALAR);
  for (const auto& [name, value] : sizes) {
    if (H5Aexists(group, name.c_str()) > 0) H5Adelete(group, name.c_str());
    const hid_t size =
        H5Acreate2(group, name.c_str(), H5T_IEEE_F64LE, scalar, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(size, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(size);
  }
  H5Sclose(scalar);
  H5Gclose(group);
  H5Fclose(h5);
}

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
    // The numbers stand in a margin of 26 pixels round the rings.
    options.view = View::Bearing;
    const QImage bearing = picture.image(size, 0, options);
    const QRectF area = MotionPicture::pictureAreas(QRectF(QPointF(0, 0), size), 1).front();
    const QPointF middle = picture_middle(animation, options, area);
    const double radius =
        0.5 * std::min(area.width(), area.height() - key_foot(animation, options, area.size()));
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

TEST_CASE("views: the element view shows contact loads when RESULTS.h5 lies beside the file",
          "[gui]") {
  test::use_qt();
  const auto picture = [](bool with_contacts) {
    Animation animation = prepare(test::synthetic_sol8(short_run(30)));
    CHECK_FALSE(animation.contacts.has_value());  // nothing lies beside a file in memory
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
  int least = -1;  // pixels of its colour without an arrow: the key's, and a curve's
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
    const bool said = picture.svg({780, 680}, 29, options).contains("too small to draw");
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

TEST_CASE("pocket outlines have the clearances of their shape", "[unit][agore][pocket]") {
  using agore::PocketOutline;
  const auto half = [](PocketOutline p) { return agore::pocket_half(p); };
  const PocketOutline ball{.radius = 5.0, .clearance_1 = 1.0, .clearance_2 = 2.0};
  const auto with = [&](int code) {
    PocketOutline p = ball;
    p.code = code;
    return p;
  };
  CHECK(half(with(0)) == QSizeF(5.5, 5.5));
  CHECK(half(with(2)) == QSizeF(6.5, 5.5));  // round the bearing
  CHECK(half(with(3)) == QSizeF(5.5, 6.0));
  CHECK(half(with(4)) == QSizeF(6.0, 6.0));
  for (const int code : {0, 1, 2, 3, 4}) {
    const QRectF box = agore::pocket_hole(with(code)).boundingRect();
    CHECK(box.width() == Approx(2.0 * half(with(code)).width()));
    CHECK(box.height() == Approx(2.0 * half(with(code)).height()));
  }
  // A roller has half of clearance I at its sides and at its ends (decision 213).
  PocketOutline roller = ball;
  roller.roller_length = 14.0;
  CHECK(half(roller) == QSizeF(5.5, 7.5));
  agore::RollerProfile shape{.half = 7.0, .radius = 5.0};
  shape.corner = {0.5, 1.0};
  const QPainterPath upright = QTransform().rotate(90).map(shape.outline());
  CHECK(agore::pocket_hole(roller).contains(upright));
  CHECK(upright.boundingRect().width() == Approx(10.0));
  CHECK(upright.boundingRect().height() == Approx(14.0));
  // Its window has its taper: as wide as the roller and the clearance at both ends.
  roller.taper = -0.1;
  const QPainterPath window = agore::pocket_hole(roller);
  CHECK(window.contains(QPointF(6.2, -7.4)));
  CHECK_FALSE(window.contains(QPointF(4.9, 7.4)));
  CHECK(window.contains(QPointF(4.7, 7.4)));
}

TEST_CASE("the arrow of a pocket points to the wall that carries", "[unit][agore][pocket]") {
  using agore::touched_wall;
  const QPointF down(0.1, -5.0);  // far along the axis
  for (const double direction : {1.0, -1.0}) {
    // The roller drives: the wall before it, whichever way the cage turns; and behind it.
    CHECK(touched_wall(true, down, agore::kPi, direction) == QPointF(direction, 0.0));
    CHECK(touched_wall(true, down, 0.0, direction) == QPointF(-direction, 0.0));
    CHECK(touched_wall(false, {0.0, 0.0}, 0.0, direction) == QPointF(-direction, 0.0));
    CHECK(touched_wall(false, {0.0, -5.0}, 0.0, direction) == QPointF(0.0, -1.0));
  }
}

TEST_CASE("a leaning roller is seen foreshortened, in a window that leaves it its clearance",
          "[unit][agore][pocket]") {
  agore::RollerProfile shape{.half = 7.0, .radius = 5.0};
  CHECK(shape.outline(0.0) == shape.outline());
  CHECK(shape.end_seen(0.0).isEmpty());
  for (const double lean : {0.2, -0.35}) {
    const double sine = std::abs(std::sin(lean)), cosine = std::cos(lean);
    const QRectF seen = shape.outline(lean).boundingRect(),
                 end = shape.end_seen(lean).boundingRect();
    CHECK(seen.height() == Approx(10.0));
    CHECK(seen.right() == Approx(7.0 * cosine + 5.0 * sine));
    CHECK(seen.left() == Approx(-seen.right()));
    // The end at +u is seen when that leans towards the viewer.
    CHECK(end.center().x() == Approx((lean > 0.0 ? 7.0 : -7.0) * cosine));
    CHECK(end.width() == Approx(10.0 * sine));
  }
  // Cones with corners: what the section's walls leave room for is what is seen here.
  shape.slope = -0.1;
  shape.corner = {0.5, 1.0};
  for (const double lean : {0.0, 0.15, -0.3}) {
    const auto walls = agore::leaning_walls(shape, lean);
    const QRectF seen = shape.outline(lean).boundingRect();
    CHECK(seen.left() == Approx(-7.0 - walls[0]).epsilon(1e-3));
    CHECK(seen.right() == Approx(7.0 + walls[1]).epsilon(1e-3));
    agore::PocketOutline pocket{.radius = 5.0, .roller_length = 14.0, .taper = -0.1};
    pocket.clearance_1 = 1.0;
    pocket.leaning = walls;
    const QRectF hole = agore::pocket_hole(pocket).boundingRect();
    CHECK(hole.top() == Approx(seen.left() - 0.5).epsilon(1e-3));
    CHECK(hole.bottom() == Approx(seen.right() + 0.5).epsilon(1e-3));
    CHECK(agore::pocket_half(pocket).height() == Approx(std::max(-hole.top(), hole.bottom())));
    CHECK(2.0 * agore::pocket_half(pocket).width() == Approx(hole.width()));
  }
}

TEST_CASE("a roller is drawn with its cone, its arc, its corners and its domes", "[unit][agore]") {
  agore::RollerProfile r{.half = 7.0, .radius = 5.0, .slope = -0.1};
  CHECK(r.side(-7.0) == Approx(5.7));
  CHECK(r.side(7.0) == Approx(4.3));
  r.corner = {0.5, 1.0};
  CHECK(r.side(-6.5) == Approx(5.65));
  CHECK(r.side(-7.0) == Approx(5.2));
  CHECK(r.side(6.0) == Approx(4.4));
  CHECK(r.side(6.5) == Approx(4.35 - (1.0 - std::sqrt(0.75))));
  CHECK(r.side(7.0) == Approx(3.3));
  // Where the outline passes: on the side, and at the middle of its ends.
  const auto rightmost = [](const agore::RollerProfile& of) { return of.outline().boundingRect(); };
  CHECK(rightmost(r).left() == Approx(-7.0));
  CHECK(rightmost(r).right() == Approx(7.0));
  CHECK(r.outline().contains(QPointF(-6.9, 0.99 * r.side(-6.9))));
  CHECK_FALSE(r.outline().contains(QPointF(-6.9, 1.01 * r.side(-6.9))));
  // A barrel of radius 10 over 6 from its middle: 10 - 8.
  agore::RollerProfile barrel{.half = 6.0, .radius = 5.0, .crown = 10.0};
  CHECK(barrel.side(6.0) == Approx(3.0));
  CHECK(barrel.side(-6.0) == Approx(3.0));
  barrel.central = 4.0;  // straight as far as 2
  CHECK(barrel.side(2.0) == Approx(5.0));
  CHECK(barrel.side(6.0) == Approx(5.0 - (10.0 - std::sqrt(84.0))));
  // A dome of radius 13 has fallen by 1 at 5 from its crest.
  agore::RollerProfile domed{.half = 7.0, .radius = 5.0};
  domed.dome = {0.0, 13.0};
  CHECK_FALSE(domed.outline().contains(QPointF(6.1, 4.9)));
  CHECK(domed.outline().contains(QPointF(5.9, 4.9)));
  CHECK(domed.outline().contains(QPointF(6.95, 0.1)));
  CHECK(domed.outline().contains(QPointF(-6.95, 4.9)));
  // Along the meridian there is no way back, whatever dome and corner are.
  for (const double slope : {-0.1, 0.0, 0.1})
    for (const double dome : {0.0, 5.8, 8.0, 13.0, 60.0})
      for (const double corner : {0.0, 0.1, 0.5, 2.0})
        for (const double crown : {0.0, 20.0}) {
          INFO("slope " << slope << ", dome " << dome << ", corner " << corner << ", crown "
                        << crown);
          agore::RollerProfile any{.half = 7.0, .radius = 5.0, .slope = slope, .crown = crown};
          any.dome = {dome, dome}, any.corner = {corner, corner};
          const std::vector<QPointF> way = any.meridian();
          for (std::size_t i = 1; i < way.size(); ++i) CHECK(way[i].x() >= way[i - 1].x() - 1e-12);
        }
}

TEST_CASE("a skew takes as much more of the play as clearances are larger",
          "[unit][agore][pocket]") {
  using agore::drawn_skew;
  agore::RollerProfile roller{.half = 7.0, .radius = 5.0};
  // Straight: its ends go aside in proportion.
  CHECK(drawn_skew(roller.outline(), 0.0, 0.01, 10.0) == Approx(0.1).epsilon(0.05));
  CHECK(drawn_skew(roller.outline(), 0.0, -0.01, 10.0) < -0.09);
  CHECK(drawn_skew(roller.outline(), 0.0, 0.0, 10.0) == Approx(0.0).margin(1e-9));
  CHECK(drawn_skew(roller.outline(), 0.0, 0.03, 1.0) == Approx(0.03));
  CHECK(drawn_skew(roller.outline(), 0.0, 0.5, 1e3) <= agore::kPi / 3.0 + 1e-12);
  // A barrel: its arc goes aside by (R - r)(1 - cos skew), up to the arc's end at 0.19 rad.
  roller.crown = 36.0;
  const double drawn = drawn_skew(roller.outline(), 0.0, 0.06, 9.0);
  CHECK(std::sin(0.5 * drawn) == Approx(3.0 * std::sin(0.03)).epsilon(0.02));
}

TEST_CASE("what is drawn of a roller and its pocket keeps the gaps in proportion",
          "[unit][agore][pocket]") {
  using agore::moved, agore::play_in;
  // At the second wall, at the first, in the middle, one part of four; jammed, and overlapping.
  CHECK(moved({1.0, 1.0}, {3e-6, 0.0}) == Approx(1.0));
  CHECK(moved({1.0, 1.0}, {-1e-9, 3e-6}) == Approx(-1.0));
  CHECK(moved({1.0, 1.0}, {2e-6, 2e-6}) == Approx(0.0));
  CHECK(moved({3.0, 1.0}, {1e-6, 3e-6}) == Approx(-2.0));
  CHECK(moved({1.0, 1.0}, {0.0, -1e-9}) == Approx(0.0));
  CHECK(moved({-1.0, 0.5}, {0.0, 1e-6}) == Approx(0.75));
  for (const double crown : {0.0, 36.0})
    for (const double taper : {0.0, -0.1})
      for (const double skew : {0.0, 0.2, -0.1}) {
        CAPTURE(crown, taper, skew);
        const agore::RollerProfile shape{
            .half = 7.0, .radius = 5.0, .slope = taper, .crown = crown};
        const agore::PocketOutline pocket{
            .radius = 5.0, .roller_length = 14.0, .taper = taper, .clearance_1 = 3.0};
        const QPolygonF roller = agore::upright(shape.outline(), skew);
        const auto [sides, ends] = play_in(pocket, roller);
        // Moved by its play it just touches: a little less stays in the hole, a little more does
        // not.
        const QPainterPath hole = agore::pocket_hole(pocket);
        const auto inside = [&](QPointF way) {
          const QPolygonF there = roller.translated(way);
          return std::all_of(there.begin(), there.end(),
                             [&](const QPointF& p) { return hole.contains(p); });
        };
        if (ends[0] > 0.0 && ends[1] > 0.0) {
          CHECK(inside({0.99 * sides[1], 0.0}));
          CHECK(inside({-0.99 * sides[0], 0.0}));
        }
        CHECK_FALSE(inside({1.01 * sides[1] + 0.01, 0.0}));
        CHECK_FALSE(inside({-1.01 * sides[0] - 0.01, 0.0}));
        CHECK_FALSE(inside({0.0, 1.01 * ends[1] + 0.01}));
        CHECK_FALSE(inside({0.0, -1.01 * ends[0] - 0.01}));
      }
}

TEST_CASE("views: a roller is drawn at the wall that carries it, and the key tells both gaps",
          "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  for (const bool first : {true, false}) {
    const TemporaryFolder folder;
    bearing::Bearing bearing = make_bearing(8);
    bearing.cage->pocket = bearing::PocketShape::Rectangular;  // surfaces in pairs, as rollers'
    results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
    results::H5Writer h5 =
        results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
    for (long step = 0; step <= 3; ++step) {
      scene::Snapshot snapshot = make_snapshot(bearing, step);
      for (auto& element : snapshot.elements) {
        for (std::size_t i = 0; i < 4; ++i) {
          const bool touched = (i % 2 == 0) == first;
          element.pocket[i].force = touched ? 5.0 : 0.0;
          element.pocket[i].gap = touched ? -1e-8 : 3.8e-4;
          element.pocket[i].theta = first ? 0.0 : agore::kPi;
        }
      }
      h5.write(recorder.record(snapshot));
    }
    h5.close();
    write_sizes(folder / "RESULTS.h5",
                {{"bearing_type", 3.0}, {"roller_length", 0.013}, {"roller_crown_radius", 0.04}});
    MotionPicture picture = open_animation(folder / "RESULTS.h5");
    ViewOptions options;
    options.view = View::Pocket;
    options.element = 2;
    // The cage turns to the right: the wall behind the roller drives it.
    CHECK(picture.svg({1280, 800}, 2, options)
              .contains(first ? "side walls: left touched, right 380 µm away"
                              : "side walls: left 380 µm away, right touched"));
    // Between roller and wall there is paper on the one side only.
    const QImage image = picture.image({1280, 800}, 2, options);
    const QColor paper = theme_of(options).surface, cage = theme_of(options).cage;
    const int row =
        static_cast<int>(MotionPicture::pictureAreas({0, 0, 1280, 800}, 1).at(0).center().y()) - 60;
    const auto is = [&](int x, const QColor& of) {
      const QColor c = image.pixelColor(x, row);
      return std::abs(c.red() - of.red()) + std::abs(c.green() - of.green()) +
                 std::abs(c.blue() - of.blue()) <
             30;
    };
    int from = 0, to = 779;
    while (from < to && !is(from, cage)) ++from;
    while (from < to && !is(to, cage)) --to;
    std::array<int, 2> free{};
    for (int x = from; x < to; ++x) free[x < (from + to) / 2 ? 0 : 1] += is(x, paper);
    CHECK(free[first ? 0 : 1] <= 1);
    CHECK(free[first ? 1 : 0] > 20);
  }
}

TEST_CASE("the shape of a roller is what RESULTS.h5 says of it, in metres or inches",
          "[unit][agore][h5]") {
  using namespace adore::testing;
  const TemporaryFolder folder;
  write_run(folder);
  using Sizes = std::map<std::string, double>;
  Sizes sizes{{"bearing_type", 4.0},        {"roller_length", 0.014}, {"roller_half_angle", 0.05},
              {"roller_mass_offset", 1e-4}, {"cage_width", 0.02},     {"pocket_code", 0.0}};
  for (const double contact_angle : {0.2, -0.2}) {  // wherever the axis leans as the run begins
    sizes["contact_angle"] = contact_angle;
    write_sizes(folder / "RESULTS.h5", sizes);
    for (const auto units : {deck::UnitSystem::SI, deck::UnitSystem::English}) {
      const double unit = units == deck::UnitSystem::SI ? 1.0 : 0.0254;
      const Animation a = prepare(results::MotionFile::open(folder / "RESULTS.h5", units));
      const agore::RollerProfile roller = agore::roller_profile(a);
      CHECK(roller.half == Approx(0.007 / unit));
      CHECK(roller.side(-roller.half) - roller.side(roller.half) ==
            Approx(0.014 / unit * std::tan(0.05)));
      CHECK(roller.mass_centre == Approx(1e-4 / unit));
      // A file of an earlier version has neither corners, crown nor domes.
      CHECK(roller.corner == std::array<double, 2>{});
      CHECK(roller.dome == std::array<double, 2>{});
      CHECK(roller.crown == 0.0);
      const agore::CageProfile cage = agore::cage_profile(a);
      CHECK(cage.half_width == Approx(0.01 / unit));
      CHECK(cage.hole == Approx((0.007 + 0.0002) / unit));  // half of clearance I at each end
      // However a roller lies in its pocket, its walls are beyond it.
      for (const double cone : {0.0, 8.0, -20.0}) {
        const double lean = agore::nominal_lean(a) - cone * agore::kPi / 180.0;
        const auto walls = agore::leaning_walls(roller, lean);
        double most[] = {0.0, 0.0};
        for (const QPointF& p : roller.outline().toFillPolygon()) {
          const double u = agore::leaned(0.0, 0.0, lean, p.x(), p.y()).x();
          most[u < 0.0 ? 0 : 1] = std::max(most[u < 0.0 ? 0 : 1], std::abs(u));
        }
        for (const std::size_t end : {0U, 1U})
          CHECK(roller.half + walls[end] == Approx(std::max(most[end], roller.half)));
      }
    }
  }
  write_sizes(folder / "RESULTS.h5", {{"roller_plus_x_corner_radius", 3e-4},
                                      {"roller_minus_x_end_radius", 0.1},
                                      {"roller_crown_radius", 0.2},
                                      {"roller_central_length", 0.004}});
  for (const auto units : {deck::UnitSystem::SI, deck::UnitSystem::English}) {
    const double unit = units == deck::UnitSystem::SI ? 1.0 : 0.0254;
    const agore::RollerProfile roller =
        agore::roller_profile(prepare(results::MotionFile::open(folder / "RESULTS.h5", units)));
    CHECK(roller.corner[0] == 0.0);
    CHECK(roller.corner[1] == Approx(3e-4 / unit));
    CHECK(roller.dome[0] == Approx(0.1 / unit));
    CHECK(roller.dome[1] == 0.0);
    CHECK(roller.crown == Approx(0.2 / unit));
    CHECK(roller.central == Approx(0.004 / unit));
  }
  // Without the file a roller is as long as wide.
  Animation alone;
  alone.file.bearing_type = 4;
  alone.file.geometry.element_radius = 0.005;
  CHECK(agore::roller_profile(alone).half == 0.005);
  CHECK(agore::roller_profile(alone).side(-0.005) == agore::roller_profile(alone).side(0.005));
}

TEST_CASE("the section's cage leaves its pocket as open as it is", "[unit][agore][pocket]") {
  agore::CageProfile cage{.half_width = 9.0, .low = -3.0, .high = 3.0, .hole = 5.0};
  CHECK(cage.hole_at(-3.0, 0) == 5.0);
  cage.round = 5.0;  // a sphere
  CHECK(cage.hole_at(3.0, 1) == Approx(4.0));
  cage.round = 0.0, cage.flare = 0.1;  // a cone that opens outwards
  CHECK(cage.hole_at(3.0, 0) == Approx(5.3));
  CHECK(cage.hole_at(-3.0, 1) == Approx(4.7));
  cage.leaning = {0.25, 0.5};  // of a roller that leans in its pocket
  CHECK(cage.hole_at(0.0, 0) == Approx(5.25));
  CHECK(cage.hole_at(0.0, 1) == Approx(5.5));
}

TEST_CASE("views: RESULTS.h5 alone shows sections, colours and race loads", "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  const TemporaryFolder folder;
  write_run(folder);
  MotionPicture picture = open_animation(folder / "RESULTS.h5");
  const Animation& a = picture.animation();
  REQUIRE(picture.frames() == 31);
  CHECK(a.source.find("every stored step") == 0);
  CHECK(a.guide == Guide::Outer);
  CHECK(a.guide_clearance == Approx(0.0003));
  CHECK(a.land[1]);
  // Channels of the run, not differences: 400 + k rad/s of a shaft at 1000.
  const History orbit = element_orbit(a, 2);
  REQUIRE(orbit.value.size() == 31);
  for (const double ratio : orbit.value) CHECK(ratio == Approx(0.403));
  const Colouring load = colouring(a, 5, ColourBy::Load);
  REQUIRE(load.value.size() == 8);
  CHECK(load.value[2] == Approx(1300.0));  // the larger of both contacts: 100 (3 + 10)
  CHECK(load.high == Approx(1800.0));
  CHECK(load.high_end() == "1.8 kN");
  CHECK(load.of(2) == scale_colour(1300.0 / 1800.0));
  results::MotionChannel made;  // 1, 2 ... 100, the larger of both contacts, and nothing
  made.width = 2;
  for (int i = 1; i <= 100; ++i) made.values.insert(made.values.end(), {0.5 * i, 1.0 * i});
  made.values.insert(made.values.end(), {0.0, 0.0, std::nan(""), std::nan("")});
  CHECK(run_range(made).usual == 95.0);
  CHECK(run_range(made).largest == 100.0);
  CHECK(run_range(made).lowest == 0.0);
  // A short peak of the run, ten times what is usual, takes no differences away, and is told.
  Animation peak = a;
  peak.run_ranges["contact.load"] = {0.0, 18000.0, 1500.0};
  const auto scaled = [&](const std::string& scale) {
    return colouring(peak, 5, ColourBy::Load, scale_named(scale));
  };
  CHECK(scaled("usual").high == Approx(1500.0));
  CHECK(scaled("usual").high_end() == "≥ 1.5 kN");
  CHECK(scaled("usual").scale == "19 of 20 values of the run, run to 18 kN");
  CHECK(scaled("run").high == Approx(18000.0));
  CHECK_FALSE(scaled("run").above);
  CHECK(scaled("moment").high == Approx(1800.0));
  CHECK(scaled("moment").scale == "of this moment, run to 18 kN");
  CHECK(scaled("1000:1600").of(2) == scale_colour(0.5));
  CHECK(scaled("1000:1600").of(7) == scale_colour(1.0));
  CHECK(scaled("1000:1600").low_end() == "≤ 1 kN");
  for (const char* name : {"largest", "3:1", "1:1", "0:inf", "0:2 N", "0;2"})
    CHECK_THROWS_WITH(scale_named(name), Catch::Contains(name) && Catch::Contains("0:0.02"));
  for (const char* name : {"usual", "run", "moment", "-0.5:0.25"})
    CHECK(scale_name(scale_named(name)) == name);
  CHECK(scale_colour(0.0) == QColor(68, 1, 84));
  CHECK(scale_colour(1.0) == QColor(253, 231, 37));
  ViewOptions options;
  const QImage plain = picture.image({900, 600}, 3, options);
  options.colour = ColourBy::Load;
  options.contacts = true;
  CHECK(picture.image({900, 600}, 3, options) != plain);
  options = {};
  options.view = View::Section;
  options.element = 2;
  const QImage section = picture.image({900, 600}, 3, options);
  CHECK(pixels_of(section, {0, 60, 540, 460}, theme_of(options).curves[0]) > 20);
  options.zoom = 4.0;
  CHECK(picture.image({900, 600}, 3, options) != section);
  options = {};
  options.view = View::Flange;
  CHECK_THROWS_WITH(picture.image({900, 600}, 3, options), Catch::Contains("no flanges"));
}

TEST_CASE("views: a bearing whose cage has no land shows loads beside it, not an empty chart",
          "[gui][h5]") {
  using namespace adore::testing;
  TemporaryFolder folder;
  bearing::Bearing bearing = make_bearing(8);
  bearing.cage->lands.clear();
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= 5; ++step) h5.write(recorder.record(make_snapshot(bearing, step)));
  h5.close();
  const Animation a = open_motion(folder / "RESULTS.h5");
  REQUIRE_FALSE((a.land[0] || a.land[1]));
  ViewOptions options;
  options.element = 3;
  const desktop::ChartPage page = data_page(a, options);
  CHECK(page.title == "Contact loads of element 3");
  REQUIRE(page.panels.size() == 1);
  CHECK(page.panels[0].message.empty());
  CHECK(page.panels[0].curves.size() == 2);
}

TEST_CASE("views: ways of elements, loads and contacts of the cage are named in the key",
          "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  const TemporaryFolder folder;
  write_run(folder);
  MotionPicture picture = open_animation(folder / "RESULTS.h5");
  const auto& contacts = *picture.animation().contacts;
  CHECK(std::max(contacts.largest_of_race[0], contacts.largest_of_race[1]) ==
        contacts.largest_load);
  REQUIRE(contacts.largest_of_race[0] != contacts.largest_of_race[1]);
  ViewOptions options;
  options.contacts = options.trails = true;
  const auto words = [&](View view) {
    options.view = view;
    return picture.svg({1280, 800}, 20, options);
  };
  const auto load = [&](double value) {
    return QByteArray::fromStdString(desktop::pretty_quantity(value, contacts.load_unit, 3));
  };
  const QByteArray front = words(View::Bearing), solid = words(View::Solid),
                   element = words(View::Element), cage = words(View::Cage);
  for (const QByteArray& svg : {front, solid}) CHECK(svg.contains("paths of the elements"));
  CHECK(element.contains("path of the element"));
  CHECK(front.contains("race loads ≤ " + load(contacts.largest_load)));
  for (const std::size_t race : {0U, 1U})
    CHECK(solid.contains((race == 0 ? "outer" : "inner") + QByteArray(" race loads ≤ ") +
                         load(contacts.largest_of_race[race])));
  // Arrows of contacts are as long as the cage's radius, whatever the force.
  for (const QByteArray& svg : {front, cage}) {
    CHECK(svg.contains("direction of land contact"));
    CHECK(svg.contains("contact in the pocket"));
  }
  CHECK(front.contains("guide land"));
  CHECK(cage.contains("clearance about the orbit"));
  // The ways are drawn in the colour of their name.
  options.view = View::Bearing;
  const QColor way = theme_of(options).curves[3];
  const QImage with = picture.image({1280, 800}, 20, options);
  options.trails = false;
  CHECK(pixels_of(with, QRect(0, 60, 780, 480), way) > 20);  // beside that in the key
  CHECK(pixels_of(picture.image({1280, 800}, 20, options), kPicture, way) == 0);
}

TEST_CASE("views: a cage that no race guides is drawn clear of the races that it does not touch",
          "[unit][agore]") {
  Animation animation = prepare(test::synthetic_sol8());
  animation.guide = Guide::None;
  animation.guide_clearance = 0.0;
  auto& g = animation.file.geometry;
  g.pocket_clearance_1 = 0.0;  // pockets do not limit
  const double room = std::min(g.outer_race_inner_radius - g.cage_outer_radius,
                               g.cage_inner_radius - g.inner_race_outer_radius);
  REQUIRE(room > 0.0);
  for (const double share : {0.001, 0.04, 0.11, 0.3, 0.45, 0.9, 3.0}) {
    for (auto& frame : animation.file.frames) frame.cage.position = {0.0, 0.0, -share * room};
    const double factor = used_exaggeration(animation, {});
    CAPTURE(share, factor);
    CHECK(factor >= 1.0);
    CHECK((factor == 1.0 || factor * share <= 1.05));
    if (share <= 0.45) CHECK(factor > 1.0);
  }
  // A cage that dips below the inner race's rim has its room to the outer race all the same.
  g.cage_inner_radius = 0.9 * g.inner_race_outer_radius;
  const double outer = g.outer_race_inner_radius - g.cage_outer_radius;
  for (auto& frame : animation.file.frames) frame.cage.position = {0.0, 0.0, -0.3 * outer};
  CHECK(used_exaggeration(animation, {}) == 2.0);
}

TEST_CASE("views: keys name what is drawn, and nothing that is not", "[gui][agore]") {
  test::use_qt();
  Animation animation = prepare(test::synthetic_sol8());
  for (auto& frame : animation.file.frames)
    for (auto& race : frame.races) race.position = {};
  MotionPicture still(std::move(animation));
  ViewOptions options;
  options.view = View::OuterRace;
  const QByteArray none = still.svg({1280, 800}, 3, options);
  CHECK_FALSE(none.contains("path of the race centre"));
  CHECK(none.contains("spot that turns with it"));
  options.view = View::Bearing;
  CHECK(still.svg({1280, 800}, 3, options).contains("Bearing motion"));
  options.beside = {{View::Pocket}, {View::Cage}};
  const QByteArray several = still.svg({1280, 800}, 3, options);
  CHECK(several.contains("Views at the same moment"));

  // A roller that leaves its side walls may lie at an end wall, of which no file tells.
  Animation rollers = prepare(test::synthetic_sol8());
  rollers.file.bearing_type = 2;
  for (auto& frame : rollers.file.frames)
    for (auto& element : frame.elements) element.pocket_force = 0.0;
  MotionPicture free(std::move(rollers));
  options.beside.clear();
  options.view = View::Pocket;
  CHECK(free.svg({1280, 800}, 3, options).contains("end walls are not stored"));
}
