#pragma once

#include "dynamics/new_equilibrium.hpp"
#include "results/restart.hpp"
#include "runs/prepare.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// Changes of the equilibrium in a run (dynamics/new_equilibrium.hpp): their verdict, and the scene
/// that a stored state belongs to.
namespace adore::runs {

/// Loads and motions that routine ADRX1 gives to the races, as a clause; empty: none. The deck
/// specifies them, and no equilibrium has them: excess energy is then reported and ends no run.
[[nodiscard]] std::string specified_shocks(const Prepared& prepared);
/// Jumps of ADRX1 that a run reports at its start: instants at which its loads jump (kinks), start
/// velocities and spins; empty: none.
[[nodiscard]] std::string specified_jumps(const Prepared& prepared);

/// Message about a change; empty: none. @param cause noun phrase: "thermal step 2"
/// @param specified from specified_shocks()
/// @throws SolverError when the excess energy is above dynamics::kExcessRefused, unless shocks are
/// specified
[[nodiscard]] std::string change_remark(const dynamics::NewEquilibrium& change,
                                        const std::string& cause, const std::string& specified);

/// @param prepared outlives it
[[nodiscard]] dynamics::MovingScene moving_scene(const Prepared& prepared,
                                                 dynamics::System& system);

/// The scene of a stored run at its last instant.
struct StoredScene {
  Prepared prepared;
  std::unique_ptr<dynamics::System> system;
  double time = 0.0;
  std::vector<double> y;
};

/// @param thermal state of the thermal analysis; empty: none
/// @param now gives run options and user routines
/// @throws InputError, SolverError when the stored deck has no such scene
[[nodiscard]] StoredScene stored_scene(const results::FinalState& stored,
                                       const std::map<std::string, double>& thermal,
                                       const Prepared& now, const std::filesystem::path& file);

/// Controlled components of a stored state by name; others of y stay.
void take_state(const results::FinalState& from, const dynamics::System& system,
                std::vector<double>& y);

}  // namespace adore::runs
