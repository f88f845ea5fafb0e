#include "deck/deck.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/difference.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"

#include <catch2/catch.hpp>

/// Records X: given or not, with and without units, as text and back.

using namespace adore;
using namespace adore::deck;

TEST_CASE("records X: a deck has them only if they are given", "[unit][deck]") {
  Deck deck = new_deck("ball");
  const std::string before = write_deck(deck);
  CHECK_FALSE(deck.has("ratingC"));
  deck.set("ratingC", "55300");
  deck.set("oilGrade", "68");
  deck.complete();
  CHECK(deck.real("ratingC") == 55300.0);
  CHECK(deck.integer("oilGrade") == 68);
  CHECK_FALSE(deck.has("ratingC0"));    // of the same record
  CHECK(check_deck(deck).size() == 1);  // the oil acts only on ISO 281
  const std::string text = write_deck(deck);
  CHECK(text.starts_with(before));
  const ReadResult back = read_deck_text(text, "x");
  CHECK(back.deck == deck);
  CHECK(write_deck(back.deck) == text);
  // Taken back, the text is that of the deck without them.
  deck.set("ratingC", "");
  deck.set("oilGrade", "");
  CHECK_FALSE(deck.has("ratingC"));
  CHECK(write_deck(deck) == before);
  CHECK(differences(deck, new_deck("ball")).empty());
}

TEST_CASE("records X: units, ranges and one value for all parts", "[unit][deck]") {
  Deck deck = new_deck("ball");
  deck.set("ratingC", "55.3 kN");
  CHECK(deck.real("ratingC") == Approx(55300.0).epsilon(1e-15));
  deck.set("oilVisc1", "120 mm2/s");
  CHECK(deck.si("oilVisc1") == Approx(120e-6).epsilon(1e-15));
  deck.set("oilTemp1", "40 °C");
  CHECK(deck.si("oilTemp1") == Approx(313.15));
  deck.set("matEM", "206 GPa");
  for (int part = 1; part <= 3; ++part) CHECK(deck.si("matEM", 1, part) == Approx(206e9));
  deck.set("matEM[2]", "");
  CHECK(std::holds_alternative<std::monostate>(*find_value(deck, "matEM", 1, 2)));
  CHECK_THROWS_AS(deck.set("ratingC", "55 mm"), InputError);
  CHECK_THROWS_AS(deck.set("ratingC", "much"), InputError);
  CHECK_THROWS_AS(deck.set("matEM", "1,2"), InputError);
  deck.set("ratingC", "-1");
  const std::vector<Issue> issues = check_deck(deck);
  CHECK(std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
    return issue.variable == "ratingC" && issue.severity == Severity::Error;
  }));
  const Deck english = in_units(new_deck("ball"), UnitSystem::English);
  Deck other = english;
  other.set("ratingC", "55.3 kN");
  CHECK(other.si("ratingC") == Approx(55300.0).epsilon(1e-12));
  CHECK(in_units(other, UnitSystem::SI).real("ratingC") == Approx(55300.0).epsilon(1e-12));
}

TEST_CASE("records X: kept when options change, before the lines of user routines",
          "[unit][deck]") {
  const std::string text =
      write_deck(new_deck("ball")) + "'Rec X3', 3*2.06e11 /\n'X1', 5e4 /\n1.0, 2.0\n";
  ReadResult read = read_deck_text(text, "x");
  CHECK(read.ok());
  CHECK(read.deck.real("ratingC") == 5e4);
  CHECK(read.deck.user_lines == std::vector<std::string>{"1.0, 2.0"});
  read.deck.set_all(std::vector<std::pair<std::string, std::string>>{{"mode", "-1"}});
  CHECK(read.deck.real("matEM", 1, 3) == 2.06e11);
  CHECK(read.deck.records.back().id == "X3");
  const DeckTextWithComments kept = with_deck(text, read.deck);
  CHECK(read_deck_text(kept.text, "x").deck == read.deck);
  CHECK_FALSE(read_deck_text(text + "'X1', 1e4 /\n", "x").deck.user_lines.empty());
  CHECK_FALSE(
      read_deck_text(write_deck(new_deck("ball")) + "'X1', 1e4 /\n'X1', 2e4 /\n", "x").ok());
}
