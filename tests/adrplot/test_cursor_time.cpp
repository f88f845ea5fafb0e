#include "adrplot/cursor_time.hpp"
#include "adrplot/element_curves.hpp"
#include "adrplot/plot_document.hpp"
#include "support/result_files.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// Times of cursors, and curves of the element that another window has selected. No window.
using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// Numbers of the pages with a trajectory.
std::vector<int> orbit_pages(const PlotDocument& file) {
  std::vector<int> out;
  for (std::size_t i = 0; i < file.pages.size(); ++i)
    if (file.pages[i].kind == PageKind::Orbit) out.push_back(static_cast<int>(i) + 1);
  return out;
}

/// Each stored point of a trajectory has the time of its step, and the other way round.
void check_orbits(const results::SolFile& steps) {
  const PlotDocument file = make_document(steps);
  const RunMotion motion = file.motion();
  const std::vector<int> pages = orbit_pages(file);
  REQUIRE_FALSE(pages.empty());
  for (const int number : pages)
    for (const Abscissa abscissa : {Abscissa::Revolutions, Abscissa::Time, Abscissa::Step})
      for (const OrbitAxes axes : {OrbitAxes{1, 2}, OrbitAxes{0, 1}, OrbitAxes{0, 2}}) {
        PageOptions options;
        options.abscissa = abscissa;
        options.orbit = axes;
        const desktop::ChartPage page = file.build(number, options);
        INFO(page.title << " over " << page.along_title << ", axes " << axes.across << axes.up);
        REQUIRE(page.equal_axes);
        REQUIRE(page.along.size() == steps.steps.size());
        double wrong_time = 0.0, wrong_place = 0.0;
        for (std::size_t i = 0; i < page.along.size(); ++i) {
          const auto place = cursor_at_time(page, motion, steps.steps[i].time);
          REQUIRE(place.has_value());
          wrong_place = std::max(wrong_place, std::abs(*place - page.along[i]));
          const bool moves = std::count(page.along.begin(), page.along.end(), page.along[i]) == 1;
          const auto time = time_of_cursor(page, motion, page.along[i]);
          REQUIRE(time.has_value());
          if (moves) wrong_time = std::max(wrong_time, std::abs(*time - steps.steps[i].time));
        }
        CHECK(wrong_time == 0.0);
        CHECK(wrong_place == 0.0);
        const double first = steps.steps.front().time, last = steps.steps.back().time;
        CHECK(time_of_cursor(page, motion, page.along.back() + 1.0) == last);
        CHECK(cursor_at_time(page, motion, last + 1.0) == page.along.back());
        CHECK(cursor_at_time(page, motion, first - 1.0) == page.along.front());
        for (const double none : {std::nan(""), std::numeric_limits<double>::infinity()}) {
          CHECK_FALSE(time_of_cursor(page, motion, none).has_value());
          CHECK_FALSE(cursor_at_time(page, motion, none).has_value());
        }
      }
}

results::SolFile cage_file(int steps = 61) {
  test::SyntheticRun run;
  run.steps = steps;
  return test::synthetic_sol(SolKind::Cage, run);
}

}  // namespace

TEST_CASE("cursor_time: stored points of trajectories ↔ times of their steps, for each abscissa",
          "[unit]") {
  check_orbits(cage_file());
  test::SyntheticRun run;
  run.steps = 61;
  check_orbits(test::synthetic_sol(SolKind::Race, run));
}

TEST_CASE("cursor_time: trajectory with a shaft that stops, reverses or does not turn → its times",
          "[unit]") {
  results::SolFile stops = cage_file();
  for (std::size_t i = 20; i < 40; ++i) stops.steps[i].revolutions = stops.steps[20].revolutions;
  check_orbits(stops);
  results::SolFile reverses = cage_file();
  for (std::size_t i = 31; i < reverses.steps.size(); ++i)
    reverses.steps[i].revolutions = reverses.steps[60 - i].revolutions;
  check_orbits(reverses);
  results::SolFile stands = cage_file();
  for (auto& step : stands.steps) step.revolutions = 0.0;
  check_orbits(stands);
}

