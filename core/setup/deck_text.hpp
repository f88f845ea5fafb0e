#pragma once

#include "base/errors.hpp"
#include "deck/deck.hpp"

#include <string>
#include <string_view>
#include <utility>

/// How the builder speaks of a deck: in its units, and with record and variable.
namespace adore::setup {

/// "0.0127 m" or "0.5 in", in the units of the deck.
[[nodiscard]] std::string length_text(const deck::Deck& deck, double metres);

/// "353.15 K" or "635.67 R".
[[nodiscard]] std::string temperature_text(const deck::Deck& deck, double kelvin);

/// The same error with file, line, record and value of `variable` where it names no place yet.
[[nodiscard]] InputError with_location(const deck::Deck& deck, std::string_view variable,
                                       const InputError& error);

/// Result of `make`; its errors become errors of `variable`.
template <class Make>
auto with_variable_location(const deck::Deck& deck, std::string_view variable, Make&& make) {
  try {
    return std::forward<Make>(make)();
  } catch (const InputError& error) {
    throw with_location(deck, variable, error);
  }
}

}  // namespace adore::setup
