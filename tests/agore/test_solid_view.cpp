#include "agore/depth_canvas.hpp"
#include "agore/motion_picture.hpp"
#include "agore/ring_profile.hpp"
#include "agore/short_run.hpp"
#include "agore/solid_view.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/svg_writer.hpp"
#include "results/results_h5.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::agore;

namespace {

/// Eight balls as RESULTS.h5 has them.
MotionPicture picture_of_run(const testing::TemporaryFolder& folder, bool with_cage = true) {
  const bearing::Bearing bearing = testing::make_bearing(8, with_cage);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, testing::channel_table());
  results::H5Writer h5 =
      results::H5Writer::create(folder / "RESULTS.h5", bearing, testing::channel_table());
  for (long step = 0; step <= 10; ++step)
    h5.write(recorder.record(testing::make_snapshot(bearing, step)));
  h5.close();
  return MotionPicture(open_motion(folder / "RESULTS.h5"));
}

}  // namespace

TEST_CASE("depth_canvas: nearest surface visible for any drawing order", "[unit][agore]") {
  const Shades red = shades_of(QColor(200, 0, 0)), blue = shades_of(QColor(0, 0, 200));
  constexpr float kLight = 190.0F;
  const auto triangle = [&](DepthCanvas& canvas, float depth, const Shades& shades) {
    canvas.triangle({0, 0, depth, kLight}, {40, 0, depth, kLight}, {0, 40, depth, kLight}, shades);
  };
  for (const bool near_first : {true, false}) {
    DepthCanvas canvas;
    canvas.reset({40, 40}, qRgb(255, 255, 255));
    triangle(canvas, near_first ? 2.0F : 1.0F, near_first ? red : blue);
    triangle(canvas, near_first ? 1.0F : 2.0F, near_first ? blue : red);
    canvas.sphere({30, 30, 0, 0}, 5.0F, {}, blue, blue);
    const QImage image = canvas.image(1);
    CHECK(image.pixel(5, 5) == qRgb(200, 0, 0));
    CHECK(qBlue(image.pixel(30, 30)) > 100);
    CHECK(image.pixel(39, 5) == qRgb(255, 255, 255));  // right of the slanting side
    CHECK(image.pixel(24, 24) == qRgb(255, 255, 255));
  }
  // A sphere in front of a plane through its middle hides the part behind it.
  DepthCanvas canvas;
  canvas.reset({40, 40}, 0xff000000);
  canvas.sphere({10, 10, 0, 0}, 8.0F, {0, 0, 1}, blue, red);
  triangle(canvas, 0.0F, red);
  CHECK(qRed(canvas.image(1).pixel(10, 10)) > 100);  // the pole looks at us
  CHECK(qRed(canvas.image(1).pixel(1, 1)) > 100);
  CHECK(canvas.image(2).size() == QSize(20, 20));
  // Far objects of a damaged file draw nothing and have no effect.
  canvas.triangle({1e30F, 0, 0, 0}, {0, 1e30F, 0, 0}, {0, 0, 1e30F, 0}, red);
  canvas.sphere({std::nanf(""), 0, 0, 0}, 5.0F, {}, red, red);
}

TEST_CASE("solid_view: the eye of 0, 0 looks as the flat views do", "[unit][agore]") {
  const Eye front(0.0, 0.0), side(90.0, 0.0), above(0.0, 90.0);
  CHECK((front.toward - Vec3(1, 0, 0)).norm() < 1e-12);
  CHECK((front.right - Vec3(0, 1, 0)).norm() < 1e-12);
  CHECK((front.up - Vec3(0, 0, 1)).norm() < 1e-12);
  CHECK((side.toward - Vec3(0, 1, 0)).norm() < 1e-12);
  CHECK((side.right - Vec3(-1, 0, 0)).norm() < 1e-12);
  CHECK((above.toward - Vec3(0, 0, 1)).norm() < 1e-12);
}

