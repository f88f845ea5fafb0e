#include "deck/element_names.hpp"
#include "deck/monitored_bodies.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace adore;
using namespace adore::deck;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

std::vector<std::string> names_of(const Deck& deck) {
  std::vector<std::string> out;
  for (const long long number : monitored_bodies(deck)) out.push_back(body_name(deck, number));
  return out;
}

/// Monitors the first and the last element, what there is of a cage, and both races.
Deck watched(std::string_view type) {
  Deck deck = new_deck(type);
  const long long elements = deck.integer("nRe"), segments = deck.integer("nCseg");
  std::vector<long long> bodies{1, elements};
  if (segments > 0) bodies.push_back(elements + 1);
  bodies.push_back(elements + segments + 1);
  bodies.push_back(elements + segments + 2);
  set_monitored_bodies(deck, bodies);
  return deck;
}

bool said(const std::vector<Issue>& notes, const std::string& words) {
  return std::any_of(notes.begin(), notes.end(), [&](const Issue& issue) {
    return issue.message.find(words) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("set_all_and_renumber(): changed counts → same monitored bodies, with a note",
          "[unit][deck]") {
  int decks = 0;
  for (const TemplateInfo& info : templates()) {
    if (!new_deck(info.name).has_record("3.4")) continue;  // nothing moves in it
    ++decks;
    for (const char* variable : {"nRe", "nCseg"})
      for (const int change : {-2, -1, 1, 4}) {
        const Deck before = watched(info.name);
        const long long count = before.integer(variable) + change;
        if (count < 0) continue;
        INFO(info.name << ": " << variable << " = " << count);
        Deck deck = before;
        const std::vector<Issue> notes =
            set_all_and_renumber(deck, Sets{{variable, fmt::format("{}", count)}});
        const std::vector<std::string> names = names_of(deck);
        REQUIRE(names.size() >= 4);
        CHECK(names.front() == "rolling element 1");
        CHECK(names[1] == fmt::format("rolling element {}",
                                      std::min(before.integer("nRe"), deck.integer("nRe"))));
        CHECK(names[names.size() - 2] == "outer race");
        CHECK(names.back() == "inner race");
        CHECK(static_cast<long long>(names.size()) == deck.integer("kNumPltElem"));
        CHECK(said(notes, "the same bodies are monitored under new numbers"));
        CHECK(said(notes, fmt::format("{}", fmt::join(monitored_bodies(deck), ", "))));
        CHECK(said(notes, "the cage no longer exists") ==
              (before.integer("nCseg") > 0 && deck.integer("nCseg") == 0));
      }
  }
  CHECK(decks >= 5);
}

TEST_CASE("set_all_and_renumber(): monitored bodies set with the counts → those that were set",
          "[unit][deck]") {
  Deck deck = watched("ball");
  const long long count = deck.integer("nRe") + 2;
  CHECK(set_all_and_renumber(
            deck,
            Sets{{"nRe", fmt::format("{}", count)}, {"kNumPltElem", "2"}, {"kPltElemInd", "2,3"}})
            .empty());
  CHECK(monitored_bodies(deck) == std::vector<long long>{2, 3});
  // What is set is no count: nothing to follow, nothing to say.
  CHECK(set_all_and_renumber(deck, Sets{{"appLoadZ", "1200"}}).empty());
}

TEST_CASE("set_all_and_renumber(): invalid number → all others still follow", "[unit][deck]") {
  Deck deck = new_deck("ball");
  const long long elements = deck.integer("nRe"), bodies = elements + deck.integer("nCseg") + 2;
  set_monitored_bodies(deck, {1, bodies - 1, bodies + 1});
  const Deck before = deck;
  deck.set("nRe", fmt::format("{}", elements + 1));
  deck.complete();
  const std::vector<Issue> notes = renumber_monitored_bodies(deck, before);
  CHECK(body_name(deck, monitored_bodies(deck)[1]) == "outer race");
  CHECK(said(notes,
             fmt::format("{} was not a body number before the change; it is now the number of the "
                         "inner race",
                         bodies + 1)));
  // A count that is none says nothing of bodies.
  Deck none = before;
  none.set("nRe", "0");
  CHECK(renumber_monitored_bodies(none, before).empty());
  CHECK(monitored_bodies(none) == monitored_bodies(before));
}
