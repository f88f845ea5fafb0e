#include "agore/animation.hpp"
#include "agore/short_run.hpp"
#include "agore/view_options.hpp"
#include "agore/view_scene.hpp"
#include "agore/views.hpp"
#include "base/errors.hpp"
#include "support/result_files.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::agore;
using test::short_run;

TEST_CASE("animation: angles become continuous and their rate is the speed", "[unit]") {
  std::vector<double> angle, time;
  for (int i = 0; i < 400; ++i) {
    time.push_back(1e-4 * i);
    // Three digits, as the file holds them.
    angle.push_back(std::round(100 * std::remainder(430.0 * time.back(), 2 * std::numbers::pi)) /
                    100);
  }
  const auto turned = continuous(angle);
  CHECK(turned.back() == Approx(430.0 * time.back()).margin(0.006));
  for (const double speed : rate(turned, time))
    CHECK(speed == Approx(430.0).epsilon(0.03));  // 0.005 rad at both ends of 0.5 rad
  CHECK(std::isnan(rate({0.0, 1.0}, {0.0, 1.0}).front()));
}

TEST_CASE("animation: rotation matrix turns about X, then the new Y, then the newest Z", "[unit]") {
  const auto r = rotation({0.3, 0.0, 0.0});
  CHECK(r(1, 2) == Approx(-std::sin(0.3)));  // z axis leans to -y, as an azimuth does
  CHECK(r(2, 2) == Approx(std::cos(0.3)));
  const auto full = rotation({0.4, -0.7, 1.1});
  CHECK((full.transpose() * full - Mat3::Identity()).norm() < 1e-14);
}

TEST_CASE("animation: speeds, pockets and guiding race are recovered from a file of three digits",
          "[unit]") {
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("SOL8").toStdString();
  const auto made = test::synthetic_sol8(short_run(600));
  test::write_text(path, test::sol8_text(made));
  const Animation a = prepare(results::read_sol8(path));
  REQUIRE(a.frames() == 600);
  CHECK(a.has_cage);
  CHECK(a.guide == Guide::Inner);
  CHECK(a.guide_clearance == Approx(150e-6));
  for (std::size_t k = 0; k < 12; ++k)  // the mean over 600 coarse angles is good to about
                                        // 0.005/sqrt(600) rad, plus averaging at the ends
    CHECK(std::abs(
              std::remainder(a.pocket_angle[k] - 2 * std::numbers::pi * static_cast<double>(k) / 12,
                             2 * std::numbers::pi)) < 2e-3);
  CHECK(shaft_speed(a) == Approx(2 * std::numbers::pi * 10000 / 60).epsilon(1e-6));
  const auto mean = [](const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum += x;
    return sum / static_cast<double>(v.size());
  };
  CHECK(mean(cage_whirl(a).value) == Approx(0.46).epsilon(0.01));
  CHECK(mean(cage_speed(a).value) == Approx(0.43).epsilon(0.01));
  CHECK(mean(element_orbit_speed(a, 4).value) == Approx(0.43).epsilon(0.01));
  // Every frame adds its rounding to a sum of sizes, so the spin comes out a little high.
  CHECK(mean(element_spin(a, 4).value) == Approx(3.1).epsilon(0.1));
}

TEST_CASE("animation: SOL8 only → drawn at its own times, unknown quantities named", "[unit]") {
  auto file = test::synthetic_sol8(short_run(60));
  // The run ends half a stored interval later: nothing may dip there.
  auto last = file.frames.back();
  last.time += 0.5 * (last.time - file.frames[58].time);
  last.revolutions = 10000.0 / 60.0 * last.time;
  const double turned = 2 * std::numbers::pi * 0.43 * last.revolutions;
  for (int k = 0; k < 12; ++k)
    last.elements[static_cast<std::size_t>(k)].theta =
        std::remainder(turned + 2 * std::numbers::pi * k / 12, 2 * std::numbers::pi);
  file.frames.push_back(last);
  const Animation a = prepare(file);
  CHECK(a.source.find("SOL8 only") == 0);
  for (const double ratio : element_orbit_speed(a, 4).value)
    CHECK(ratio == Approx(0.43).epsilon(0.05));
  CHECK(a.cage_angle[30] == Approx(continuous([&] {
          std::vector<double> angle;
          for (const auto& frame : file.frames) angle.push_back(frame.cage.angles[0]);
          return angle;
        }())[30]));
  // Every sixth frame: an element turns by about 1 turn in between, the cage by 0.13.
  auto sparse = file;
  sparse.frames.clear();
  for (std::size_t i = 0; i < 60; i += 6) sparse.frames.push_back(file.frames[i]);
  const Animation b = prepare(sparse);
  const History spin = element_spin(b, 0);
  CHECK(spin.unknown.find("Unknown: about ") == 0);
  CHECK(std::isnan(spin.value[5]));
  CHECK(element_orbit_speed(b, 0).unknown.empty());
}

