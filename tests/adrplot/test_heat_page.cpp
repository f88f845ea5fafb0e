#include "desktop/heat_page.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace adore;
namespace unit = results::unit;

namespace {

results::StaticTables network(results::UnitSystem units) {
  results::StaticTable table{"thermal network", {}};
  for (const auto& [name, T] : {std::pair{"coolant inlet", 320.0},
                                {"coolant mean", 322.0},
                                {"coolant exit", 324.0},
                                {"rolling elements", 330.0},
                                {"outer raceway", 330.0},
                                {"outer race at the housing", 328.0},
                                {"housing outside", 325.0},
                                {"inner raceway", 330.0},
                                {"inner race at the shaft", 327.0},
                                {"shaft inside", 321.0}})
    table.add(name, unit::kTemperature, {T});
  table.add("rolling elements to coolant mean", unit::kPower, {70.0});
  table.add("outer raceway to outer race at the housing", unit::kPower, {30.0});
  table.add("inner raceway to inner race at the shaft", unit::kPower, {40.0});
  table.add("made at the outer race", unit::kPower, {60.0});
  table.add("made in the pockets", unit::kPower, {0.0});
  table.add("mean of the outer race", unit::kTemperature, {329.0});
  results::StaticTables out{"heat", "ball", units, {}};
  out.tables.push_back(std::move(table));
  return out;
}

bool says(const desktop::ChartPage& page, const std::string& text) {
  return std::any_of(page.labels.begin(), page.labels.end(),
                     [&](const desktop::ChartLabel& label) { return label.text == text; });
}

}  // namespace

TEST_CASE("the picture of the network has each node with its temperature, each flow with its heat",
          "[unit][plots]") {
  CHECK_FALSE(desktop::heat_page({"none", "ball", results::UnitSystem::SI, {}}));
  const auto page = desktop::heat_page(network(results::UnitSystem::SI));
  REQUIRE(page);
  CHECK(page->equal_axes);
  CHECK(says(*page, "rolling elements 330 K"));
  CHECK(says(*page, "coolant exit 324 K"));
  CHECK(says(*page, "70 W"));
  CHECK(says(*page, "heat generated at the outer race: 60 W"));
  CHECK(says(*page, "mean temperature of the outer race: 329 K"));
  CHECK_FALSE(says(*page, "heat generated in the pockets: 0 W"));
  REQUIRE(page->panels.size() == 1);
  for (const desktop::ChartCurve& curve : page->panels[0].curves)
    CHECK(curve.x.size() == curve.y.size());
  // Ten squares of six entries each, the last of them a gap; no cage, so none for it.
  CHECK(page->panels[0].curves[0].x.size() == 60);
  // Three flows in the order of the table: a line from square to square, and a head of two strokes
  // that points where the heat goes: from the elements to the coolant, outward from the outer
  // raceway, and against it when the sign turns.
  const auto head_of = [](const desktop::ChartPage& of, std::size_t flow) {  // tip of its head
    const desktop::ChartCurve& flows = of.panels[0].curves[1];
    REQUIRE(flows.x.size() == 3 * 7);
    return std::pair{flows.x[7 * flow + 4], flows.y[7 * flow + 4]};
  };
  CHECK(head_of(*page, 0).first == Approx(5.2 - 0.12));
  CHECK(head_of(*page, 0).second == Approx(3.0));
  CHECK(head_of(*page, 1).first == Approx(0.0));
  CHECK(head_of(*page, 1).second == Approx(5.0 - 0.12));
  results::StaticTables turned = network(results::UnitSystem::SI);
  for (results::StaticColumn& column : turned.tables[0].columns)
    if (column.name == "outer raceway to outer race at the housing") column.values = {-30.0};
  const auto inward = desktop::heat_page(turned);
  REQUIRE(inward);
  CHECK(head_of(*inward, 1).second == Approx(4.0 + 0.12));
  CHECK(says(*inward, "30 W"));
  const auto english = desktop::heat_page(network(results::UnitSystem::English));
  REQUIRE(english);
  CHECK(says(*english, "rolling elements 594 R"));
}
