#pragma once

#include "base/finding.hpp"
#include "deck/deck.hpp"

#include <compare>
#include <cstddef>
#include <optional>
#include <string>

/// One value of a deck by its position in the schema. No Qt.
namespace adore::adrinput {

struct Cell {
  std::string record;  ///< schema id, "7.2.i"
  int instance = 1;    ///< from 1
  std::size_t variable = 0;
  std::size_t element = 0;  ///< from 0
  auto operator<=>(const Cell&) const = default;
};

/// nullptr when the deck has no such value.
[[nodiscard]] const deck::Value* value_at(const deck::Deck& deck, const Cell& cell);
[[nodiscard]] deck::RecordData* record_at(deck::Deck& deck, const std::string& id, int instance);
/// nullptr when the schema has no such variable.
[[nodiscard]] const deck::VariableSpec* variable_of(const Cell& cell);

/// The value that an issue speaks of: its first element when it names the whole variable.
[[nodiscard]] std::optional<Cell> cell_of(const Issue& issue);
/// Record and variable of a finding, or those of its kind if the deck has the record.
[[nodiscard]] std::optional<Issue> issue_of_finding(const deck::Deck& deck, const Finding& finding);

}  // namespace adore::adrinput
