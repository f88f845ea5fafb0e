#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

/// What the nodes of the contact integrals leave of the heat is measured at the end of each run,
/// and said where it matters.
using namespace adore;
using testing::TemporaryFolder;

namespace {

using Options = std::map<std::string, std::string>;

struct Told {
  double off = 0.0;  ///< of the heat of the races, by RUN.json
  bool warned = false;
  std::string print;
};

Told run_with(deck::Deck deck, const Options& options) {
  const TemporaryFolder folder;
  runs::RunRequest request;
  request.text = deck::write_deck(deck);
  request.options.assign(options.begin(), options.end());
  request.out = folder / "run";
  request.until = "0.01rev";
  const runs::RunOutcome outcome = runs::run(request);
  REQUIRE(outcome.status == runs::RunStatus::Done);
  const nlohmann::json report =
      nlohmann::json::parse(testing::read_bytes(folder / "run/RUN.json")).at("conservation");
  Told told;
  told.off = report.at("race heat by the run's rule, W").get<double>() /
                 report.at("race heat by twice the nodes, W").get<double>() -
             1.0;
  told.warned = std::any_of(outcome.warnings.begin(), outcome.warnings.end(), [](const Issue& w) {
    return w.severity == Severity::Warning &&
           w.message.find("the contact integrals have too few nodes: the heat") !=
               std::string::npos;
  });
  told.print = testing::read_bytes(folder / "run/PRINT.txt");
  return told;
}

}  // namespace

TEST_CASE("Nodes of the examples: heat of the races is accurate, with and without oil", "[runs]") {
  for (const deck::TemplateInfo& example : deck::templates()) {
    deck::Deck deck = deck::new_deck(example.name);
    if (deck.integer("mode") < 0 || deck.integer("kBrg") != 1) continue;
    CAPTURE(example.name);
    const Told told = run_with(deck, {});
    // Four contacts of one ball spin more than two.
    CHECK(std::abs(told.off) <
          (std::string_view(example.name) == "four-point-qj208" ? 0.05 : 0.03));
    CHECK_FALSE(told.warned);
  }
}

TEST_CASE("Nodes that do not resolve a film of variable pressure → warning", "[runs]") {
  deck::Deck deck = deck::new_deck("ball");
  deck.set("kTrac", "1");
  deck.complete();
  deck.set("strParam", "10.0");
  const Told usual = run_with(deck, {});
  CAPTURE(usual.off);
  CHECK(std::abs(usual.off) < 0.02);  // decision 328
  CHECK_FALSE(usual.warned);
  // 15 x 4 follow the pressure of the classic law; the limiting stress gives its stress a shoulder
  // at each end of the width, which needs more nodes (1.5 % off with 4, 0.4 % with 8).
  const Options classic{{"ellipseMinor", "4"}, {"filmStressLimit", "off"}};
  CHECK(std::abs(run_with(deck, classic).off) < 0.01);
  CHECK(std::abs(run_with(deck, {{"ellipseMinor", "8"}}).off) < 0.01);
  CHECK(usual.print.find("contact integrals / heat of the races") != std::string::npos);
  // One node across is 67 % off, two 9 %.
  for (const char* few : {"1", "2"}) {
    const Told told = run_with(deck, {{"ellipseMinor", few}});
    CAPTURE(few, told.off);
    CHECK(std::abs(told.off) > 0.05);
    CHECK(told.warned);
  }
}
