#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

/// Values of a deck that a run does not use.
namespace adore::deck {

struct NoPart {
  std::string record;        ///< schema id
  std::string variable;      ///< "reDen", "cageGsCls[2]" (instance), "kPltElemInd[3]" (element)
  std::string value;         ///< as in the deck
  std::string because;       ///< a clause: "a quasi-static solution has no steps in time"
  bool switched_on = false;  ///< an option at another code than its default: it asks for something
};

/// Every value that the deck's log does not have, in deck order; labels of records and what stays
/// empty left out, reasons not given. Nothing when the deck has no log.
[[nodiscard]] std::vector<NoPart> values_not_read(const Deck& deck);

}  // namespace adore::deck