TEST_CASE("animation: SOL8 with SOL files → curves from these files", "[unit]") {
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL8", test::sol8_text(test::synthetic_sol8(short_run(40))));
  const Animation alone = prepare(results::read_sol8(base / "SOL8"));
  CHECK(element_orbit_speed(alone, 0).time.size() == 40);
  const auto element = test::synthetic_sol(results::SolKind::Element);
  test::write_text(base / "SOL1", test::sol_text(element));
  const auto cage = test::synthetic_sol(results::SolKind::Cage);
  test::write_text(base / "SOL2", test::sol_text(cage));
  const History orbit = element_orbit_speed(alone, 0);
  REQUIRE(orbit.value.size() == element.steps.size());
  CHECK(orbit.value[700] == Approx(element.steps[700].values[3] / 10000.0).epsilon(1e-4));
  CHECK(element_orbit_speed(alone, 1).time.size() == 40);  // no file of that element
  const History force = pocket_force(alone, 2);
  REQUIRE(force.value.size() == cage.steps.size());
  double largest = 0.0;
  for (const auto& step : cage.steps) largest = std::max(largest, step.values[24 + 8]);
  CHECK(*std::max_element(force.value.begin(), force.value.end()) == Approx(largest).epsilon(1e-6));
}

TEST_CASE("animation: guiding race from contacts, missing lands not drawn", "[unit]") {
  auto file = test::synthetic_sol8(short_run(60));
  // The clearances alone would say inner; the cage touches on the side to which it has moved.
  for (auto& frame : file.frames) {
    const auto& p = frame.cage.position;
    const double side = std::atan2(-p[1], p[2]) - frame.cage.angles[0];
    frame.land_force = {5.0, 0.0};
    frame.land_angle = {side, 0.0};
  }
  const Animation outer = prepare(file);
  CHECK(outer.guide == Guide::Outer);
  CHECK(outer.guide_clearance == Approx(9e-4));
  CHECK(outer.land[0]);
  CHECK_FALSE(outer.land[1]);
  const auto page = data_page(outer, {});
  REQUIRE(page.panels.size() == 1);
  CHECK(page.panels[0].curves.size() == 1);
  for (auto& frame : file.frames) frame.land_force = frame.land_angle = {0.0, 0.0};
  const Animation none = prepare(file);
  CHECK(none.guide == Guide::None);
  CHECK(data_page(none, {}).panels[0].message.find("no guide land") != std::string::npos);
}

TEST_CASE("animation: unusable file → rejected with a message", "[unit]") {
  auto file = test::synthetic_sol8(short_run(5));
  auto old = file;
  old.version = "Adore0.0.9";
  CHECK_THROWS_WITH(prepare(old), Catch::Contains("versions from 0.1"));
  old.version = "nameless";
  CHECK_THROWS_AS(prepare(old), InputError);
  auto empty = file;
  empty.frames.clear();
  CHECK_THROWS_WITH(prepare(empty), Catch::Contains("no complete frame"));
  auto flat = file;
  flat.geometry.pitch_diameter = 0;
  CHECK_THROWS_AS(prepare(flat), InputError);
  auto bare = file;
  bare.geometry.cage_outer_radius = bare.geometry.cage_inner_radius = 0;
  const Animation a = prepare(bare);
  CHECK_FALSE(a.has_cage);
  CHECK_FALSE(why_not(View::Cage, a).empty());
  CHECK(why_not(View::Bearing, a).empty());
}

TEST_CASE("view_options: names, and an exaggeration that keeps pockets apart", "[unit]") {
  CHECK(parse_view("race", "outer") == View::OuterRace);
  CHECK(parse_view("flange") == View::Flange);
  CHECK_THROWS_WITH(parse_view("front"), Catch::Contains("bearing, cage, pocket, element"));
  const Animation a = prepare(test::synthetic_sol8(short_run(5)));
  CHECK(used_exaggeration(a, {}) == 5.0);
  ViewOptions options;
  options.exaggeration = 1;
  CHECK(used_exaggeration(a, options) == 1.0);
  // With any request, neighbors are apart and the cage does not cover a race.
  const auto& g = a.file.geometry;
  const double half_pitch = std::numbers::pi * 0.5 * g.pitch_diameter / a.file.elements;
  for (const double asked : {2.0, 5.0, 10.0, 20.0, 50.0, 1000.0}) {
    options.exaggeration = asked;
    const double factor = used_exaggeration(a, options);
    INFO("asked " << asked << ", drawn " << factor);
    CHECK(factor <= asked);
    CHECK(g.element_radius + 0.5 * factor * g.pocket_clearance_1 < half_pitch);
    CHECK(g.cage_outer_radius + factor * a.guide_clearance <= g.outer_race_inner_radius);
    CHECK(g.cage_inner_radius - factor * a.guide_clearance >= g.inner_race_outer_radius);
  }
  CHECK(used_exaggeration(a, options) < 1000.0);
  CHECK(used_exaggeration(a, options) >= 5.0);  // at least the automatic choice
}
