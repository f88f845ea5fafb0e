#pragma once

#include "dynamics/new_equilibrium.hpp"
#include "results/restart.hpp"
#include "runs/prepare.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Changes of the equilibrium in a run (dynamics/new_equilibrium.hpp): their verdict, and the scene
/// that a stored state belongs to.
namespace adore::runs {

/// Loads and motions that routine ADRX1 gives to the races, as a clause; empty: none. The deck
/// specifies them, and no equilibrium has them: excess energy is then reported and ends no run.
[[nodiscard]] std::string user_routine_motion_text(const Prepared& prepared);
/// Jumps of ADRX1 that a run reports at its start: instants at which its loads jump (kinks), start
/// velocities and spins; empty: none.
[[nodiscard]] std::string user_routine_jumps_text(const Prepared& prepared);

/// Finding run.start_excess with the ratio of an excess energy to the elastic energy.
[[nodiscard]] Finding excess_energy_finding(const std::string& text, double ratio);

/// Finding about a change; empty: none. @param cause noun phrase: "thermal step 2"
/// @param specified from user_routine_motion_text()
/// @throws SolverError when the excess energy is above dynamics::kExcessRefused, unless shocks are
/// specified
[[nodiscard]] std::optional<Finding> equilibrium_change_finding(
    const dynamics::EquilibriumChange& change, const std::string& cause,
    const std::string& specified);

/// @param prepared outlives it
[[nodiscard]] dynamics::EquilibriumContext moving_scene(const Prepared& prepared,
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
void copy_state(const results::FinalState& from, const dynamics::System& system,
                std::vector<double>& y);

}  // namespace adore::runs
