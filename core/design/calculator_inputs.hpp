#pragma once

#include "runs/prepare.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

/// Inputs of calculators (`adore calc`) from the quasi-static solution of a deck.
namespace adore::design {

/// Inputs of calculator "film" or "hertz" for one element (from 1), by race: {"outer race": {...},
/// "inner race": {...}}; a race that the element does not touch has null.
/// @throws InputError for another calculator, a missing element, a deck without lubricant (film) or
/// rollers (hertz)
[[nodiscard]] nlohmann::ordered_json calculator_inputs(const runs::Prepared& prepared,
                                                       const std::string& calculator, int element);

}  // namespace adore::design
