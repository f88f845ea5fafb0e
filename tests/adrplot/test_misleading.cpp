#include "adrplot/plot_document.hpp"
#include "desktop/chart_scene.hpp"
#include "results/channels.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QGraphicsLineItem>
#include <QPen>
#include <catch2/catch.hpp>

#include <string>

/// What a file stores and nothing computed is not drawn as a result.
using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// Every value of the columns whose names begin so.
void set(results::SolFile& file, const std::string& begin, double value) {
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id.starts_with(begin))
      for (auto& step : file.steps) step.values.at(c) = value;
}

/// Page by a word of its title.
desktop::ChartPage page_with(const results::SolFile& file, const std::string& word,
                             const PageOptions& options = {}) {
  const PlotDocument document = make_document(file);
  for (std::size_t p = 0; p < document.pages.size(); ++p)
    if (document.pages[p].title.find(word) != std::string::npos)
      return document.build(static_cast<int>(p) + 1, options);
  FAIL("no page about " << word);
  return {};
}

}  // namespace

TEST_CASE("pages: rounding of spin over roll is not drawn as a signal", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  set(file, "contact.load.", 100.0);
  set(file, "contact.spin_to_roll.", -6.7e-19);
  const auto look = [&](bool rounding) {
    int seen = 0;
    const PlotDocument now = make_document(file);
    for (std::size_t p = 0; p < now.pages.size(); ++p)
      for (const auto& panel : now.build(static_cast<int>(p) + 1, {}).panels)
        if (panel.message.find("no spin") != std::string::npos) ++seen;
    CHECK((seen > 0) == rounding);
  };
  look(true);
  set(file, "contact.spin_to_roll.", 2e-4);
  look(false);
}

TEST_CASE("pages: rounding of a force fills no axis beside its large components",
          "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Race);
  set(file, "race.applied_force_x", 1e-7);
  set(file, "race.applied_force_y", 3.0);
  set(file, "race.applied_force_z", 5000.0);
  const desktop::ChartPage page = page_with(file, "forces");
  REQUIRE(page.panels.size() == 3);
  for (const auto& panel : page.panels) CHECK(panel.least_span == Approx(5e-4));
}

TEST_CASE("pages: lines of frequencies do not cross the words of an empty chart", "[gui]") {
  test::use_qt();
  results::SolFile file = test::synthetic_sol(SolKind::Race);
  set(file, "race.", 2e-6);
  desktop::ChartPage page = page_with(file, "spectrum");
  REQUIRE_FALSE(page.marks.empty());
  REQUIRE(page.panels.front().message.find("Nothing vibrates") == 0);
  const auto dashed = [](const desktop::ChartPage& shown) {
    desktop::ChartScene scene;
    scene.setPageSize({900, 600});
    scene.setPage(shown);
    int lines = 0;
    for (const QGraphicsItem* item : scene.items())
      if (const auto* line = qgraphicsitem_cast<const QGraphicsLineItem*>(item))
        lines += line->pen().style() == Qt::DashLine ? 1 : 0;
    return lines;
  };
  CHECK(dashed(page) == 0);
  page.panels.front().curves.front().y.assign(page.x.size(), 1.0);
  CHECK(dashed(page) > 0);
}

TEST_CASE("pages: the orbit of a cage without guide lands has no circle of clearance",
          "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Cage);
  for (const char* land : {"cage.land1_", "cage.land2_"}) set(file, land, 0.0);
  const desktop::ChartPage free = page_with(file, "orbit");
  CHECK(free.guide_radius == 0.0);
  CHECK(free.note.find("no guide land") != std::string::npos);
  set(file, "cage.land1_gap", 1e-4);
  const desktop::ChartPage guided = page_with(file, "orbit");
  CHECK(guided.guide_radius == 1.0);
  CHECK(guided.note.find("no guide land") == std::string::npos);
}
