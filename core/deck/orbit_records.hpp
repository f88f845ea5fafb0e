#pragma once

#include "deck/deck.hpp"

#include <string_view>
#include <vector>

/// Records 3.4 and 9.5 in mode -1. The classic tables ask for them in motion only, so that a deck
/// of mode -1 keeps them on its shelf. Where both are given and kRotFrame = 1, the orbit acts on
/// the equilibrium of mode -1, too: variables of the orbit can be set, are written and are read.
namespace adore::deck {

/// kRotFrame and the variables of record 9.5.
[[nodiscard]] bool is_orbit_variable(std::string_view name);

/// Does the shelf of a deck of mode -1 have record 3.4 with kRotFrame = 1?
[[nodiscard]] bool has_enabled_orbit(const Deck& deck);

/// Of a deck of mode -1 whose orbit acts: records 3.4 and 9.5 from its shelf; else empty.
[[nodiscard]] std::vector<RecordData> orbit_records(const Deck& deck);

/// The deck with these records among the others; it shares the log of what is read.
[[nodiscard]] Deck with_orbit_records(const Deck& deck);

}  // namespace adore::deck