TEST_CASE("cursor_time: trajectory of a part of the steps → times of this part", "[unit]") {
  results::SolFile part = cage_file();
  part.steps.erase(part.steps.begin(), part.steps.begin() + 17);
  check_orbits(part);
  results::SolFile one = cage_file();
  one.steps.resize(1);
  check_orbits(one);
}

TEST_CASE("cursor_time: between stored points → linear in time; unknown revolutions → no time",
          "[unit]") {
  const results::SolFile steps = cage_file();
  const PlotDocument file = make_document(steps);
  const RunMotion motion = file.motion();
  const desktop::ChartPage page = file.build(orbit_pages(file).front(), {});
  const double between = 0.25 * page.along[7] + 0.75 * page.along[8];
  const double time = 0.25 * steps.steps[7].time + 0.75 * steps.steps[8].time;
  CHECK(time_of_cursor(page, motion, between).value() == Approx(time).epsilon(1e-12));
  CHECK(cursor_at_time(page, motion, time).value() == Approx(between).epsilon(1e-12));
  CHECK_FALSE(time_of_cursor(page, {}, between).has_value());
  CHECK_FALSE(cursor_at_time(page, {}, time).has_value());
  // A trajectory without the abscissa of its points, such as a contour.
  desktop::ChartPage outline = page;
  outline.along.clear();
  outline.along_title.clear();
  CHECK_FALSE(time_of_cursor(outline, motion, between).has_value());
}

TEST_CASE("element_curves: charts of one element → the same curves of another one", "[unit]") {
  const auto file_of = [](int number, const char* folder) {
    results::SolFile out = test::synthetic_sol(SolKind::Element);
    out.header.title = "Rolling Element No. " + std::to_string(number) + "$";
    out.header.index = number;
    out.path = std::filesystem::path(folder) / ("SOL" + std::to_string(number));
    return make_document(std::move(out));
  };
  const PlotDocument first = file_of(1, "run"), third = file_of(3, "run"), other = file_of(4, "x");
  const PlotDocument cage = make_document(cage_file());
  const std::vector<const PlotDocument*> open{&first, &third, &other, nullptr};
  CHECK(element_of(third) == 3);
  CHECK(element_of(cage) == 0);
  CHECK(element_of_curve(cage, "element 12") == 12);
  CHECK(element_of_curve(cage, "elements 1 and 2") == 0);
  UserChart chart;
  chart.add({&first, 1, 0, 0, 2});
  chart.add({&cage, 1, 0, 0, 3});
  const auto moved = chart_of_element(chart, 3, open);
  REQUIRE(moved.has_value());
  REQUIRE(moved->curves.size() == 2);
  CHECK(element_of(*moved->curves[0].file) == 3);
  CHECK(moved->curves[0].group == 2);
  CHECK(moved->curves[1].file->subject == cage.subject);
  CHECK_FALSE(chart_of_element(chart, 1, open).has_value());  // it is shown
  CHECK_FALSE(chart_of_element(chart, 4, open).has_value());  // of another run
  CHECK_FALSE(chart_of_element(chart, 7, open).has_value());  // without a file
  chart.add({&third, 1, 0, 0});
  CHECK_FALSE(chart_of_element(chart, 3, open).has_value());  // of two elements
  desktop::ChartPage page = combine_curves(chart.curves, Combine::Overlay, {});
  REQUIRE(emphasize_element(page, 3));
  int heavy = 0;
  for (const auto& panel : page.panels)
    for (const auto& curve : panel.curves) {
      CHECK(curve.heavy == (curve.element == 3));
      heavy += curve.heavy ? 1 : 0;
    }
  CHECK(heavy == 1);
  CHECK_FALSE(emphasize_element(page, 5));

  FormulaChannel channel{"Twice", "2*a", "N", {}};
  const auto shared = std::make_shared<PlotDocument>(first);
  channel.inputs.push_back({"a", shared, 1, 0, first.build(1, {}).panels[0].curves[0].name});
  const auto formula = formula_of_element(channel, 3, open);
  REQUIRE(formula.has_value());
  CHECK(element_of(*formula->inputs[0].file) == 3);
  CHECK(formula->formula == channel.formula);
  CHECK_FALSE(formula_of_element(channel, 1, open).has_value());
  CHECK_FALSE(formula_of_element(channel, 7, open).has_value());
}
