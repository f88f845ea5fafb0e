#pragma once

#include "adrinput/document.hpp"

#include <optional>

/// Times of a run typed in seconds or revolutions: their values are known only after the
/// equilibrium has given the time scale.
namespace adore::adrinput {

/// Is there a time in seconds or revolutions that cannot be converted yet, because its scale is
/// unknown?
[[nodiscard]] bool has_pending_times(const Document& document);

/// Applies those whose scale is now known. True if there was one.
bool apply_pending_times(Document& document);

/// The deck whose time scale is missing, without values that do not determine it, so that an error
/// there does not prevent the conversion of a time; no value if there is another error, if a value
/// is being typed, or if the scale is known.
[[nodiscard]] std::optional<deck::Deck> deck_without_scales(const Document& document);

}  // namespace adore::adrinput