TEST_CASE("ring_profile: tilt and skew of an axis are distinguished", "[unit][agore]") {
  results::Sol8Element roller;
  roller.angles = {0.0, -0.1, 0.0};  // the axis points to (cos 0.1, 0, sin 0.1)
  roller.theta = 0.0;                // at the top, outwards is +z
  CHECK(axis_angles(roller).lean == Approx(0.1));
  CHECK(axis_angles(roller).skew == Approx(0.0).margin(1e-15));
  roller.theta = kPi / 2.0;  // at -y, where increasing azimuth is -z
  CHECK(axis_angles(roller).lean == Approx(0.0).margin(1e-15));
  CHECK(axis_angles(roller).skew == Approx(-0.1));
}

TEST_CASE("ring_profile: a groove has its bottom and its shoulders where the file says",
          "[unit][agore]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  const MotionPicture picture = picture_of_run(folder);
  const Animation& a = picture.animation();
  const auto outer = ring_profile(a, 0), inner = ring_profile(a, 1);
  const auto lowest = [](const auto& ring, double sign) {
    double best = -1e9;
    for (const RingRadii& c : ring) best = std::max(best, sign * c.near);
    return sign * best;
  };
  const auto& g = a.file.geometry;
  // 40 columns: between two of them a groove of radius R dips by R (w/80R)^2/2, below 1e-4 of R.
  CHECK(lowest(outer, 1.0) == Approx(g.outer_race_inner_radius).epsilon(1e-3));
  CHECK(lowest(inner, -1.0) == Approx(g.inner_race_outer_radius).epsilon(1e-3));
  // It guides the cage: its shoulders are what its lands run on.
  REQUIRE(land_sections(a).size() == 2);
  CHECK(outer.front().near == Approx(0.0373));
  CHECK(outer.back().near == Approx(0.0371));
  CHECK(ring_profile(a, 0, 4.0).back().near == Approx(0.0374));  // its clearance magnified
  CHECK(inner.front().near == Approx(dimension_in_file_unit(a, "inner_shoulder_radius")));
  CHECK(outer.back().x - outer.front().x == Approx(dimension_in_file_unit(a, "outer_race_width")));
  for (const RingRadii& c : outer) CHECK(c.near <= c.far);
  for (const RingRadii& c : inner) CHECK(c.near >= c.far);
}

TEST_CASE("land_sections: lands are where the deck has them, and their race reaches to them",
          "[unit][agore]") {
  using namespace adore::testing;
  for (const auto guide : {bearing::GuideLand::Guide::Outer, bearing::GuideLand::Guide::Inner})
    for (const bool rollers : {false, true}) {
      const TemporaryFolder folder;
      bearing::Bearing bearing = make_bearing(8);
      for (auto& land : bearing.cage->lands) {
        land.guide = guide;
        if (guide == bearing::GuideLand::Guide::Inner) land.diameter = 0.068;
      }
      bearing.cage->lands[1].edge = 0.008;
      results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
      results::H5Writer h5 =
          results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
      for (long step = 0; step <= 2; ++step)
        h5.write(recorder.record(make_snapshot(bearing, step)));
      h5.close();
      Animation a = open_motion(folder / "RESULTS.h5");
      if (rollers) a.file.bearing_type = 2;  // as long as wide
      const bool outer = guide == bearing::GuideLand::Guide::Outer;
      const auto lands = land_sections(a);
      REQUIRE(lands.size() == 2);
      CHECK(lands[0].low == Approx(-0.007));
      CHECK(lands[0].high == Approx(-0.005));
      CHECK(lands[1].low == Approx(0.006));
      CHECK(lands[1].high == Approx(0.008));
      const double on_cage = outer ? 0.037 : 0.034, way = outer ? 1.0 : -1.0;
      CHECK(lands[0].on_cage == Approx(on_cage));
      CHECK(lands[0].on_race == Approx(on_cage + way * 0.0003));
      CHECK(lands[1].on_race == Approx(on_cage + way * 0.0001));
      for (const std::size_t race : {0U, 1U}) {
        const auto ring = ring_profile(a, race);
        for (std::size_t i = 1; i < ring.size(); ++i) CHECK(ring[i].x >= ring[i - 1].x - 1e-12);
        const bool guides = (race == 0) == outer;
        CHECK((ring.back().near == Approx(lands[1].on_race)) == guides);
        CHECK((ring.front().near == Approx(lands[0].on_race)) == guides);
        // The element's place in the middle is as it was.
        const auto& g = a.file.geometry;
        double deepest = race == 0 ? -1.0 : 1.0;
        for (const RingRadii& c : ring)
          deepest = race == 0 ? std::max(deepest, c.near) : std::min(deepest, c.near);
        CHECK(deepest == Approx(race == 0 ? g.outer_race_inner_radius : g.inner_race_outer_radius)
                             .epsilon(1e-3));
      }
    }
}

