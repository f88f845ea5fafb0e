#pragma once

#include "deck/deck.hpp"

#include <string>
#include <string_view>

namespace adore::deck {

/// The heart of read_deck_text: the text is known to be text and free of a byte-order mark.
ReadResult read_deck_records(std::string_view text, std::string file_name);

}  // namespace adore::deck
