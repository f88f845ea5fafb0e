#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/channels.hpp"
#include "results/h5_reader.hpp"
#include "studies/cage_whirl.hpp"
#include "studies/quantities.hpp"
#include "studies/quantity_check.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// What a study cannot have is known from the deck, before a run: for every key result and channel.
using namespace adore;
using namespace adore::studies;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

Quantity result(std::string_view name) {
  Quantity out;
  out.name = name;
  return out;
}

Quantity channel(std::string_view id) {
  Quantity out = result(id);
  out.channel = id;
  return out;
}

}  // namespace

TEST_CASE("quantity_check: the deck shows which quantities its runs lack",
          "[validation][studies]") {
  const Sets moves{{"maxStps", "5"},  {"nStps", "1"},     {"kPltFreq", "1"},   {"kAGraf", "0"},
                   {"kPrtFreq", "0"}, {"kLifeFreq", "1"}, {"kNumPltElem", "0"}};
  const auto with = [](Sets base, const Sets& more) {
    for (const auto& [name, value] : more) {
      std::erase_if(base, [&](const auto& set) { return set.first == name; });
      base.emplace_back(name, value);
    }
    return base;
  };
  const std::vector<std::pair<const char*, Sets>> scenes{
      {"quasi-static", {{"mode", "-1"}}},
      {"motion", moves},
      {"without a cage", with(moves, {{"nCseg", "0"}})},
      {"without a step", with(moves, {{"maxStps", "0"}})}};
  for (const char* type : {"ball", "cylindrical", "tapered"})
    for (const auto& [name, sets] : scenes) {
      INFO(type << ", " << name);
      deck::Deck deck = deck::new_deck(type);
      deck.set_all(sets);
      const testing::TemporaryFolder folder;
      const testing::Ran ran = testing::run_deck(deck, folder / "run");
      const bool motion = deck.integer("mode") >= 0, cage = deck.integer("nCseg") > 0;
      const bool steps = deck.integer("maxStps") > 0;
      int missing = 0;
      for (const results::KeyResultSpec& spec : results::key_result_specs()) {
        INFO(spec.id);
        const auto& had = ran.outcome.summary;
        const bool has = std::any_of(had.begin(), had.end(),
                                     [&](const auto& one) { return one.of.id == spec.id; });
        const std::string why = missing_quantity_reason(result(spec.id), deck, "");
        if (has) CHECK(why.empty());
        missing += why.empty() ? 0 : 1;
        // Where scenes differ the deck knows it, the other way round, too.
        if (!has && spec.id.starts_with("stiffness_")) CHECK(why.find("mode") != std::string::npos);
        if (!has && spec.id.starts_with("mean_")) CHECK_FALSE(why.empty());
        if (spec.id == "mean_cage_ratio")
          CHECK((why.find("no cage (nCseg = 0)") != std::string::npos) == (motion && !cage));
        if (spec.id == "mean_load_x_N")
          CHECK((why.find("maxStps is 0") != std::string::npos) == (motion && !steps));
        // The study's own end makes steps.
        if (spec.id == "mean_load_x_N")
          CHECK(missing_quantity_reason(result(spec.id), deck, "1rev").empty() == motion);
      }
      CHECK(missing > 0);
      for (const std::string_view figure : kWhirlFigures)
        CHECK(missing_quantity_reason(result(figure), deck, "").empty() == (motion && cage));
      if (!motion) {
        CHECK_FALSE(missing_quantity_reason(channel("contact.load"), deck, "").empty());
        continue;
      }
      const results::H5Reader reader(folder / "run/RESULTS.h5");
      for (const results::Channel& one : results::channels()) {
        INFO(one.id);
        const bool has = reader.find(one.id) != nullptr;
        CHECK(missing_quantity_reason(channel(one.id), deck, "").empty() == has);
      }
    }
}

TEST_CASE("study: unknown key result → error with the nearest ones", "[unit][studies]") {
  deck::Deck deck = deck::new_deck("ball");
  deck.set("nCseg", "0");
  deck.complete();
  const std::string said = missing_quantities_message(
      {result("mean_cage_ratio"), result("power_loss_W"), channel("land.force")}, deck, "");
  CHECK(said.find("mean_cage_ratio: the bearing has no cage (nCseg = 0); land.force:") == 0);
  CHECK(said.find("possible key results are life_lp_hours, run_life_hours, run_life_samples, ") !=
        std::string::npos);
  CHECK(said.find("mean_whirl_ratio") == std::string::npos);
  CHECK(missing_quantities_message({result("power_loss_W")}, deck, "").empty());
}
