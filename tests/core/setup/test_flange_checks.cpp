#include "deck/templates.hpp"
#include "setup/build_bearing.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

using namespace adore;

namespace {

/// Warnings that name the variable.
std::vector<std::string> warnings_of(const deck::Deck& deck, const std::string& variable) {
  std::vector<std::string> out;
  for (const Issue& issue : setup::check_buildable(deck))
    if (issue.severity == Severity::Warning && issue.variable == variable)
      out.push_back(issue.message);
  return out;
}

}  // namespace

TEST_CASE("flanges: no roller end meets them, no clearance or no guidance → reported",
          "[unit][flanges]") {
  for (const char* type : {"cylindrical", "tapered", "spherical-tapered"})
    for (const char* race : {"1", "2"}) {
      deck::Deck deck = deck::new_deck(type);
      const std::string play = std::string("flngCls") + race;
      REQUIRE(deck.has("kFlngInd11"));
      for (const char* side : {"1", "2"}) {
        deck.set(std::string("kFlngInd") + side + race, "1");
        if (deck.has("bReCorRad1")) deck.set(std::string("bReCorRad") + side, "0.0006");
        deck.set(std::string("flngHt") + side + race, "0.0015");
      }
      deck.set(play, "5e-5");
      deck.complete();
      INFO(type << ", race " << race);
      CHECK(warnings_of(deck, play).empty());
      for (const char* side : {"1", "2"}) {
        const std::string height = std::string("flngHt") + side + race;
        CHECK(warnings_of(deck, height).empty());
        deck::Deck low = deck;
        low.set(height, deck.has("bReCorRad1") ? "0.0005" : "0");
        CHECK(warnings_of(low, height).size() == 1);
      }
      for (const auto& [value, words] :
           {std::pair{"-1e-5", "is negative"}, std::pair{"0.01", "roller length"}}) {
        deck::Deck other = deck;
        other.set(play, value);
        const std::vector<std::string> said = warnings_of(other, play);
        REQUIRE(said.size() == 1);
        CHECK_THAT(said[0], Catch::Contains(words));
      }
      // Where one flange is missing the play has no part.
      deck.set(std::string("kFlngInd1") + race, "0");
      deck.set(play, "0.01");
      CHECK(warnings_of(deck, play).empty());
    }
}

TEST_CASE("rotating load: more than the whole deflection → warning", "[unit][flanges]") {
  for (const char* race : {"1", "2"}) {
    deck::Deck deck = deck::new_deck("cylindrical");
    deck.set("kVarLoad", "1");
    deck.complete();
    const std::string share = std::string("rotLoadFrac") + race;
    for (const auto& [value, told] :
         {std::pair{"0", 0}, std::pair{"1", 0}, std::pair{"-1", 0}, std::pair{"1e6", 1}}) {
      deck.set(share, value);
      INFO(share << " = " << value);
      CHECK(static_cast<int>(warnings_of(deck, share).size()) == told);
    }
  }
}
