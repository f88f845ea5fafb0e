#include "deck/orbit_records.hpp"

#include "deck/lookup.hpp"

#include <algorithm>

namespace adore::deck {
namespace {

constexpr std::string_view kOptions = "3.4", kOrbit = "9.5", kSwitch = "kRotFrame";

const RecordData* shelved(const Deck& deck, std::string_view id) {
  const auto found = std::find_if(deck.shelf.begin(), deck.shelf.end(),
                                  [&](const RecordData& record) { return record.id == id; });
  return found == deck.shelf.end() ? nullptr : &*found;
}

}  // namespace

bool is_orbit_variable(std::string_view name) {
  if (name == kSwitch) return true;
  const std::vector<VariableSpec>& variables = find_record(kOrbit)->variables;
  return std::any_of(variables.begin() + 1, variables.end(),
                     [&](const VariableSpec& one) { return one.name == name; });
}

bool has_enabled_orbit(const Deck& deck) {
  const Value* const mode = find_value(deck, "mode");
  const RecordData* const options = shelved(deck, kOptions);
  if (mode == nullptr || *mode != Value(-1LL) || options == nullptr) return false;
  const std::vector<VariableSpec>& variables = find_record(kOptions)->variables;
  const auto at = static_cast<std::size_t>(
      std::find_if(variables.begin(), variables.end(),
                   [](const VariableSpec& one) { return one.name == kSwitch; }) -
      variables.begin());
  return at < options->values.size() && options->values[at] == std::vector<Value>{1LL};
}

std::vector<RecordData> orbit_records(const Deck& deck) {
  const RecordData* const orbit = shelved(deck, kOrbit);
  if (orbit == nullptr || !has_enabled_orbit(deck)) return {};
  return {*shelved(deck, kOptions), *orbit};
}

Deck with_orbit_records(const Deck& deck) {
  Deck out = deck;
  for (RecordData& record : orbit_records(deck)) {
    const RecordSpec* const spec = find_record(record.id);
    const auto place =
        std::find_if(out.records.begin(), out.records.end(),
                     [&](const RecordData& other) { return find_record(other.id) > spec; });
    out.records.insert(place, std::move(record));
  }
  return out;
}

}  // namespace adore::deck
