#pragma once

#include "deck/deck.hpp"

#include <QString>

/// Help text, generated from the schema; rich text.
namespace adore::adrinput {

/// A record: its purpose, when a deck has it, and each of its variables.
[[nodiscard]] QString record_help(const deck::Deck& deck, const deck::RecordSpec& record);
/// How decks are written: rules of the format.
[[nodiscard]] QString format_help();
/// Keys and habits of the window.
[[nodiscard]] QString keyboard_help();

/// "kBrg = 1 (ball bearing), nCseg = 1": the current options of a condition; empty for a record
/// that every deck has.
[[nodiscard]] QString condition_values_text(const deck::Deck& deck, std::string_view condition);

/// "Record 5A — Ball bearing geometry", or the name of the page of options.
[[nodiscard]] QString page_heading(const deck::RecordSpec& record);

/// "5A", "7.2" without the letter of repeated records.
[[nodiscard]] QString record_number(const deck::RecordSpec& record);

}  // namespace adore::adrinput
