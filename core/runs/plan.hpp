#pragma once

#include "runs/run.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// `adore plan`: what a run would simulate, why, and at what cost in time and disk.
namespace adore::runs {

struct PlanReport {
  std::string text;              ///< for people
  nlohmann::ordered_json json;   ///< bodies, effects with their reasons, estimates, disk
  std::vector<Finding> remarks;  ///< on the deck
};

/// Processor time that the pilot of a plan takes in the motion at most [s].
constexpr double kPlanPilot = 3.0;

/// The plan of a run, to its end. @param pilot processor time of the motion that is run to measure
/// the cost [s]; 0: none @param start processor time of the program before its run [s]
/// @throws InputError, SolverError (no equilibrium)
[[nodiscard]] PlanReport plan_of_run(const RunRequest& request, double pilot, double start = 0.0,
                                     std::stop_token stop = {});
/// Of the deck's own run, without a pilot.
[[nodiscard]] PlanReport plan(const DeckRequest& request, std::stop_token stop = {});

}  // namespace adore::runs
