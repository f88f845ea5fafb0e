#include "adrinput/document.hpp"
#include "deck/unit_change.hpp"

#include <algorithm>

/// What becomes of the numbers when kUnit changes.
namespace adore::adrinput {

/// Called after an edit: whether it was the one that changed the units, or changed them back.
void Document::note_units(deck::UnitSystem before) {
  const deck::UnitSystem now = state_.deck.units();
  if (now == before) return;
  const bool back = state_.numbers_in == now;
  // What was typed in the other units in the meantime goes back with them.
  if (back && !state_.typed_since.empty()) {
    const deck::Deck other = state_.deck;
    for (deck::RecordData& record : state_.deck.records)
      convert(record, other, before, now, Given::Alone);
  }
  keep_numbers_given();
  if (!back) state_.numbers_in = before;
}

/// Called after a change of several values: those that are others than before are in the units of
/// the deck.
void Document::note_typed(const deck::Deck& before) {
  if (!state_.numbers_in) return;
  for (const deck::RecordData& record : state_.deck.records)
    for (std::size_t v = 0; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        const Cell cell{record.id, record.instance, v, k};
        const deck::Value* old = value_at(before, cell);
        if (old != nullptr && *old != record.values[v][k]) state_.typed_since.insert(cell);
      }
}

void Document::keep_numbers_given() {
  state_.numbers_in.reset();
  state_.typed_since.clear();
}

void Document::keep_numbers() {
  keep_numbers_given();
  notify();
}

/// Also what is on the shelf, for the day when its record applies again.
void Document::convert_values() {
  if (!state_.numbers_in) return;
  end_step();
  const deck::UnitSystem from = *state_.numbers_in, to = state_.deck.units();
  deck::Deck ever;
  for (const auto& [place, record] : state_.shelf) ever.records.push_back(record);
  for (auto& [place, record] : state_.shelf)
    convert(record, state_.deck.has_record(record.id) ? state_.deck : ever, from, to, Given::Left);
  const deck::Deck before = state_.deck;
  for (deck::RecordData& record : state_.deck.records)
    convert(record, before, from, to, Given::Left);
  settle();
  keep_numbers_given();
  redo_.clear();
  find_problems();
  notify();
}

void Document::convert(deck::RecordData& record, const deck::Deck& deck, deck::UnitSystem from,
                       deck::UnitSystem to, Given given) const {
  const deck::RecordData old = record;
  deck::convert_values(record, deck, from, to);
  for (std::size_t v = 0; v < std::min(old.values.size(), record.values.size()); ++v)
    for (std::size_t k = 0; k < std::min(old.values[v].size(), record.values[v].size()); ++k) {
      const bool is_given = state_.typed_since.count({record.id, record.instance, v, k}) > 0;
      if (is_given != (given == Given::Alone)) record.values[v][k] = old.values[v][k];
    }
}

}  // namespace adore::adrinput