TEST_CASE("solid_view: seen from the front, balls are where the data say", "[gui][agore]") {
  test::use_qt();
  for (const bool with_cage : {true, false}) {
    const testing::TemporaryFolder folder;
    MotionPicture picture = picture_of_run(folder, with_cage);
    ViewOptions options;
    options.view = View::Solid;
    options.yaw = options.elevation = 0.0;
    options.exaggeration = 1.0;
    const QRectF area(0, 0, 600, 600);
    QImage image(600, 600, QImage::Format_RGB32);
    image.fill(theme_of(options).surface);
    QPainter painter(&image);
    paint_picture(painter, area, picture.animation(), 4, options);
    painter.end();
    const QPointF middle = picture_middle(picture.animation(), options, area);
    const double scale = 2.0 * middle.y() / 2.0 / solid_picture_radius(picture.animation());
    for (const auto& e : picture.animation().frame(4).elements) {
      // y to the right, z up: y = -r sin, z = r cos.
      const QPoint at =
          (middle + scale * QPointF(-e.r * std::sin(e.theta), -e.r * std::cos(e.theta))).toPoint();
      INFO(at.x() << ", " << at.y() << " cage " << with_cage);
      CHECK(image.pixelColor(at) != theme_of(options).surface);
    }
    CHECK(image.pixelColor(middle.toPoint()) == theme_of(options).surface);  // the bore
    // Turned, the picture is another; while it plays, a quicker one of the same size.
    const QImage before = picture.image({700, 500}, 4, options);
    options.yaw = 40.0;
    const QImage turned = picture.image({700, 500}, 4, options);
    CHECK(turned != before);
    options.moving = true;
    CHECK(picture.image({700, 500}, 4, options).size() == turned.size());
    options.contacts = options.trails = true;
    options.moving = false;
    CHECK(picture.image({700, 500}, 4, options) != turned);
    // Kept data are invisible.
    for (const bool moving : {true, false}) {
      options.moving = moving;
      (void)picture.image({700, 500}, 9, options);
      CHECK(picture.image({700, 500}, 2, options) ==
            picture_of_run(folder, with_cage).image({700, 500}, 2, options));
    }
  }
}

TEST_CASE("motion_picture: views too low for separate keys → shared key", "[gui][agore]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  MotionPicture picture = picture_of_run(folder);
  ViewOptions options;
  options.beside = {{View::Solid}, {View::Element}, {View::Pocket}};
  const QRectF low(0, 0, 700, 450), high(0, 0, 1920, 1200);
  const QRectF key = MotionPicture::sharedLegendArea(low, 4);
  REQUIRE_FALSE(key.isEmpty());
  CHECK(MotionPicture::sharedLegendArea(high, 4).isEmpty());
  CHECK_FALSE(MotionPicture::sharedLegendArea({0, 0, 1280, 800}, 4).isEmpty());
  CHECK(MotionPicture::sharedLegendArea(low, 1).isEmpty());
  for (const QRectF& tile : MotionPicture::pictureAreas(low, 4)) CHECK_FALSE(tile.intersects(key));
  CHECK_FALSE(MotionPicture::dataArea(low, 4).intersects(key));
  CHECK(key.bottom() < MotionPicture::timeBar(low).top() - 21.0);
  const auto count = [&](const QRectF& area, const char* words) {
    return picture.svg(area.size().toSize(), 8, options).count(words);
  };
  for (const char* const words :
       {"outer race frame", "inner race frame", "cage frame", "inner race mark", "pocket contact",
        "direction of land contact", "guide land"}) {
    INFO(words);
    CHECK(count(low, words) >= 1);
    CHECK(count(high, words) >= 1);
  }
  CHECK(count(low, "inner race frame") == 1);  // once for all views
  // The bearing has most of its picture: the width of its ring.
  {
    const QImage image = picture.image({700, 450}, 8, options);
    const QRect tile = MotionPicture::pictureAreas(low, 4).front().toRect().adjusted(3, 20, -3, -3);
    int from = tile.right(), to = tile.left();
    for (int x = tile.left(); x <= tile.right(); ++x)
      if (test::pixels_of(image, QRect(x, tile.top() + 10, 1, tile.height() - 40),
                          theme_of(options).steel_dark) > 2)
        from = std::min(from, x), to = std::max(to, x);
    CHECK(to - from > 85);
  }
  // A load and its slip are written completely.
  options.beside.clear();
  options.view = View::Element;
  const QByteArray element = picture.svg({700, 450}, 8, options);
  CHECK(element.contains("load "));
  CHECK_FALSE(element.contains("…"));
  options.view = View::Bearing;
  options.beside = {{View::Solid}, {View::Element}, {View::Pocket}};
  // The star is drawn where it is named.
  const QImage image = picture.image({700, 450}, 8, options);
  CHECK(test::pixels_of(image, key.toRect(), theme_of(options).red) > 20);
}

