#include "adrplot/accuracy_page.hpp"
#include "adrplot/plot_document.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::adrplot;

TEST_CASE("plot_document: reading is watched, and goes on after it was stopped",
          "[unit][adrplot]") {
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
  // Room for a few columns only: another page reads again, and may be stopped.
  go_on = true;
  const PlotDocument narrow = open_document(path, {}, 3600, watch);
  go_on = false;
  CHECK_THROWS_AS(narrow.build(6, {}), results::ReadStopped);
  CHECK_THROWS_AS(narrow.build(6, {}), results::ReadStopped);
  go_on = true;
  CHECK(narrow.build(6, {}).x.size() == 3500);
}

TEST_CASE("accuracy_page: a point for each run that came to its end", "[unit][adrplot]") {
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
  CHECK(pages[0].x == std::vector<double>{0.2, 0.5});
  REQUIRE(pages[0].panels.at(0).curves.size() == 2);
  CHECK(pages[0].panels[0].curves[0].name == "rkf6");
  CHECK(pages[0].panels[0].curves[1].y[1] == Approx(0.1));
  CHECK(std::isnan(pages[0].panels[0].curves[1].y[0]));
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
  CHECK(rounds[1].title == "First round, 1 turn: what accuracy costs");
  CHECK_THAT(rounds[1].note, Catch::Contains("its tolerances (0.0001, 1e-06)"));
  CHECK_THAT(rounds[0].note, Catch::Contains("its tolerances (0.0001)"));
  testing::write_bytes(path, R"({"screening": {}, "finals": 3})");
  CHECK_FALSE(accuracy_pages(path).at(0).panels.at(0).message.empty());
  testing::write_bytes(path, R"([1, 2])");
  CHECK_THROWS_WITH(accuracy_pages(path), Catch::Contains("adore accuracy"));
}
