#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"

#include <functional>
#include <string_view>

namespace adore::setup {

/// A number of the deck in SI, by variable and instance.
using NumberReader = std::function<double(std::string_view variable, int instance)>;

/// The cage's shape in the deck: body, clearances, pockets and guide lands (records
/// 7.0 to 7.2). Models and drawings read it here and differ only in `number`: a model
/// reads a checked deck (Deck::si), a drawing an unfinished one, in which missing values are 0. An
/// invalid pocket code reads as cylindrical, the clearance II of a pocket that has none
/// as 0.
[[nodiscard]] bearing::Cage read_cage(const deck::Deck& deck, const NumberReader& number);

}  // namespace adore::setup
