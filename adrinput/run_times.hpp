#pragma once

#include "adrinput/document.hpp"

#include <optional>

/// Times of a run that are typed in seconds or turns: what they are is known only when the
/// equilibrium has given the scale of time.
namespace adore::adrinput {

/// Is there a time in seconds or revolutions that cannot be converted yet, because its scale is
/// unknown?
[[nodiscard]] bool has_waiting_times(const Document& document);

/// Takes those whose scale is known by now. Was there one?
bool take_waiting_times(Document& document);

/// The deck whose scale of time is missing, without what does not decide it, so that an error there
/// does not keep a time from being understood; nothing when another error does, when something is
/// being typed, and when the scale is known.
[[nodiscard]] std::optional<deck::Deck> deck_without_scales(const Document& document);

}  // namespace adore::adrinput