TEST_CASE("shared key: entries longer than a line → wrapped", "[gui][agore]") {
  test::use_qt();
  const desktop::Theme& t = desktop::theme(desktop::ThemeKind::Light);
  SharedLegend key;
  const QByteArray svg = desktop::render_svg({400, 200}, [&](QPainter& p) {
    key.draw(
        p, QRectF(0, 0, 230, 180), t,
        {{t.red, "pocket contact: 530 mN at 0°, 275 mN at 180°"}, {t.blue, "inner race frame"}});
  });
  CHECK_FALSE(svg.contains("530 mN at 0°, 275 mN at 180°"));
  CHECK(svg.contains("pocket contact: 530 mN"));
  CHECK(svg.contains("180°"));
  CHECK(svg.contains("inner race frame"));
  CHECK_FALSE(svg.contains("more"));
}

TEST_CASE("motion_picture: several views → side by side", "[gui][agore]") {
  test::use_qt();
  const QRectF area(0, 0, 1280, 800);
  CHECK(MotionPicture::pictureAreas(area, 1).size() == 1);
  for (const std::size_t views : {2U, 3U, 4U, 6U}) {
    const auto tiles = MotionPicture::pictureAreas(area, views);
    REQUIRE(tiles.size() == views);
    for (std::size_t i = 0; i < views; ++i) {
      CHECK(MotionPicture::pictureAreas(area, 1).front().contains(tiles[i]));
      for (std::size_t k = i + 1; k < views; ++k) CHECK_FALSE(tiles[i].intersects(tiles[k]));
    }
  }
  ViewOptions options;
  options.zoom = 3.0;
  options.beside = {{View::Section, 2.0, {0.1, 0.0}}};
  CHECK(options.tile(0).view == View::Bearing);
  CHECK(options.tile(0).zoom == 3.0);
  CHECK(options.tile(1).view == View::Section);
  CHECK(options.tile(1).zoom == 2.0);
  CHECK(options.tile(1).beside.empty());
}

TEST_CASE("ring_profile: an overhanging flange leaves no trace on the far side", "[unit][agore]") {
  // A roller's end that leans: the columns go back from 2 to 1.5.
  const std::vector<RingRadii> profile{
      {0.0, 6.0, 1.0}, {2.0, 5.5, 1.0}, {1.5, 4.0, 1.0}, {5.0, 3.0, 1.0}, {6.0, 2.8, 1.0}};
  const auto outline = ring_outline(profile);
  double along = 0.0;
  std::size_t near = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const QPointF &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (a.y() == 1.0 && b.y() == 1.0) along += std::abs(a.x() - b.x());
    near += a.y() > 1.0 ? 1 : 0;
  }
  CHECK(along == Approx(6.0));  // once; it was 7
  CHECK(near == profile.size());
}
