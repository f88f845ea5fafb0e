#pragma once

#include "deck/no_part.hpp"

#include <optional>
#include <string>
#include <vector>

/// Every variable of a deck acts, or is rejected, or is listed here with the reason why it has no
/// effect.
namespace adore::setup {

/// Values that no builder read, each with its reason. The deck's log (Deck::reads) must have been
/// there while check_buildable, build_bearing, build_run_control and build_life_inputs read the
/// deck.
[[nodiscard]] std::vector<deck::NoPart> find_unused_values(const deck::Deck& deck);

/// Does it ask for an effect, rather than choose how something is integrated, written or described?
[[nodiscard]] bool requests_effect(const deck::NoPart& value);

/// One note that names those among them that ask for an effect and that no issue of `said` speaks
/// of; nothing when there are none.
[[nodiscard]] std::optional<Issue> note_unused_values(const std::vector<deck::NoPart>& values,
                                                      const deck::Deck& deck,
                                                      const std::vector<Issue>& said);

/// Text for a value without a rule: a gap in the table of reasons.
inline constexpr const char* kNoReason = "this version does not use this value";

}  // namespace adore::setup
