#pragma once

#include "deck/deck.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

/// Which bodies are monitored when their count changes.
///
/// kPltElemInd numbers them through: elements 1 to nRe, nCseg cage segments, outer race, inner
/// race. With another nRe or nCseg the same number is another body, so numbers follow the bodies.
namespace adore::deck {

/// Do two decks number their bodies alike? Also true when one has a count that is none.
[[nodiscard]] bool have_same_body_numbers(const Deck& a, const Deck& b);

/// Numbers in kPltElemInd; empty when one is missing.
[[nodiscard]] std::vector<long long> monitored_bodies(const Deck& deck);
/// Sets kPltElemInd and kNumPltElem; nothing where the deck has no such record.
void set_monitored_bodies(Deck& deck, const std::vector<long long>& bodies);

/// kPltElemInd of `deck`, which has the numbers of `before`, becomes the numbers of the same
/// bodies. An element or segment that no longer exists is replaced by the last one that is not
/// monitored, or left out if there is none. Returns notes on changes: bodies
/// left out, and numbers that had no body and now have one.
std::vector<Issue> renumber_monitored_bodies(Deck& deck, const Deck& before);

/// Deck::set_all(), where monitored bodies stay the same unless `sets` names them; notes list
/// their new numbers. @throws InputError as set_all()
std::vector<Issue> set_all_and_renumber(Deck& deck,
                                        std::span<const std::pair<std::string, std::string>> sets);

}  // namespace adore::deck
