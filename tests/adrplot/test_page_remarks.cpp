#include "adrplot/page_builder.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_scene.hpp"
#include "results/channels.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QGraphicsSimpleTextItem>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// Remarks on stored numbers that need an explanation.
using namespace adore;
using namespace adore::adrplot;
using Catch::Contains;
using results::SolKind;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void set(results::SolFile& file, const std::string& id, double value) {
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id.starts_with(id))
      for (auto& step : file.steps) step.values.at(c) = value;
}

desktop::ChartPage page(const results::SolFile& file, int number, const RunFacts& facts = {}) {
  PageContext context;
  context.facts = facts;
  return build_page(file, plot_pages(file.kind, file.header), number, {}, context);
}

std::size_t drawn(const std::vector<double>& values) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double v) { return std::isfinite(v); }));
}

/// Texts of a picture that hold `part`.
int texts_with(const desktop::ChartPage& page, const QString& part) {
  test::use_qt();
  desktop::ChartScene scene;
  scene.setPageSize({1280, 800});
  scene.setPage(page);
  int out = 0;
  for (QGraphicsItem* item : scene.items())
    if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item))
      out += text->text().contains(part) ? 1 : 0;
  return out;
}

}  // namespace

TEST_CASE("pages: life computed once or twice → one or two values, not a curve",
          "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Power);
  set(file, "power.life", 20503.0);
  RunFacts facts;
  facts.life_every = 0;
  for (const bool known : {true, false}) {
    const desktop::ChartPage once = page(file, 1, known ? facts : RunFacts());
    CHECK(drawn(once.panels[2].curves[0].y) == 1);
    CHECK(once.panels[2].curves[0].y.front() == 20503.0);
    CHECK_THAT(once.note, Contains(known ? "20503 hr was computed only at step 0"
                                         : "20503 hr is constant in this file"));
    CHECK((once.note.find("kLifeFreq = 0") != std::string::npos) == known);
  }
  // Predicted often and found the same, or changing: a history.
  facts.life_every = 5;
  CHECK(drawn(page(file, 1, facts).panels[2].curves[0].y) == file.steps.size());
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "power.life") file.steps.back().values[c] = 24699.0;
  CHECK(drawn(page(file, 1).panels[2].curves[0].y) == file.steps.size());
  CHECK_THAT(page(file, 1).note, !Contains("constant in"));
  // At the last step too, as a run with kLifeFreq = 0 does: nothing is known in between.
  facts.life_every = 0;
  const desktop::ChartPage twice = page(file, 1, facts);
  const std::vector<double>& life = twice.panels[2].curves[0].y;
  CHECK(drawn(life) == 2);
  CHECK(life.front() == 20503.0);
  CHECK(life.back() == 24699.0);
  CHECK_THAT(twice.note, Contains("only at the first and last step"));
}

TEST_CASE("pages: temperatures without thermal analysis → marked as input values",
          "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Power);
  file.header.value_count = 17;  // without a thermal network
  int bulk = 0;
  const auto pages = plot_pages(file.kind, file.header);
  for (std::size_t p = 0; p < pages.size(); ++p)
    if (pages[p].title == "Bulk temperatures") bulk = static_cast<int>(p) + 1;
  REQUIRE(bulk > 0);
  for (const char* id : {"power.element_temperature", "race.temperature", "power.cage_temperature"})
    set(file, id, 293.15);
  RunFacts facts;
  facts.temperatures_computed = false;
  CHECK_THAT(page(file, bulk, facts).note, Contains("input values of the deck (kTherm = 0)"));
  CHECK_THAT(page(file, bulk).note, Contains("constant input values"));
  facts.temperatures_computed = true;
  CHECK_THAT(page(file, bulk, facts).note, !Contains("input values"));
}

