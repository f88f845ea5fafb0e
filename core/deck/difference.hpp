#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

/// Differences between two decks, in words.
namespace adore::deck {

struct Difference {
  std::string record;       ///< schema id; "12" for lines of user routines
  int instance = 1;         ///< from 1
  std::string variable;     ///< empty when it concerns a whole record
  int index = 0;            ///< element of an array, from 1; 0 when it concerns a whole value
  std::string left, right;  ///< as each deck has it, with its unit or the meaning of its code
  bool in_left = true, in_right = true;
  bool label = false;    ///< only the text of a record's label, which nothing depends on
  std::string sentence;  ///< "pitchDia: 0.06 m here, 0.061 m there (1.67 % more)"
};

/// In deck order; "here" is the left deck and "there" the right one. Where the decks have different
/// units, numbers are compared as quantities, to nine digits; a record that only one deck has is
/// one difference, its values are not listed.
[[nodiscard]] std::vector<Difference> differences(const Deck& left, const Deck& right);

}  // namespace adore::deck
