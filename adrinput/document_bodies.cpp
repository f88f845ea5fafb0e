#include "adrinput/document.hpp"
#include "deck/element_names.hpp"
#include "deck/monitored_bodies.hpp"

#include <algorithm>

namespace adore::adrinput {

/// Monitored bodies are kept when their count changes. When a count returns, so do the bodies
/// chosen for it.
void Document::renumber_monitored_bodies(const deck::Deck& before) {
  if (deck::have_same_body_numbers(state_.deck, before)) return;
  const auto counts = [](const deck::Deck& deck) {
    return std::pair(deck.integer("nRe"), deck.integer("nCseg"));
  };
  const std::vector<long long> monitored = deck::monitored_bodies(state_.deck);
  const bool right =
      !monitored.empty() && std::all_of(monitored.begin(), monitored.end(), [&](long long number) {
        return !deck::body_name(before, number).empty();
      });
  if (!right || state_.followed != monitored) state_.monitored_with.clear();  // chosen anew since
  if (right) state_.monitored_with[counts(before)] = monitored;
  const auto known = state_.monitored_with.find(counts(state_.deck));
  if (known != state_.monitored_with.end()) {
    deck::set_monitored_bodies(state_.deck, known->second);
  } else {
    for (Issue& issue : deck::renumber_monitored_bodies(state_.deck, before))
      change_issues_.push_back(std::move(issue));
  }
  state_.followed = deck::monitored_bodies(state_.deck);
  complete_records();
}

}  // namespace adore::adrinput