TEST_CASE("pages: reaction forces on a race name the constrained directions", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Race);
  for (const char* id : {"race.x", "race.y", "race.z"}) set(file, id, 2.6e-6);
  for (const char* id : {"race.theta", "race.phi", "race.angular_velocity"}) set(file, id, 0.0);
  CHECK_THAT(page(file, 2).note, Contains("prescribed in X, Y and Z"));
  CHECK_THAT(page(file, 3).note, Contains("reaction moments"));
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "race.z") file.steps[7].values[c] = 3e-6;  // it moves there
  CHECK_THAT(page(file, 2).note, Contains("prescribed in X and Y:"));
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "race.x" || columns[c].id == "race.y" || columns[c].id == "race.theta")
      file.steps[7].values[c] = 0.1;
  CHECK_THAT(page(file, 2).note, !Contains("prescribed"));
  CHECK_THAT(page(file, 3).note, !Contains("reaction"));
}

TEST_CASE("pages: a flange that the race does not have is not hedged", "[unit][adrplot]") {
  RunFacts facts;
  CHECK(missing_flange_reason(".inner.2", facts, false) ==
        "The inner race has no flange at +x, or the roller end was never close to it.");
  CHECK_FALSE(has_no_flange("flange.gap.inner.2", facts));
  facts.flanges = {"inner.1"};
  CHECK(missing_flange_reason(".inner.2", facts, false) == "The inner race has no flange at +x.");
  CHECK(missing_flange_reason(".inner.1", facts, false) ==
        "The roller end was never close to the flange at −x of the inner race.");
  CHECK(has_no_flange("flange.gap.inner.2", facts));
  CHECK_FALSE(has_no_flange("flange.gap.inner.1", facts));
}

TEST_CASE("pages: missing flange → extremes of the other flanges unchanged",
          "[unit][adrplot][step-band]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  file.header.bearing_type = 2;
  file.header.inner_flange = true;
  file.header.value_count = 73;
  for (results::SolStep& step : file.steps) step.values.assign(73, 1.0);
  set(file, "flange.gap.inner.1", 0.0);
  PageContext context;
  context.facts.flanges = {"inner.2"};
  const auto pages = plot_pages(file.kind, file.header);
  const auto flanges = std::find_if(pages.begin(), pages.end(), [](const PageSpec& page) {
    return page.title.starts_with("Inner race flange");
  });
  REQUIRE(flanges != pages.end());
  for (const PanelSpec& panel : flanges->panels)
    for (const CurveSpec& curve : panel.curves) {
      const double of = curve.column.ends_with(".2") ? 2.0 : 1.0;
      context.bands[curve.column] = {std::vector<double>(file.steps.size(), 0.5 * of),
                                     std::vector<double>(file.steps.size(), 1.5 * of)};
    }
  const desktop::ChartPage page =
      build_page(file, pages, static_cast<int>(flanges - pages.begin()) + 1, {}, context);
  REQUIRE(page.panels.size() == flanges->panels.size());
  for (const desktop::ChartPanel& panel : page.panels) {
    REQUIRE(panel.curves.size() == 1);
    REQUIRE(panel.curves.front().high.size() == file.steps.size());
    CHECK(panel.curves.front().high.front() == 3.0);
  }
}

TEST_CASE("pages: partly equal curves → distinguished from equal curves", "[gui]") {
  desktop::ChartPage chart;
  chart.x_unit = "s";
  desktop::ChartPanel panel{"Load", "N", {}, false};
  desktop::ChartCurve first{"first", {}, {}}, second{"second", {}, {}};
  for (int i = 0; i < 1000; ++i) {
    chart.x.push_back(0.001 * i);
    first.y.push_back(std::sin(0.01 * i));
    second.y.push_back(first.y.back());
  }
  panel.curves = {first, second};
  chart.panels = {panel};
  CHECK(texts_with(chart, "second (= first)") == 1);
  // Missing values change nothing where both exist.
  auto gaps = chart;
  gaps.panels[0].curves[0].y[400] = gaps.panels[0].curves[1].y[700] = kNone;
  CHECK(texts_with(gaps, "second (= first)") == 1);
  auto part = chart;
  for (int i = 600; i < 1000; ++i) part.panels[0].curves[1].y[static_cast<std::size_t>(i)] += 0.5;
  CHECK(texts_with(part, "second (partly = first)") == 1);
  auto apart = chart;
  for (double& v : apart.panels[0].curves[1].y) v += 0.5;
  CHECK(texts_with(apart, "second (") == 0);
}

