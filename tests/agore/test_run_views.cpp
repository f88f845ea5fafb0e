#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/picture_words.hpp"
#include "agore/render.hpp"
#include "agore/short_run.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"
#include "runs/run.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

/// Objects of RESULTS.h5 in the views, and the entries of the keys.
using namespace adore;
using namespace adore::agore;
using test::pixels_of;
using test::short_run;
using test::write_run;
using test::write_sizes;

namespace {

const QRect kPicture(0, 60, 780, 620);

}  // namespace

TEST_CASE("views: RESULTS.h5 alone shows sections, colors and race loads", "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  const TemporaryFolder folder;
  write_run(folder);
  MotionPicture picture = open_animation(folder / "RESULTS.h5");
  const Animation& a = picture.animation();
  REQUIRE(picture.frames() == 31);
  CHECK(a.source.find("all stored steps") == 0);
  CHECK(a.guide == Guide::Outer);
  CHECK(a.guide_clearance == Approx(0.0003));
  CHECK(a.land[1]);
  // Channels of the run, not differences: 400 + k rad/s of a shaft at 1000.
  const History orbit = element_orbit_speed(a, 2);
  REQUIRE(orbit.value.size() == 31);
  for (const double ratio : orbit.value) CHECK(ratio == Approx(0.403));
  const ElementColors load = element_colors(a, 5, ColourBy::Load);
  REQUIRE(load.value.size() == 8);
  CHECK(load.value[2] == Approx(1300.0));  // the larger of both contacts: 100 (3 + 10)
  CHECK(load.high == Approx(1800.0));
  CHECK(load.high_end_label() == "1.8 kN");
  CHECK(load.of(2) == scale_colour(1300.0 / 1800.0));
  results::MotionChannel made;  // 1, 2 ... 100, the larger of both contacts, and nothing
  made.width = 2;
  for (int i = 1; i <= 100; ++i) made.values.insert(made.values.end(), {0.5 * i, 1.0 * i});
  made.values.insert(made.values.end(), {0.0, 0.0, std::nan(""), std::nan("")});
  CHECK(run_range(made).usual == 95.0);
  CHECK(run_range(made).largest == 100.0);
  CHECK(run_range(made).lowest == 0.0);
  // A short peak, ten times the usual value, keeps the differences visible and is reported.
  Animation peak = a;
  peak.run_ranges["contact.load"] = {0.0, 18000.0, 1500.0};
  const auto scaled = [&](const std::string& scale) {
    return element_colors(peak, 5, ColourBy::Load, parse_color_scale(scale));
  };
  CHECK(scaled("usual").high == Approx(1500.0));
  CHECK(scaled("usual").high_end_label() == "≥ 1.5 kN");
  CHECK(scaled("usual").scale == "top 5 % off scale, max. 18 kN");
  CHECK(scaled("run").high == Approx(18000.0));
  CHECK_FALSE(scaled("run").above);
  CHECK(scaled("moment").high == Approx(1800.0));
  CHECK(scaled("moment").scale == "range of frame, max. of run 18 kN");
  CHECK(scaled("1000:1600").of(2) == scale_colour(0.5));
  CHECK(scaled("1000:1600").of(7) == scale_colour(1.0));
  CHECK(scaled("1000:1600").low_end_label() == "≤ 1 kN");
  for (const char* name : {"largest", "3:1", "1:1", "0:inf", "0:2 N", "0;2"})
    CHECK_THROWS_WITH(parse_color_scale(name), Catch::Contains(name) && Catch::Contains("0:0.02"));
  for (const char* name : {"usual", "run", "moment", "-0.5:0.25"})
    CHECK(scale_name(parse_color_scale(name)) == name);
  CHECK(scale_colour(0.0) == QColor(92, 112, 214));
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

TEST_CASE("views: ball on a split race → both contacts have key entries and curves", "[gui][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  runs::RunRequest request;
  request.deck = test::source_dir() / "resources/decks/four-point-qj208.txt";
  request.sets = {{"appLoadX", "0"}, {"appLoadZ", "2000"}};
  request.out = folder / "run";
  request.until = "0.02rev";
  (void)runs::run(request);
  const Animation a = open_motion(folder / "run/RESULTS.h5");
  REQUIRE(a.contacts);
  const std::size_t frame = a.frames() / 2;
  int element = 0;  // with the largest load on the other half of the inner race
  double most = 0.0;
  for (std::size_t k = 0; k < a.contacts_at(frame)->size(); ++k)
    if (const double load = a.value("second_contact.load", frame, 2 * k + 1); load > most) {
      most = load;
      element = static_cast<int>(k) + 1;
    }
  REQUIRE(most > 1.0);
  MotionPicture picture(a);
  ViewOptions options;
  options.element = element;
  for (const View view : {View::Section, View::Element}) {
    options.view = view;
    const QString words = test::all_words(picture.svg({1280, 900}, frame, options));
    INFO(words.toStdString());
    CHECK(words.contains("inner race, other half: "));
    CHECK_FALSE(words.contains(QChar(0x2026)));  // no name is shortened
  }
  options.view = View::Section;
  const desktop::ChartPage page = data_page(a, options);
  REQUIRE(page.panels.size() == 2);
  CHECK(page.panels[1].curves[1].name == "other half");
}

TEST_CASE("views: cage without lands → loads instead of an empty chart", "[gui][h5]") {
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
  for (const QByteArray& svg : {front, solid}) CHECK(svg.contains("element paths"));
  CHECK(element.contains("no path"));  // the ball still lies over it
  CHECK(front.contains("race loads ≤ " + load(contacts.largest_load)));
  for (const std::size_t race : {0U, 1U})
    CHECK(solid.contains((race == 0 ? "outer" : "inner") + QByteArray(" race loads ≤ ") +
                         load(contacts.largest_of_race[race])));
  // Arrows of contacts are as long as the radius of the cage, for any force.
  for (const QByteArray& svg : {front, cage}) {
    CHECK(svg.contains("direction of land contact"));
    CHECK(svg.contains(">pocket contact"));
  }
  CHECK(front.contains("guide land"));
  CHECK(cage.contains("clearance circle"));
  // The ways are drawn in the color of their name.
  options.view = View::Bearing;
  const QColor way = theme_of(options).curves[3];
  const QImage with = picture.image({1280, 800}, 20, options);
  options.trails = false;
  CHECK(pixels_of(with, QRect(0, 60, 780, 480), way) > 20);  // next to it in the key
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
  // A cage below the rim of the inner race still has its clearance to the outer race.
  g.cage_inner_radius = 0.9 * g.inner_race_outer_radius;
  const double outer = g.outer_race_inner_radius - g.cage_outer_radius;
  for (auto& frame : animation.file.frames) frame.cage.position = {0.0, 0.0, -0.3 * outer};
  CHECK(used_exaggeration(animation, {}) == 2.0);
}

TEST_CASE("views: the speed of a run has its sign", "[gui][agore]") {
  test::use_qt();
  for (const double way : {1.0, -1.0}) {
    Animation animation = prepare(test::synthetic_sol8());
    auto& frames = animation.file.frames;
    for (auto& frame : frames) frame.revolutions = way * 100.0 * (frame.time - frames.front().time);
    MotionPicture picture(std::move(animation));
    const QString svg = QString::fromUtf8(picture.svg({1280, 800}, 3, {}));
    CHECK(svg.contains("runs at 6000 rpm") == (way > 0.0));
    CHECK(svg.contains(QString("runs at \u22126000 rpm")) == (way < 0.0));
  }
}

TEST_CASE("views: varying speed → given by its ends or limits, not by a mean", "[gui][agore]") {
  test::use_qt();
  const auto heading = [](const std::function<double(double)>& turned) {
    Animation animation = prepare(test::synthetic_sol8());
    auto& frames = animation.file.frames;
    const double span = frames.back().time - frames.front().time;
    for (auto& frame : frames)
      frame.revolutions = span * turned((frame.time - frames.front().time) / span);
    MotionPicture picture(std::move(animation));
    return QString::fromUtf8(picture.svg({1280, 800}, 3, {}));
  };
  // From 10000 to 4000 rpm: 6500 and 7000 are not speeds of this run.
  CHECK(heading([](double t) {
          return (10000.0 * t - 3000.0 * t * t) / 60.0;
        }).contains("runs from 10000 to 4000 rpm"));
  CHECK(heading([](double t) { return 3000.0 * t * t / 60.0; }).contains("from 0 to 6000 rpm"));
  const double turn = 2.0 * std::numbers::pi;
  CHECK(heading([turn](double t) {
          return (6000.0 * t - 1000.0 * std::cos(turn * t) / turn) / 60.0;
        }).contains("runs between "));
}

TEST_CASE("views: keys list exactly the drawn marks", "[gui][agore]") {
  test::use_qt();
  Animation animation = prepare(test::synthetic_sol8());
  for (auto& frame : animation.file.frames)
    for (auto& race : frame.races) race.position = {};
  MotionPicture still(std::move(animation));
  ViewOptions options;
  options.view = View::OuterRace;
  const QByteArray none = still.svg({1280, 800}, 3, options);
  CHECK_FALSE(none.contains("path of the race center"));
  CHECK(none.contains("race mark"));
  options.view = View::Bearing;
  CHECK(still.svg({1280, 800}, 3, options).contains("Bearing motion"));
  options.beside = {{View::Pocket}, {View::Cage}};
  const QByteArray several = still.svg({1280, 800}, 3, options);
  CHECK(several.contains("Views of the same frame"));

  // Missing objects of a frame are listed as none, and the key does not move.
  Animation cage = prepare(test::synthetic_sol8());
  cage.guide = Guide::Outer;
  for (std::size_t i = 0; i < cage.file.frames.size(); ++i) {
    auto& frame = cage.file.frames[i];
    frame.land_force = {i == 3 ? 0.0 : 2.0, 0.0};
    for (auto& element : frame.elements) element.pocket_force = i == 4 ? 0.0 : 1.0;
  }
  MotionPicture touching(std::move(cage));
  for (const View view : {View::Bearing, View::Cage}) {
    options.beside.clear();
    options.view = view;
    const auto key = [&](std::size_t frame) { return touching.svg({700, 450}, frame, options); };
    const auto place_of = [](const QByteArray& svg, const char* words) {
      const auto at = svg.indexOf(words);
      REQUIRE(at > 0);
      const auto from = svg.lastIndexOf("<text", at);
      return svg.mid(from, svg.indexOf('>', from) - from);
    };
    for (const char* const words : {">pocket contact", "direction of land contact"})
      CHECK(key(2).contains(words));
    CHECK(key(3).contains("no land contact"));
    CHECK_FALSE(key(3).contains("direction of land contact"));
    CHECK(key(4).contains("no pocket contact"));
    CHECK_FALSE(key(4).contains(">pocket contact<"));
    for (const char* const words : {"cage frame", "guide land", "clearance circle"})
      if (key(2).contains(words)) CHECK(place_of(key(2), words) == place_of(key(3), words));
    CHECK(place_of(key(2), "direction of land contact") == place_of(key(3), "no land contact"));
  }

  // A roller that leaves its side walls may lie at an end wall, of which no file tells.
  Animation rollers = prepare(test::synthetic_sol8());
  rollers.file.bearing_type = 2;
  for (auto& frame : rollers.file.frames)
    for (auto& element : frame.elements) element.pocket_force = 0.0;
  MotionPicture free(std::move(rollers));
  options.beside.clear();
  options.view = View::Pocket;
  CHECK(free.svg({1280, 800}, 3, options).contains("contacts with end walls are not stored"));
}
