#include "deck/templates.hpp"
#include "runs/prepare.hpp"
#include "runs/ring_growth.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;

namespace {

runs::Prepared ramp(const char* growth) {
  runs::LoadedDeck input;
  input.deck = deck::new_deck("ball");
  for (const auto& [name, value] : {std::pair{"kVarSpeed", "1"}, {"rpm2", "1000"}})
    input.deck.set(name, value);
  input.deck.complete();
  for (const auto& [name, value] :
       {std::pair{"raceAngAcc2", "300000"}, {"startTime2", "0"}, {"endTime2", "0.05"}})
    input.deck.set(name, value);
  input.option_values["centrifugalGrowth"] = growth;
  return runs::prepare(std::move(input));
}

double clearance(bearing::Bearing as_built, double speed) {
  as_built.speed[1] = speed;
  return thermal::operating_bearing(as_built).operating->operating.clearance;
}

}  // namespace

TEST_CASE("ring growth: levels follow the speed within half a step of the clearance",
          "[unit][thermal]") {
  const runs::Prepared prepared = ramp("1");
  const runs::RingGrowth growth(prepared), finer(prepared, 0.5 * runs::kGrowthShare);
  REQUIRE(growth.active());
  const double start = prepared.as_built.speed[1];
  CHECK(growth.levels({0.0, start}) == runs::RingGrowth::Levels{});
  const double step = runs::kGrowthShare * prepared.start.max_deflection;
  for (const double factor : {2.0, 5.0, 10.0, 16.0}) {
    INFO(factor);
    const double speed = factor * start, exact = clearance(prepared.as_built, speed);
    for (const runs::RingGrowth* one : {&growth, &finer}) {
      const double at = one->speeds(one->levels({0.0, speed}), {0.0, speed})[1];
      const double share = one == &growth ? 1.0 : 0.5;
      CHECK(std::abs(clearance(prepared.as_built, at) - exact) <= 0.51 * share * step);
    }
  }
  CHECK(growth.levels({0.0, 16.0 * start})[1] != 0);
}

TEST_CASE("ring growth: constant speeds or growth switched off -> no levels", "[unit][thermal]") {
  CHECK_FALSE(runs::RingGrowth(ramp("0")).active());
  runs::LoadedDeck input;
  input.deck = deck::new_deck("ball");
  CHECK_FALSE(runs::RingGrowth(runs::prepare(std::move(input))).active());
}
