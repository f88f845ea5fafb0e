#include "agore/motion_picture.hpp"
#include "made_run.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Data that a picture keeps between frames are invisible: after other frames a picture equals one
/// that shows this frame first.
using namespace adore;
using namespace adore::agore;

namespace {

constexpr QSize kSize(900, 600);

/// The inner race moves by `move` in the last frame.
Animation run_with_race_at(double move) {
  test::SyntheticRun run;
  run.steps = 6;
  run.balls = 9;
  Animation animation = prepare(test::synthetic_sol8(run));
  animation.file.frames.back().races[1].position[1] += move;
  return animation;
}

/// The largest difference of any color of any pixel.
int difference(const QImage& a, const QImage& b) {
  REQUIRE(a.size() == b.size());
  int most = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      most = std::max({most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                       std::abs(qBlue(p) - qBlue(q))});
    }
  return most;
}

}  // namespace

TEST_CASE("backdrop: a frame does not depend on earlier frames", "[gui]") {
  test::use_qt();
  MotionPicture used(run_with_race_at(0.0));
  ViewOptions before;
  before.view = View::Cage;
  before.dark = true;
  (void)used.image({700, 500}, 0, before);
  for (const View view :
       {View::Bearing, View::Cage, View::Element, View::InnerRace, View::OuterRace, View::Pocket})
    for (const bool dark : {false, true})
      for (const std::size_t frame : {0U, 3U, 5U}) {
        ViewOptions options;
        options.view = view;
        options.dark = dark;
        options.element = 1 + static_cast<int>(frame);
        if (frame == 3) options.beside = {{View::Pocket}}, options.zoom = 2.0;
        if (view == View::Pocket) options.beside.clear();
        INFO(view_title(view) << (dark ? ", dark" : ", light") << ", frame " << frame);
        MotionPicture fresh(run_with_race_at(0.0));
        CHECK(difference(used.image(kSize, frame, options), fresh.image(kSize, frame, options)) ==
              0);
      }
}

TEST_CASE("backdrop: a race that moves is drawn where it is", "[gui]") {
  test::use_qt();
  ViewOptions options;
  options.exaggeration = 1.0;
  for (const double part : {0.004, 0.05}) {  // of the bearing: pixels, and many of them
    const double move = part * run_with_race_at(0.0).file.geometry.outer_race_outer_radius;
    MotionPicture used(run_with_race_at(move)), fresh(run_with_race_at(move)),
        unmoved(run_with_race_at(0.0));
    for (std::size_t frame = 0; frame < 5; ++frame) (void)used.image(kSize, frame, options);
    const QImage shown = used.image(kSize, 5, options);
    CHECK(difference(shown, fresh.image(kSize, 5, options)) == 0);
    CHECK(difference(shown, unmoved.image(kSize, 5, options)) > 30);
  }
}

// Kept data (rings, keys, stamps, curves) may depend on any option: rings kept their earlier layout
// when loads or paths were switched on, because a longer key makes the bearing smaller. A walk
// through the options, one switch at a time, in which every switch is changed while every other one
// is on.
TEST_CASE("backdrop: option changed → nothing of the previous picture remains", "[gui][slow]") {
  test::use_qt();
  const adore::testing::TemporaryFolder folder;
  test::write_run(folder);
  const Animation animation = open_motion(folder / "RESULTS.h5");
  struct Look {
    ViewOptions options;
    QSize size{640, 420};
  };
  const std::vector<std::pair<std::string, std::function<void(Look&)>>> switches{
      {"loads", [](Look& look) { look.options.contacts = true; }},
      {"paths", [](Look& look) { look.options.trails = true; }},
      {"colours", [](Look& look) { look.options.colour = ColourBy::Load; }},
      {"scale of colours", [](Look& look) { look.options.scale.kind = ColorScaleKind::Moment; }},
      {"a view beside", [](Look& look) { look.options.beside = {{View::Element}}; }},
      {"three beside",
       [](Look& look) {
         look.options.beside = {{View::Cage}, {View::Pocket}, {View::Section}};
       }},
      {"clearances", [](Look& look) { look.options.exaggeration = 2.0; }},
      {"dark", [](Look& look) { look.options.dark = true; }},
      {"zoom", [](Look& look) { look.options.zoom = 1.5; }},
      {"pan",
       [](Look& look) {
         look.options.pan = {0.1, 0.0};
       }},
      {"element", [](Look& look) { look.options.element = 3; }},
      {"eye", [](Look& look) { look.options.yaw = 60.0; }},
      {"marks of a span", [](Look& look) { look.options.span_to = 1e-4; }},
      {"size",
       [](Look& look) {
         look.size = {800, 560};
       }},
  };
  constexpr std::size_t kFrame = 7;
  const std::size_t n = switches.size();
  std::mt19937 random(1);
  std::vector<bool> seen(n, false);  // each switch changes the picture somewhere
  for (const View view : {View::Bearing, View::Cage, View::Pocket, View::Element, View::OuterRace,
                          View::InnerRace, View::Section, View::Solid}) {
    MotionPicture used(animation);
    std::vector<bool> on(n, false);
    std::vector<std::vector<bool>> turned(n, std::vector<bool>(n, false));  // [switch][other]
    const auto fresh_pairs = [&](std::size_t j) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < n; ++i) count += i != j && on[i] && !turned[j][i];
      return count;
    };
    QImage before;
    std::size_t left = n * (n - 1);
    while (left > 0) {
      std::vector<std::size_t> order(n);
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), random);
      // The switch that is changed for the first time with most others on.
      const std::size_t j = *std::max_element(order.begin(), order.end(), [&](auto a, auto b) {
        return fresh_pairs(a) < fresh_pairs(b);
      });
      left -= fresh_pairs(j);
      for (std::size_t i = 0; i < n; ++i)
        if (i != j && on[i]) turned[j][i] = true;
      on[j] = !on[j];
      Look look;
      look.options.view = view;
      std::string names;
      for (std::size_t i = 0; i < n; ++i)
        if (on[i]) switches[i].second(look), names += " " + switches[i].first;
      MotionPicture fresh(animation);
      const QImage expected = fresh.image(look.size, kFrame, look.options);
      INFO(view_title(view) << ":" << names << "; turned last: " << switches[j].first);
      CHECK(used.image(look.size, kFrame, look.options) == expected);
      if (!before.isNull() && before != expected) seen[j] = true;
      before = expected;
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    INFO(switches[j].first);
    CHECK(seen[j]);
  }
}
