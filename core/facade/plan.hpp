#pragma once

#include "facade/deck_request.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// `adore plan`: what a run would simulate, why, and at what cost in time and disk.
namespace adore::facade {

struct PlanReport {
  std::string text;             ///< for people
  nlohmann::ordered_json json;  ///< bodies, effects with their reasons, estimates, disk
  std::vector<Finding> remarks;  ///< on the deck
};

/// @throws InputError, SolverError (no equilibrium)
[[nodiscard]] PlanReport plan(const DeckRequest& request, std::stop_token stop = {});

}  // namespace adore::facade
