#pragma once

#include "runs/prepare.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Inputs of calculators (`adore calc`) from the quasi-static solution of a deck.
namespace adore::design {

/// Calculators that take a deck, in alphabetical order.
[[nodiscard]] const std::vector<std::string_view>& deck_calculators();

/// Inputs by the part that they describe. Of one element (from 1), film, hertz, line-contact: by
/// race, {"outer race": {...}, "inner race": {...}}; a race that the element does not touch has
/// null. load-capacity: by race, of the bearing. Others: {"bearing": {...}}.
/// @throws InputError for another calculator, a missing element, or a deck that lacks what the
/// calculator needs
[[nodiscard]] nlohmann::ordered_json calculator_inputs(const runs::Prepared& prepared,
                                                       const std::string& calculator, int element);

/// Those of the whole bearing; null: another calculator. @throws InputError
[[nodiscard]] nlohmann::ordered_json bearing_calculator_inputs(const runs::Prepared& prepared,
                                                               std::string_view calculator);

}  // namespace adore::design
