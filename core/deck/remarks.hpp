#pragma once

#include "deck/deck.hpp"
#include "deck/scanner.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Text after the values of records in a deck, which no reader uses.
namespace adore::deck {

/// End of the values of a record: the line (0-based), and the text after them.
struct RecordEnd {
  std::size_t line = 0;
  std::string_view remark;
};
/// @param record as read from the scanner's text
[[nodiscard]] RecordEnd find_record_end(const Scanner& start, const RecordData& record);

struct UpdatedRemarkUnits {
  std::string text;
  /// Records, each once, whose remark speaks of a unit that the deck does not have now, and is not
  /// known here: it stays as it is.
  std::vector<std::string> doubtful;
};

/// Remarks of the example decks and of the catalogue end with the units of their values, "[N, m]".
/// After a change of kUnit these follow: "[lbf, in]". What others wrote stays as it is.
/// @param text of a deck that is in its new units
/// @param before the units that its remarks speak of
[[nodiscard]] UpdatedRemarkUnits update_remark_units(std::string_view text, UnitSystem before);

/// Words before the units in a remark that Adore writes, "forces on the inner race, displacements".
[[nodiscard]] bool is_generated_comment(std::string_view words);

/// The catalogue's words for record 4, which no example has.
inline constexpr std::string_view kCatalogueOutside =
    "bore, OD, shaft bore, housing OD (an estimate), race widths";

/// Without blanks and tabs at both ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace adore::deck
