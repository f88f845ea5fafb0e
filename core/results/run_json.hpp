#pragma once

#include "base/finding.hpp"
#include "base/write_folder.hpp"
#include "deck/defaults.hpp"
#include "deck/no_part.hpp"
#include "results/averages.hpp"
#include "results/file_sums.hpp"
#include "results/key_results.hpp"
#include "results/mean_load.hpp"
#include "scene/cost_ledger.hpp"
#include "scene/quadrature_error.hpp"
#include "scene/scales.hpp"
#include "scene/snapshot.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// RUN.json: inputs and cost of a run, so that it can be understood a year later.
/// The same deck, machine and build reproduce every byte, except the entries under
/// "measured".
namespace adore::results {

/// Counters of the stepper, by name: "steps", "rejected", "evaluations" ...
using Counters = std::vector<std::pair<std::string, long>>;

struct RunSummary {
  std::string run_id, deck_file;     ///< deck's file name without folders
  std::string request;               ///< digest of the request
  std::string status;                ///< "done", "interrupted", "failed"
  std::string message;               ///< diagnosis, empty when done
  nlohmann::ordered_json plan;       ///< the scene plan
  std::string stability;             ///< decisions on the integrator's steps; also in plan
  nlohmann::ordered_json stored;     ///< meaning of stored values (stored_json); null: no motion
  nlohmann::ordered_json operating;  ///< operating fits and clearances; null: none
  std::optional<scene::Scales> scales;
  std::string integrator;
  double tolerance = 0.0;
  std::vector<std::pair<std::string, std::string>>
      options;                                      ///< named options with the values in force
  std::vector<std::pair<std::string, long>> seeds;  ///< of random numbers, by use
  nlohmann::ordered_json imperfections;  ///< geometric, of elements and races; null: ideal bearing
  std::vector<deck::DefaultUsed> defaults_used;  ///< values that the deck left out
  std::vector<deck::NoPart> no_part;             ///< values of the deck that the run does not use
  std::vector<Finding> findings;                 ///< `notes` of the file are made of them
  nlohmann::ordered_json validity;               ///< laws outside their range; null: none
  long steps = 0;
  double time = 0.0, revolutions = 0.0;
  Counters counters;
  /// Of the steps, times the tolerance: over the scales of the state. Without: the method forms
  /// none.
  std::optional<double> error_sum, error_largest;
  std::optional<scene::EnergyLedger> energy;             ///< at the end
  std::optional<MeanLoad> load;                          ///< of the elements, against the asked one
  std::optional<double> elastic;                         ///< of the quasi-static solution [J]
  std::vector<std::pair<std::string, double>> momentum;  ///< residuals, by name with unit
  std::optional<double> max_quaternion_error;
  std::optional<scene::QuadratureError> quadrature_error;  ///< at the end
  KeyResults summary;
  nlohmann::ordered_json accuracy;      ///< of the results; null: not computed
  nlohmann::ordered_json life;          ///< fatigue life; null: none computed
  std::vector<std::string> files;       ///< names without folders
  nlohmann::ordered_json quasi_static;  ///< results/static_tables.hpp; null when there is none
  /// The same of a motion's last thermal step: its network alone.
  nlohmann::ordered_json thermal_network;
  // Measured.
  std::vector<scene::CostLedger::Row> cost;
  std::vector<FileChecksum> sums;  ///< of the files; empty while the run is under way
  double seconds = 0.0;            ///< of this process
  long measured_from = 0;          ///< step at which it took the run over; 0: the start

  std::string instruction_set;  ///< of the contact kernel, chosen at run time
};

[[nodiscard]] nlohmann::ordered_json run_json(const RunSummary& run);
/// Half-widths of 95 % intervals by the key results that they belong to; those not computed are
/// left out.
[[nodiscard]] nlohmann::ordered_json mean_errors_json(const MeanErrors& errors);
/// Replaces the file atomically. @throws InputError
void write_run_json(const RunSummary& run, const WritePath& place);
/// Adds members to the RUN.json of a finished run, replacing those of the same name: results
/// that are known only afterwards (verification). A new text is appended to PRINT.txt, and both
/// checksums follow. @throws InputError
void amend_run(const WriteFolder& folder, const nlohmann::ordered_json& members,
               const std::string& print);

/// Under "measured": checksum of the text with zeros in its place.
inline constexpr const char* kOwnChecksum = "checksum of this file";
/// As write_run_json() puts it into the text; empty where the text has none.
[[nodiscard]] std::string run_json_checksum(std::string text);

/// First members of an earlier RUN.json, as far as present; empty strings without a file
/// of this program.
struct RunRequestStatus {
  std::string request, status;
};
[[nodiscard]] RunRequestStatus read_request_status(const std::filesystem::path& path);
/// Member of the outer object of a RUN.json; null where the file or the member is missing.
[[nodiscard]] nlohmann::json read_run_member(const std::filesystem::path& path, const char* name);

/// Causes of different last digits in addition to deck and build. Shared with PRINT.txt.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> arithmetic_items(
    const RunSummary& run);

/// Name, value [J] of each item of the conservation ledger, residual last. Shared with PRINT.txt.
[[nodiscard]] std::vector<std::pair<std::string, double>> energy_items(
    const scene::EnergyLedger& energy);

/// Name with unit and value of each item of the momentum ledger: what came from outside, what
/// changed, and the residuals, also relative to the momentum that the bodies carry now.
[[nodiscard]] std::vector<std::pair<std::string, double>> momentum_items(
    const scene::MomentumLedger& momentum);

/// Size of the energies that moved, to judge the residual by: work or heat, whichever is larger,
/// but not less than kEnergyFloor of the energy that is stored; without work and heat the stored
/// energy [J]. 0 only when nothing is loaded and nothing moves.
[[nodiscard]] double energy_scale(const scene::EnergyLedger& energy);

/// A bearing at rest, or one that creeps, moves no energy: then a residual is measured by what is
/// stored. With kMovedWarning and kMovedLimit (energy_judgement.hpp) the floor warns above 1e-10 of
/// the stored energy and refuses above 1e-8. Rounding of the sums (1e-16 per step, random) stays
/// below 1e-12 for 1e8 steps; contact loads depend on an energy error of 1e-8 by less than 1e-4
/// even where all of it is a contact vibration (amplitude ~ its square root).
inline constexpr double kEnergyFloor = 1e-6;

/// Heat that a residual can falsify [J], not less than kHeatFloor of the stored energy; 0 in a run
/// without heat. With 5 % of it the floor is 5e-11 of the stored energy: what 1e6 steps of rounding
/// (1e-13) do not reach.
[[nodiscard]] double heat_scale(const scene::EnergyLedger& energy);
inline constexpr double kHeatFloor = 1e-9;

}  // namespace adore::results
