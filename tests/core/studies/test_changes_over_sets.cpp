#include "core/runs/deck_runs.hpp"
#include "deck/schema.hpp"
#include "deck/templates.hpp"
#include "studies/accuracy.hpp"
#include "studies/chosen_settings.hpp"
#include "studies/verify.hpp"
#include "studies/what_if.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

// Studies and verification run the user's deck with other values of some variables. Whoever gave
// such a variable by --set got "is set twice" in the place of a figure, or no reference at all.

using namespace adore;
using namespace adore::runs;
using namespace adore::studies;

namespace {

/// Every single number of an example deck as --set NAME=VALUE, with the value that it has: whatever
/// a study changes, it has been set before.
DeckRequest all_set(const char* example) {
  const deck::Deck deck = deck::new_deck(example);
  DeckRequest out;
  out.text = deck::write_deck(deck);
  for (const deck::RecordData& record : deck.records) {
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 1; v < record.values.size(); ++v) {
      if (spec.variables[v].length != "1" || record.values[v].size() != 1) continue;
      std::string name(spec.variables[v].name);
      if (!spec.repeat.empty()) name += fmt::format("[{}]", record.instance);
      const deck::Value& value = record.values[v].front();
      if (const auto* whole = std::get_if<long long>(&value))
        out.sets.emplace_back(name, fmt::format("{}", *whole));
      else if (const auto* real = std::get_if<double>(&value))
        out.sets.emplace_back(name, fmt::format("{:.17g}", *real));
    }
  }
  return out;
}

constexpr const char* kTypes[] = {"ball", "cylindrical", "tapered", "spherical",
                                  "spherical-tapered"};

}  // namespace

TEST_CASE("verify: every variable set on the command line → same run repeated",
          "[unit][accuracy]") {
  for (const char* example : kTypes) {
    CAPTURE(example);
    RunRequest request;
    static_cast<DeckRequest&>(request) = all_set(example);
    REQUIRE(request.sets.size() > 100);
    request.until = "0.002rev";
    const testing::TemporaryFolder folder;
    request.out = folder / "run";
    const RunOutcome outcome = run(request);
    REQUIRE(outcome.status == RunStatus::Done);
    const Verification verified = verify(request, outcome, {});
    CHECK(verified.failure.empty());
    CHECK(value_of(verified.results, "time_s") == Approx(outcome.time).epsilon(1e-12));
  }
}

TEST_CASE("what-if: every variable set on the command line → each effect left out",
          "[physics][studies][slow]") {
  for (const char* example : {"ball", "cylindrical"})
    for (const char* mode : {"0", "1"}) {
      CAPTURE(example, mode);
      WhatIfRequest request;
      static_cast<DeckRequest&>(request) = all_set(example);
      for (auto& [name, value] : request.sets)
        if (name == "mode") value = mode;
      request.turns = 0.002;
      const WhatIf result = what_if(request, {}, {});
      CHECK(result.rows.size() > 3);
      for (const WhatIfRow& row : result.rows) {
        CAPTURE(row.effect);
        CHECK(row.failure.find("set twice") == std::string::npos);
        CHECK(row.failure.find("does not have the record") == std::string::npos);
      }
    }
}

TEST_CASE("study: every variable set on the command line → same as the deck", "[unit][accuracy]") {
  AccuracyRequest request;
  request.text = all_set("ball").text;
  request.methods = {"rkf5", "rk4", "rkf5"};
  request.tolerances = {1e-5, 1e-5};
  request.turns = 0.02;
  request.budget = 20.0;
  const AccuracyStudy plain = study_accuracy(request);
  request.sets = all_set("ball").sets;
  const AccuracyStudy set = study_accuracy(request);
  CHECK(plain.screening.size() == 5);  // the deck's own and two methods, twice; none listed twice
  REQUIRE(set.screening.size() == plain.screening.size());
  CHECK(plain.irregular.speed >= 0.0);
  CHECK(set.irregular.speed >= 0.0);  // of the cheapest good row, which may be another one
  int compared = 0;
  for (const auto rows : {&AccuracyStudy::screening, &AccuracyStudy::models}) {
    REQUIRE((set.*rows).size() == (plain.*rows).size());
    for (std::size_t k = 0; k < (set.*rows).size(); ++k) {
      const AccuracyRow &one = (set.*rows)[k], &other = (plain.*rows)[k];
      CAPTURE(one.setting.name, one.failure);
      CHECK(one.setting.name == other.setting.name);
      // Rows that take long are cut by processor time, which is another one each time.
      if (!one.failure.empty() || !other.failure.empty()) continue;
      ++compared;
      CHECK(one.steps == other.steps);
      CHECK(one.errors.heat == other.errors.heat);
    }
  }
  CHECK(compared >= 5);
}

TEST_CASE("chosen settings: every variable set on the command line → settings chosen",
          "[physics][accuracy][slow]") {
  const DeckRequest request = all_set("ball");
  const ChosenSettings chosen = choose_settings(request, 0.05, {});
  CHECK_FALSE(chosen.integrator.empty());
  CHECK(chosen.noise.speed >= 0.0);
  for (const ResolutionRow& row : chosen.rows) CHECK(row.failure.empty());
}
