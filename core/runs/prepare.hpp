#pragma once

#include "base/validity.hpp"
#include "bearing/bearing.hpp"
#include "deck/no_part.hpp"
#include "dynamics/system.hpp"
#include "life/bearing_life.hpp"
#include "runs/deck_request.hpp"
#include "scene/plan.hpp"
#include "setup/run_control.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction.hpp"
#include "statics/roller_statics.hpp"
#include "statics/stiffness_table.hpp"
#include "thermal/steady_state.hpp"
#include "thermal/time_line.hpp"

#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// From a deck file to everything a run starts from. Apps and CLI call this and nothing below it.
namespace adore::user {
struct PlugIn;
class Session;
}  // namespace adore::user

namespace adore::runs {

/// A deck understood as a physical model with its plan.
struct Prepared {
  LoadedDeck input;
  bearing::Bearing as_built;  ///< of the deck: unmounted, at room temperature, at rest
  bearing::Bearing bearing;   ///< mounted and in operation; what statics and dynamics see
  setup::RunControl control;
  setup::RunOptions options;
  std::shared_ptr<user::Session> user;  ///< routines of the user; null: none
  scene::ScenePlan plan;
  statics::StaticSolution statics;  ///< balls: actual curvature, the quasi-static page
  std::optional<statics::RollerSolution> rollers;  ///< roller bearings, instead of it
  std::shared_ptr<const dynamics::RollerStaticResult> roller_scene;  ///< start of their run
  std::vector<statics::StiffnessRow> stiffness;  ///< kStif; empty when not asked for
  std::array<double, 2>
      fixed_angle{};  ///< mean contact angles, where frozen Hertz constants are taken [rad]
  statics::StaticSolution
      start;  ///< with the law of the motion: start of a dynamic run (empty when quasi-static)
  std::string stability;              ///< of a run: what was decided on its steps (judge_steps.hpp)
  double solve_seconds = 0.0;         ///< computing time of the equilibrium
  double stiffness_seconds = 0.0;     ///< and of the table over speed
  std::vector<deck::NoPart> no_part;  ///< values of the deck that this run does not use, and why
  life::BearingLife life;             ///< at the equilibrium that PRINT.txt shows
  std::optional<statics::FrictionEstimate> friction;  ///< of a quasi-static deck
  std::optional<thermal::SteadyState> thermal;        ///< of one with kTherm = 1
  /// Laws outside their range of validity in the quasi-static solution.
  std::vector<validity::Finding> left_ranges;
  std::optional<thermal::ThermalTransient> time_line;  ///< and thermalTransient = on

  /// Results of the quasi-static solution for the inner race, for balls and rollers.
  [[nodiscard]] const statics::RaceResult& race_result() const {
    return rollers ? static_cast<const statics::RaceResult&>(*rollers) : statics;
  }
};

/// What operating_bearing warned of (lost clearance, loose fit, overstressed ring), as remarks on
/// the deck.
[[nodiscard]] std::vector<Finding> operating_warnings(const bearing::Bearing& bearing,
                                                      const std::string& file);

/// Azimuth of element 1 at the start (record X4); 0 where it is not given [rad].
[[nodiscard]] double start_azimuth(const deck::Deck& deck);

/// Options of ball statics: the base frame is that of the roller options.
[[nodiscard]] statics::BallStaticsOptions ball_statics_options(const Prepared& prepared);

/// Adds a remark on the deck to those that the run tells.
void add_remark(Prepared& prepared, Finding finding);

/// Findings of the equilibrium (unstable, dual contact, edges, elements without load), and of the
/// lives.
[[nodiscard]] std::vector<Finding> solution_notes(const Prepared& prepared);

/// @throws InputError, SolverError (no equilibrium), Interrupted.
[[nodiscard]] Prepared prepare(const DeckRequest& request, std::stop_token stop = {});
/// The same for a deck in memory that has no errors.
[[nodiscard]] Prepared prepare(LoadedDeck input);

/// The equations of motion of a prepared dynamic deck.
[[nodiscard]] dynamics::System make_system(const Prepared& prepared);

/// Adds to the plan the substitutes of integrals that are too expensive.
void add_approximation_note(scene::ScenePlan& plan, const dynamics::System& system);

/// Plan with its estimates (frequencies, step, cost) as text or JSON.
[[nodiscard]] scene::ScenePlan plan_with_estimates(const Prepared& prepared);
/// Effect of the integrator's steps on contact vibrations, and the changes made; empty for a
/// quasi-static deck.
[[nodiscard]] std::string step_stability_text(const Prepared& prepared);
[[nodiscard]] std::string plan_text(const Prepared& prepared, const scene::ScenePlan& plan);

}  // namespace adore::runs