TEST_CASE("axis_scale: panels that are compared share a prefix", "[unit]") {
  using desktop::AxisScale;
  using desktop::value_axis;
  const auto units = [](std::vector<AxisScale> axes) {
    std::vector<std::string> out;
    for (AxisScale axis : axes) {
      const double top = axis.value(axis.max);
      take_common_unit(axis, axes);
      CHECK(axis.value(axis.max) == Approx(top));
      out.push_back(axis.unit);
    }
    return out;
  };
  using Units = std::vector<std::string>;
  CHECK(units({value_axis(0, 1500, "N", 4), value_axis(-20, 20, "N", 4)}) == Units{"N", "N"});
  CHECK(units({value_axis(0, 50e3, "N", 4), value_axis(-20, 20, "N", 4)}) == Units{"kN", "kN"});
  CHECK(units({value_axis(0, 8, "N.m", 4), value_axis(0, 0.2, "N.m", 4)}) == Units{"mN·m", "mN·m"});
  CHECK(units({value_axis(0, 1500, "N", 4), value_axis(0, 20, "N", 4),
               value_axis(0, 0.02, "N", 4)}) == Units{"N", "N", "N"});
  // A millionth stays what it is.
  CHECK(units({value_axis(0, 50e3, "N", 4), value_axis(0, 0.02, "N", 4)}) == Units{"kN", "mN"});
}

TEST_CASE("axis_scale: base value of an axis → within its range", "[unit]") {
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{
           {-12.280, -12.272}, {0.030076, 0.030083}, {0.0300880, 0.0300960}, {499.9, 500.2}}) {
    const desktop::AxisScale axis = desktop::value_axis(low, high, "m", 4);
    REQUIRE_FALSE(axis.offset_text.empty());
    CHECK(axis.offset >= low);
    CHECK(axis.offset <= high);
  }
}

TEST_CASE("cage pages: divisor of the speed ratios given", "[unit][adrplot]") {
  const auto cage = test::synthetic_sol(SolKind::Cage);
  const auto pages = plot_pages(cage.kind, cage.header);
  const double elements = cage.header.elements;
  // One second of a run, as marks count it: FTF, and how elements pass the races.
  const auto note = [&](const std::string& column, double outer, double inner, double middle) {
    const auto turns = [&](double speed) {
      return std::vector<double>{0.0, middle * speed / 60.0, speed / 60.0};
    };
    const std::vector<double> times{0.0, 0.5, 1.0};
    PageContext context;
    const double orbit = 0.6 * outer + 0.4 * inner;
    context.marks = {{"FTF", times, turns(orbit)},
                     {"BPFO", times, turns(elements * (orbit - outer))},
                     {"BPFI", times, turns(elements * (orbit - inner))}};
    if (middle == 0.0) context.marks.clear();
    for (std::size_t p = 0; p < pages.size(); ++p)
      if (pages[p].panels.front().curves.front().column == column)
        return build_page(cage, pages, static_cast<int>(p + 1), {}, context).note;
    return std::string("no such page");
  };
  const char* const whirl = "cage.whirl_ratio";
  CHECK_THAT(note(whirl, -6000, 10000, 0.5),
             Contains("ratio to the speed of the inner race, 10000 rpm."));
  CHECK_THAT(note("cage.speed_ratio", -8000, 0, 0.5),
             Contains("of the outer race, \u22128000 rpm."));
  // No single value where speeds vary, or where nobody knows them.
  for (const double middle : {0.3, 0.0})
    CHECK_THAT(note(whirl, 0, 10000, middle), Contains("ratio to the speed of the faster race."));
  CHECK_THAT(note("cage.land1_force", 0, 10000, 0.5), !Contains("ratio to the speed"));
}
