#include "adrinput/document.hpp"
#include "deck/unit_change.hpp"

/// What becomes of the numbers when kUnit changes.
namespace adore::adrinput {

/// Called after an edit: whether it was the one that changed the units.
void Document::note_units(deck::UnitSystem before) {
  const deck::UnitSystem now = state_.deck.units();
  const bool back = numbers_in_ == now;
  numbers_in_.reset();
  if (now != before && !back) numbers_in_ = before;
}

void Document::keep_numbers() {
  numbers_in_.reset();
  notify();
}

/// Also what is on the shelf, for the day when its record applies again.
void Document::convert_values() {
  if (!numbers_in_) return;
  const deck::UnitSystem from = *numbers_in_, to = state_.deck.units();
  deck::Deck ever;
  for (const auto& [place, record] : state_.shelf) ever.records.push_back(record);
  for (auto& [place, record] : state_.shelf)
    deck::convert_values(record, state_.deck.has_record(record.id) ? state_.deck : ever, from, to);
  const deck::Deck before = state_.deck;
  for (deck::RecordData& record : state_.deck.records)
    deck::convert_values(record, before, from, to);
  settle();
  numbers_in_.reset();
  redo_.clear();
  find_problems();
  notify();
}

}  // namespace adore::adrinput
