#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

namespace adore::deck {

/// A value that holds although the deck does not give it.
struct DefaultUsed {
  std::string record;    ///< "9.1.1", with the instance of a repeated record: "7.2.i (2)"
  std::string variable;  ///< with its element when it is an array: "iCageGuide[2]"
  std::string value;     ///< as the deck would say it; of a code also its meaning
  std::string unit;      ///< of the deck's unit system, "" for a pure number
  bool operator==(const DefaultUsed&) const = default;
};

/// Defaults that stand in for what the deck leaves out: values that `,,` or `/` skipped, records
/// and values added by complete() or set(), and codes 0 that stand for a usual material, built-in
/// constants or default names. In deck order.
std::vector<DefaultUsed> defaults_used(const Deck& deck);

/// What nobody gave in `after` and `before` did not have: records and array elements that changed
/// options brought in, with their default values. One warning per record.
std::vector<Issue> added_defaults(const Deck& before, const Deck& after);

}  // namespace adore::deck
