#pragma once

#include "deck/no_part.hpp"

#include <optional>
#include <string>
#include <vector>

/// Every variable of a deck acts, or is rejected, or is listed here with the reason why it has no
/// effect.
namespace adore::setup {

/// Values that no builder read, each with its reason. The deck's log (Deck::reads) must have been
/// there while check_buildable, build_bearing, build_run_control and build_life read the deck.
[[nodiscard]] std::vector<deck::NoPart> values_without_part(const deck::Deck& deck);

/// Does it ask for an effect, rather than choose how something is integrated, written or described?
[[nodiscard]] bool asks_for_an_effect(const deck::NoPart& value);

/// One note that names those among them that ask for an effect and that no issue of `said` speaks
/// of; nothing when there are none.
[[nodiscard]] std::optional<Issue> note_of(const std::vector<deck::NoPart>& values,
                                           const deck::Deck& deck, const std::vector<Issue>& said);

/// Text for a value without a rule: a gap in the table of reasons.
inline constexpr const char* kNoReason = "this version does not use this value";

}  // namespace adore::setup
