#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

namespace adore::deck {

/// A value that holds although the deck does not give it.
struct DefaultUsed {
  std::string record;    ///< "9.1.1", with the instance of a repeated record: "7.2.i (2)"
  std::string variable;  ///< with its element when it is an array: "iCageGuide[2]"
  std::string value;     ///< as written in a deck; for a code also its meaning
  std::string unit;      ///< of the deck's unit system, "" for a pure number
  bool operator==(const DefaultUsed&) const = default;
};

/// Defaults that replace values missing in the deck: values that `,,` or `/` skipped, records
/// and values added by complete() or set(), and codes 0 for a usual material, built-in
/// constants or default names. In deck order.
std::vector<DefaultUsed> defaults_used(const Deck& deck);

/// Values in `after` that were not given and not in `before`: records and array elements that
/// changed options require, with their default values. One warning per record.
std::vector<Issue> added_defaults(const Deck& before, const Deck& after);

}  // namespace adore::deck
