#pragma once

#include "dynamics/new_equilibrium.hpp"
#include "facade/prepare.hpp"
#include "results/restart.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// Changes of the equilibrium in a run (dynamics/new_equilibrium.hpp): their verdict, and the scene
/// that a stored state belongs to.
namespace adore::facade {

/// What is reported of a change; empty: nothing. @param cause noun phrase: "thermal step 2"
/// @throws SolverError when the excess energy is above dynamics::kExcessRefused
[[nodiscard]] std::string change_remark(const dynamics::NewEquilibrium& change,
                                        const std::string& cause);

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

}  // namespace adore::facade
