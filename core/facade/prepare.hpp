#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "deck/no_part.hpp"
#include "dynamics/system.hpp"
#include "life/bearing_life.hpp"
#include "scene/plan.hpp"
#include "setup/run_control.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction.hpp"
#include "statics/roller_statics.hpp"
#include "statics/stiffness_table.hpp"
#include "thermal/steady_state.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// From a deck file to everything a run starts from. Apps and CLI call this and nothing below it.
namespace adore::user {
struct PlugIn;
class Session;
}  // namespace adore::user

namespace adore::facade {

/// What the user asked for beyond the deck.
struct DeckRequest {
  std::filesystem::path deck = ".";  ///< the deck, or a folder that holds DATA.txt
  std::optional<std::string> text;   ///< the deck itself, in place of the file; its outputs go to
                                     ///< the current folder
  std::vector<std::pair<std::string, std::string>>
      sets;  ///< --set variable=value, in the deck's units
  std::vector<std::pair<std::string, std::string>>
      options;  ///< --opt name=value, over those of ADORE.json
  /// --user: routines of the user, a shared object or a file of formulas (user/plug_in.hpp). The
  /// one way to load code: neither deck nor ADORE.json can.
  std::filesystem::path user;
  std::shared_ptr<const user::PlugIn> routines;  ///< functions of the calling program, instead
};

struct LoadedDeck {
  std::filesystem::path path;  ///< the deck file
  deck::Deck deck;             ///< with the sets applied
  std::vector<Issue> warnings;
  std::map<std::string, std::string> option_values;  ///< ADORE.json and --opt, as given
  std::filesystem::path user;                        ///< as in the request
  std::shared_ptr<const user::PlugIn> routines;
  std::stop_token stop;  ///< ends a long preparation (Interrupted)
  /// Called after each speed of the stiffness table; may be empty.
  std::function<void(long done, long total)> table_progress;
};

/// The deck file that a path means: itself, or DATA.txt in it. @throws InputError when there is
/// none.
[[nodiscard]] std::filesystem::path deck_path(const std::filesystem::path& path);

/// What messages call a deck that came as text.
inline constexpr const char* kStandardInput = "standard input";
/// The deck file of the request, or kStandardInput. @throws InputError when there is none.
[[nodiscard]] std::filesystem::path deck_path(const DeckRequest& request);
/// The request's deck before any of its sets. @throws InputError when it cannot be read.
[[nodiscard]] deck::ReadResult read_deck(const DeckRequest& request);

/// Reads, applies the sets, checks again. @throws InputError with every error of the deck.
[[nodiscard]] LoadedDeck load_deck(const DeckRequest& request);

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
  std::optional<statics::RollerSolution> rollers;             ///< roller bearings, instead of it
  std::shared_ptr<const dynamics::RollerScene> roller_scene;  ///< where a run of them starts
  std::vector<statics::StiffnessRow> stiffness;               ///< kStif; empty when not asked for
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

  /// What the quasi-static solution says of the inner race, whatever rolls on it.
  [[nodiscard]] const statics::RaceResult& race_result() const {
    return rollers ? static_cast<const statics::RaceResult&>(*rollers) : statics;
  }
};

/// What operating_bearing warned of (lost clearance, loose fit, overstressed ring), as remarks on
/// the deck.
[[nodiscard]] std::vector<Issue> operating_warnings(const bearing::Bearing& bearing,
                                                    const std::string& file);

/// What the equilibrium says of itself (unstable, dual contact, edges, elements without load):
/// notes on the deck.
[[nodiscard]] std::vector<Issue> solution_notes(const Prepared& prepared);

/// The run options of the ADORE.json beside a deck, as given; empty when there is none.
/// @throws InputError when the file is no object of named values.
[[nodiscard]] std::map<std::string, std::string> options_beside(
    const std::filesystem::path& deck_file);

/// @throws InputError, SolverError (no equilibrium).
[[nodiscard]] Prepared prepare(const DeckRequest& request);
/// The same for a deck in memory that has no errors.
[[nodiscard]] Prepared prepare(LoadedDeck input);

/// The equations of motion of a prepared dynamic deck.
[[nodiscard]] dynamics::System make_system(const Prepared& prepared);

/// Plan with its estimates (frequencies, step, cost) as text or JSON.
[[nodiscard]] scene::ScenePlan plan_with_estimates(const Prepared& prepared);
/// What the integrator's steps do to contact vibrations, and what is done about it; empty for a
/// quasi-static deck.
[[nodiscard]] std::string stability_text(const Prepared& prepared);
[[nodiscard]] std::string plan_text(const Prepared& prepared, const scene::ScenePlan& plan);

}  // namespace adore::facade
