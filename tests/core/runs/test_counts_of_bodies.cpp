#include "deck/element_names.hpp"
#include "deck/monitored_bodies.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

using namespace adore;

TEST_CASE("monitored bodies: count changed on the command line → same bodies, with a note",
          "[unit][runs]") {
  int decks = 0;
  for (const deck::TemplateInfo& info : deck::templates()) {
    const deck::Deck before = deck::new_deck(info.name);
    if (deck::monitored_bodies(before).empty()) continue;  // nothing moves in it
    ++decks;
    runs::DeckRequest request;
    request.text = std::string(deck::template_text(info.name));
    request.in_memory = true;
    const auto loaded = [&](const std::string& name, const std::string& value) {
      request.sets = {{name, value}};
      return runs::load_deck(request);
    };
    INFO(info.name);
    const runs::LoadedDeck more = loaded("nRe", fmt::format("{}", before.integer("nRe") + 1));
    const std::vector<long long> were = deck::monitored_bodies(before);
    const std::vector<long long> are = deck::monitored_bodies(more.deck);
    REQUIRE(were.size() == are.size());
    for (std::size_t k = 0; k < were.size(); ++k)
      CHECK(deck::body_name(before, were[k]) == deck::body_name(more.deck, are[k]));
    const auto notes = [](const runs::LoadedDeck& of) {
      return std::count_if(of.warnings.begin(), of.warnings.end(), [](const Issue& issue) {
        return issue.message.find("the same bodies are monitored") != std::string::npos;
      });
    };
    CHECK(notes(more) == (were == are ? 0 : 1));
    CHECK(notes(loaded("appLoadZ", "1234")) == 0);
  }
  CHECK(decks >= 5);
}
