#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"
#include "studies/what_if.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using runs::DeckRequest;
using scene::Effect;

namespace {

DeckRequest ball(std::vector<std::pair<std::string, std::string>> options = {}) {
  DeckRequest request;
  request.text = deck::write_deck(deck::new_deck("ball"));
  request.options = std::move(options);
  return request;
}

std::string refusal(const std::string& names) {
  try {
    (void)runs::prepare(ball({{"effectsOff", names}}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "was accepted";
}

const scene::EffectEntry& entry(const runs::Prepared& prepared, const std::string& name) {
  return *std::find_if(prepared.plan.effects.begin(), prepared.plan.effects.end(),
                       [&](const scene::EffectEntry& one) { return one.name == name; });
}

}  // namespace

TEST_CASE("effectsOff: names of the plan → effects are not built", "[unit][studies]") {
  const runs::Prepared whole = runs::prepare(ball());
  const runs::Prepared less = runs::prepare(
      ball({{"effectsOff", "gravity, momentum ledger,wear and power integrals,ball orientation"}}));
  CHECK(entry(whole, "gravity").on);
  CHECK_FALSE(entry(less, "gravity").on);
  CHECK(entry(less, "gravity").because.find("switched off by run option effectsOff") !=
        std::string::npos);
  CHECK_FALSE(less.plan.has(Effect::MomentumLedger));
  CHECK(less.plan.oriented_elements.empty());
  // Seven integrals of load and slip and their likes, six of momentum, five for each orientation.
  const dynamics::System with = runs::make_system(whole), without = runs::make_system(less);
  CHECK(with.layout().controlled_size() - without.layout().controlled_size() ==
        5 * static_cast<int>(whole.plan.oriented_elements.size()));
  CHECK(with.layout().size() - without.layout().size() >
        5 * static_cast<int>(whole.plan.oriented_elements.size()) + 6);
}

TEST_CASE("rollerSlices: few slices specified → no remark on few slices in contact",
          "[unit][studies]") {
  const auto said_of = [](const char* name, const char* slices) {
    DeckRequest request;
    request.text = deck::write_deck(deck::new_deck(name));
    request.options = {{"rollerSlices", slices}};
    std::string all;
    for (const Issue& note : runs::solution_notes(runs::prepare(request)))
      all += note.message + "\n";
    return all;
  };
  CHECK(said_of("tapered", "7").find("slices touch") == std::string::npos);
  CHECK(said_of("spherical", "31").find("fewer than 8 of 31 slices touch") != std::string::npos);
}

TEST_CASE("effectsOff: guide lands → their traction is off too", "[unit][studies]") {
  const runs::Prepared less = runs::prepare(ball({{"effectsOff", "cage / race guide lands"}}));
  CHECK_FALSE(less.plan.has(Effect::LandContact));
  CHECK_FALSE(less.plan.has(Effect::LandTraction));
}

TEST_CASE("effectsOff: effect that cannot be left out → error with its cause and the possible ones",
          "[unit][studies]") {
  CHECK(refusal("cage motion").find("nCseg = 1") != std::string::npos);
  CHECK(refusal("gravitation").find("momentum ledger") != std::string::npos);
  CHECK(refusal("gravitation").find("\"gravitation\"") != std::string::npos);
}

TEST_CASE("what-if: change and cost of each effect", "[physics][studies]") {
  studies::WhatIfRequest request;
  static_cast<DeckRequest&>(request) = ball();
  request.turns = 0.1;
  std::size_t told = 0;
  const studies::WhatIf result =
      studies::what_if(request, [&](const studies::WhatIfRow&) { ++told; }, {});
  CHECK(told == result.rows.size());
  CHECK(result.seconds > 0.0);
  const auto row = [&](const std::string& name) {
    const auto found =
        std::find_if(result.rows.begin(), result.rows.end(),
                     [&](const studies::WhatIfRow& one) { return one.effect == name; });
    REQUIRE(found != result.rows.end());
    return *found;
  };
  // Ledgers change nothing; without traction at the races nearly all of the heat is gone.
  const studies::WhatIfRow ledger = row("momentum ledger");
  CHECK(ledger.change.speed == 0.0);
  CHECK(ledger.change.load == 0.0);
  CHECK(ledger.change.heat == Approx(0.0).margin(1e-12));
  const studies::WhatIfRow traction = row("ball / race traction");
  CHECK(traction.change.heat < -0.5);
  CHECK(traction.share < 1.0);  // of processor time: how much is a matter of benchmarks
  // The millionth of the load that tells the noise changes loads by about as much.
  CHECK(std::abs(result.noise.load) < 1e-3);
  // The deck plots bodies that a bearing without a cage does not have.
  const studies::WhatIfRow cage = row("cage motion, ball / pocket contact");
  CHECK(cage.without == "nCseg=0");
  INFO(cage.failure);
  CHECK(cage.failure.empty());
  CHECK(cage.share < 1.0);
  CHECK(studies::what_if_text(result).find("relative load change 1e-6") != std::string::npos);
  const auto json = studies::what_if_json(result);
  CHECK(json.at("rows").size() == result.rows.size());
  request.sets.emplace_back("mode", "-1");
  CHECK_THROWS_AS(studies::what_if(request, {}, {}), InputError);
}

TEST_CASE("contactDamping: default, a number, 0 and modes in balance → reported in plan and notes",
          "[unit][studies][damping]") {
  const auto prepared = [](const std::string& value, const std::string& variable = "",
                           const std::string& set = "") {
    DeckRequest request = value.empty() ? ball() : ball({{"contactDamping", value}});
    if (!variable.empty()) request.sets.emplace_back(variable, set);
    if (variable == "nCseg")
      for (const auto& [name, one] : {std::pair{"kNumPltElem", "1"}, {"kPltElemInd", "1"}})
        request.sets.emplace_back(name, one);
    return runs::prepare(request);
  };
  const auto reason = [](const runs::Prepared& of) { return entry(of, "contact damping").because; };
  const auto notes = [](const runs::Prepared& of) {
    std::string out;
    for (const Issue& issue : of.input.warnings)
      if (issue.severity == Severity::Note) out += issue.message + "\n";
    return out;
  };
  const runs::Prepared usual = prepared("");
  CHECK(usual.plan.has(Effect::ContactDamping));
  CHECK_THAT(reason(usual), Catch::Contains("= material") &&
                                Catch::Contains("races: loss factor") &&
                                Catch::Contains("pockets") && !Catch::Contains("flanges") &&
                                !Catch::Contains("neighbors"));
  CHECK_THAT(notes(usual), !Catch::Contains("amping"));
  CHECK_THAT(reason(prepared("", "nCseg", "0")),
             !Catch::Contains("pockets") && Catch::Contains("neighbors"));
  CHECK_THAT(reason(prepared("0.2")), Catch::Contains("= 0.2 (in s/m)"));
  const runs::Prepared elastic = prepared("0");
  CHECK_FALSE(elastic.plan.has(Effect::ContactDamping));
  CHECK_THAT(reason(elastic), Catch::Contains("do not decay"));
  CHECK_THAT(notes(elastic), Catch::Contains("contact damping is off"));
  // The option is in s/m whatever the units of the deck are.
  DeckRequest english = ball({{"contactDamping", "0.2"}});
  english.text = deck::write_deck(deck::new_deck("ball-english"));
  CHECK(reason(runs::prepare(english)).find("= 0.2 (in s/m)") != std::string::npos);
  for (const char* value : {"-0.1", "101", "nan", "much", ""}) {
    DeckRequest request = ball({{"contactDamping", value}});
    CHECK_THROWS_WITH(runs::prepare(request), Catch::Contains("contactDamping"));
  }
  // Elements in balance: no part on the races; the run goes on.
  for (const char* mode : {"1", "2"}) {
    CHECK_THAT(reason(prepared("", "mode", mode)),
               Catch::Contains("no damping at the races") && Catch::Contains("pockets"));
    CHECK_THAT(notes(prepared("0.2", "mode", mode)), Catch::Contains("no effect at the races"));
  }
  CHECK_THAT(reason(prepared("0.2", "qFac", "0.05")), Catch::Contains("qFac = 0.05"));
}
