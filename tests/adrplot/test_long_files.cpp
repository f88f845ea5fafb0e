#include "adrplot/accuracy_page.hpp"
#include "adrplot/plot_document.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/chart_scene.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::adrplot;

TEST_CASE("plot_document: reading is monitored, and continues after a stop", "[unit][adrplot]") {
  const testing::TemporaryFolder folder;
  test::SyntheticRun run;
  run.steps = 3500;
  const auto path = folder / "SOL1";
  test::write_text(path, test::sol_text(test::synthetic_sol(results::SolKind::Element, run)));
  std::vector<double> parts;
  bool go_on = true;
  const auto watch = [&](double part) {
    parts.push_back(part);
    return go_on;
  };
  const PlotDocument document = open_document(path, {}, kMostValues, watch);
  REQUIRE(parts.size() >= 4);
  CHECK(std::is_sorted(parts.begin(), parts.end()));
  CHECK(parts.front() < 0.1);
  CHECK(parts.back() == 1.0);
  CHECK(document.build(1, {}).x.size() == 3500);
  go_on = false;
  CHECK_THROWS_AS(open_document(path, {}, kMostValues, watch), results::ReadStopped);
  // Space for a few columns only: another page reads again and can be stopped.
  go_on = true;
  const PlotDocument narrow = open_document(path, {}, 3600, watch);
  go_on = false;
  CHECK_THROWS_AS(narrow.build(6, {}), results::ReadStopped);
  CHECK_THROWS_AS(narrow.build(6, {}), results::ReadStopped);
  go_on = true;
  CHECK(narrow.build(6, {}).x.size() == 3500);
}

TEST_CASE("accuracy_page: a point for each completed run", "[unit][adrplot]") {
  const testing::TemporaryFolder folder;
  const auto path = folder / "ACCURACY.json";
  testing::write_bytes(path,
                       R"({"title": "What accuracy costs: 2 turns", "error_title": "largest error",
          "screening": [{"curve": "rkf5", "seconds": 0.5, "error": 1e-3},
                        {"curve": "rkf6", "seconds": 0.2, "error": 1e-2},
                        {"curve": "rkf5", "seconds": 0.1, "error": 0.0},
                        {"curve": "rkf5", "seconds": 0.3, "failure": "gave up"},
                        {"curve": "rkf5", "seconds": 0.4, "error": null}, 7]})");
  const auto pages = accuracy_pages(path);
  REQUIRE(pages.size() == 1);
  // The frame stands aside of the first and the last point.
  REQUIRE(pages[0].x.size() == 4);
  CHECK(pages[0].x[1] == 0.2);
  CHECK(pages[0].x[2] == 0.5);
  CHECK(pages[0].x[0] < 0.9 * 0.2);
  CHECK(pages[0].x[3] > 1.1 * 0.5);
  REQUIRE(pages[0].panels.at(0).curves.size() == 2);
  CHECK(pages[0].panels[0].curves[0].name == "rkf6");
  CHECK(pages[0].panels[0].curves[1].y[2] == Approx(0.1));
  CHECK(std::isnan(pages[0].panels[0].curves[1].y[1]));
  CHECK(pages[0].log_x);
  CHECK(open_document(path).pages.size() == 1);
  // Each round says its own span, and what the points of a method are.
  testing::write_bytes(path, R"({"title": "What accuracy costs: 50 turns", "short_turns": 1,
    "screening": [{"curve": "rkf5", "seconds": 0.5, "error": 1e-3, "tol": 1e-4},
                  {"curve": "rkf5", "seconds": 0.7, "error": 1e-4, "tol": 1e-6}],
    "finals": [{"curve": "rkf5", "seconds": 50.5, "error": 1e-3, "tol": 1e-4}]})");
  const auto rounds = accuracy_pages(path);
  REQUIRE(rounds.size() == 2);
  CHECK(rounds[0].title == "What accuracy costs: 50 turns");
  CHECK(rounds[1].title == "First round, 1 revolution: error against time");
  CHECK_THAT(rounds[1].note, Catch::Contains("one tolerance (0.0001, 1e-06)"));
  CHECK_THAT(rounds[0].note, Catch::Contains("one tolerance (0.0001)"));
  testing::write_bytes(path, R"({"screening": {}, "finals": 3})");
  CHECK_FALSE(accuracy_pages(path).at(0).panels.at(0).message.empty());
  testing::write_bytes(path, R"([1, 2])");
  CHECK_THROWS_WITH(accuracy_pages(path), Catch::Contains("adore accuracy"));
}

TEST_CASE("accuracy_page: errors within the scatter → shaded band, significant points marked",
          "[gui][adrplot]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  const auto path = folder / "ACCURACY.json";
  const auto study = [](const std::string& irregular) {
    return R"({"title": "What accuracy costs: 5 turns", "error_title": "largest error",
      "screening": [], "recommended": 1, "long_reference": {"noise": {"speed": 1e-4}},)" +
           irregular + R"(
      "finals": [
        {"name": "own", "curve": "rkf5", "seconds": 0.36, "error": 6e-3, "own": true,
         "errors": {"speed": 6e-3, "heat": 1e-4}},
        {"name": "cheap", "curve": "rk4", "seconds": 0.1, "error": 4e-3, "own": false,
         "errors": {"speed": 1e-4, "heat": 4e-3}},
        {"name": "dear", "curve": "pece4", "seconds": 0.9, "error": 3e-2, "own": false,
         "errors": {"speed": 3e-2, "heat": 1e-4}}]})";
  };
  testing::write_bytes(path, study(R"("irregular": {"speed": 8e-3, "heat": 1e-3},)"));
  const auto page = accuracy_pages(path).front();
  CHECK_THAT(page.note, Catch::Contains("Errors below 1.2 % (shaded) cannot be distinguished"));
  CHECK_THAT(page.note, Catch::Contains("1 point in the shaded area"));  // the heat of "cheap"
  REQUIRE(page.marks.size() == 2);
  CHECK(page.marks[0].x == 0.1);
  CHECK(page.marks[0].label == "recommended");
  CHECK(page.marks[1].x == 0.36);
  CHECK(page.marks[1].label == "this deck");
  for (const QSize size : {QSize(700, 450), QSize(1280, 800)}) {
    desktop::ChartScene scene;
    scene.setPageSize(size);
    scene.setPage(page);
    const QImage image = scene.image(size);
    const QRectF area = scene.plotAreas().front();
    // Of one color from the floor down, of another one from it up, all the way across.
    const int floor = static_cast<int>(scene.sceneYAt(0, 1.2));
    const auto at = [&](double part, int y) {
      return image.pixelColor(static_cast<int>(area.left() + part * area.width()), y);
    };
    for (const double part : {0.02, 0.98}) {
      CHECK(at(part, floor + 7) != image.pixelColor(1, 1));
      CHECK(at(part, floor - 7) == image.pixelColor(1, 1));
    }
    for (const double seconds : {0.1, 0.36, 0.9}) {
      CHECK(scene.sceneXAt(seconds) > area.left() + 10.0);
      CHECK(scene.sceneXAt(seconds) < area.right() - 10.0);
    }
  }
  // Without a known scatter there is no floor.
  testing::write_bytes(path, study(""));
  CHECK(accuracy_pages(path).front().panels.front().curves.size() == 4);
  std::string unknown = study("");
  unknown.replace(unknown.find("1e-4}}"), 4, "-1.0");
  testing::write_bytes(path, unknown);
  CHECK(accuracy_pages(path).front().panels.front().curves.size() == 3);
  CHECK_THAT(accuracy_pages(path).front().note, !Catch::Contains("distinguished"));
}
