#include "adrinput/document.hpp"
#include "deck/unit_change.hpp"

#include <algorithm>

/// Conversion of values when kUnit changes.
namespace adore::adrinput {

/// Called after an edit: whether it was the one that changed the units, or changed them back.
void Document::track_unit_change(deck::UnitSystem before) {
  const deck::UnitSystem now = state_.deck.units();
  if (now == before) return;
  const bool back = state_.previous_units == now;
  // Values typed in the other units since then are converted back, too.
  if (back && !state_.typed_since.empty()) convert_all(before, now, TypedValues::Alone);
  clear_unit_change();
  if (!back) state_.previous_units = before;
}

/// Called after a change of several values: those that are others than before are in the units of
/// the deck.
void Document::mark_changed_as_typed(const deck::Deck& before) {
  if (!state_.previous_units) return;
  for (const deck::RecordData& record : state_.deck.records)
    for (std::size_t v = 0; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        const Cell cell{record.id, record.instance, v, k};
        const deck::Value* old = value_at(before, cell);
        // For a record or an element that was missing: its stored values.
        if (const auto kept = state_.shelf.find({record.id, record.instance});
            old == nullptr && kept != state_.shelf.end() && v < kept->second.values.size() &&
            k < kept->second.values[v].size())
          old = &kept->second.values[v][k];
        const bool given =
            old != nullptr ? *old != record.values[v][k]
                           : std::find(record.defaulted.begin(), record.defaulted.end(),
                                       deck::RecordData::Element{v, k}) == record.defaulted.end();
        if (given) state_.typed_since.insert(cell);
      }
}

/// A cage that is cut, or made whole, starts with the values of the previous one
/// (Deck::complete()): values entered there in the units of the deck are in these units here, too.
void Document::mark_inherited_as_typed() {
  constexpr const char *kWhole = "9.6", *kSegment = "9.6.k";
  const bool cut = state_.shelf.count({kSegment, 1}) > 0;
  for (const deck::RecordData& record : state_.deck.records) {
    if ((record.id != kWhole && record.id != kSegment) ||
        state_.shelf.count({record.id, record.instance}) > 0)
      continue;
    for (std::size_t v = 0; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k)
        if (state_.typed_since.count({cut ? kSegment : kWhole, 1, v, k}) > 0)
          state_.typed_since.insert({record.id, record.instance, v, k});
  }
}

void Document::clear_unit_change() {
  state_.previous_units.reset();
  state_.typed_since.clear();
}

void Document::keep_numbers() {
  clear_unit_change();
  notify();
}

void Document::convert_values() {
  if (!state_.previous_units) return;
  end_undo_step();
  convert_all(*state_.previous_units, state_.deck.units(), TypedValues::Left);
  clear_unit_change();
  redo_.clear();
  find_problems();
  notify();
}

/// Also stored values, for the time when their record applies again.
void Document::convert_all(deck::UnitSystem from, deck::UnitSystem to, TypedValues given) {
  for (const deck::RecordData& record : state_.deck.records) remember(record);
  // Codes that make a value a pure number: of records that are not there, the last ones.
  deck::Deck ever;
  for (const auto& [place, record] : state_.shelf) ever.records.push_back(record);
  for (auto& [place, record] : state_.shelf)
    convert(record, state_.deck.has_record(record.id) ? state_.deck : ever, from, to, given);
  restore_from_shelf();
}

void Document::convert(deck::RecordData& record, const deck::Deck& deck, deck::UnitSystem from,
                       deck::UnitSystem to, TypedValues given) const {
  const deck::RecordData old = record;
  deck::convert_values(record, deck, from, to);
  for (std::size_t v = 0; v < std::min(old.values.size(), record.values.size()); ++v)
    for (std::size_t k = 0; k < std::min(old.values[v].size(), record.values[v].size()); ++k) {
      const bool is_given = state_.typed_since.count({record.id, record.instance, v, k}) > 0;
      if (is_given != (given == TypedValues::Alone)) record.values[v][k] = old.values[v][k];
    }
}

}  // namespace adore::adrinput
