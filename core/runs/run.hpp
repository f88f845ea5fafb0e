#pragma once

#include "results/key_results.hpp"
#include "results/mean_errors.hpp"
#include "runs/deck_request.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// A whole run: deck in, every output file out.
namespace adore::runs {

struct RunRequest : DeckRequest {
  std::optional<std::filesystem::path> out;  ///< folder of the files; default: that of the deck
  std::filesystem::path below;  ///< of the files, in `out`: folders that the program names
  std::string until;       ///< "5rev", "0.02s" or a dimensionless time; replaces fTime and maxStps.
                           ///< Empty: the deck's
  std::string integrator;  ///< name instead of intMet; empty: the deck's
  std::optional<double> tolerance;  ///< instead of tol
  bool go_on = false;      ///< complete the run whose MASTER is in the folder; maxStps counts from
                           ///< start of that run
  bool overwrite = false;  ///< results of an earlier run in the folder may be replaced
  std::string settings_note;  ///< origin of the settings: finding run.settings; empty: the user
};

/// Data for a live display, sent at most about 20 times a second and once at the end.
struct Progress {
  double fraction = 0.0;     ///< of the simulated span, 0..1; 1 only when the run is done. Of a run
                             ///< that is completed (go_on): what was done before counts
  double revolutions = 0.0;  ///< shaft turns, inner relative to outer
  double time = 0.0;         ///< simulated [s]
  double end_time = 0.0;     ///< [s]
  long step = 0;
  long last_step = 0;      ///< the step that ends the run when it comes before end_time at the pace
                           ///< of the run so far; 0: the time ends it
  double elapsed = 0.0;    ///< computing time so far [s]
  double remaining = 0.0;  ///< estimate [s]
  double speed_up = 0.0;   ///< simulated over computing time
  long runs = 0;           ///< of a sweep: how many there are, and `step` counts those that are
                           ///< done; 0: one run
  std::string_view piece = "run";  ///< unit of `runs`: "run", or "speed" of a table
};
using ProgressSink = std::function<void(const Progress&)>;

enum class RunStatus : unsigned char {
  Done,
  Interrupted,
  Failed,    ///< the numerics gave up
  Untrusted  ///< it came to its end, and its results cannot be trusted
};

struct RunOutcome {
  RunStatus status = RunStatus::Done;
  std::string message;  ///< Failed, Untrusted: diagnosis and remedy. Files are valid up to the last
                        ///< stored step. Done: reports when the run was already complete
  std::filesystem::path folder;
  std::vector<std::filesystem::path> files;  ///< written, in the order of outputs.md
  std::vector<Finding> warnings;             ///< all findings (base/finding.hpp)
  std::vector<std::string> results;  ///< of a quasi-static run: displacement, largest load and
                                     ///< pressure, life, a line each in the deck's units
  long steps = 0;
  long taken = 0;             ///< steps of the integrator: `steps` counts each nStps of them
  long evaluations = 0;       ///< of the right-hand side
  double longest_step = 0.0;  ///< that the run was allowed [s]
  double time = 0.0, revolutions = 0.0, seconds = 0.0;
  double missed_end = 0.0;         ///< fTime, when maxStps ended the run before it [s]; else 0
  bool speeds_vary = false;        ///< of races: turns give no end time
  double energy_residual = 0.0;    ///< [J]
  results::KeyResults summary;     ///< a sweep's columns
  results::MeanSeries means;       ///< of a motion
  double processor_seconds = 0.0;  ///< of the whole run, set-up and files included
  double energy_scale = 0.0;       ///< heat dissipated, or kinetic energy when there is none [J]
};

/// Runs the deck to its end, to an interruption, or to a diagnosed failure.
/// @throws InputError (nothing was overwritten; ResultsExist when results of an earlier run are
/// in the way and may not be replaced), SolverError when no start state exists
/// (PRINT.txt reports it), Interrupted when the stop came before any output.
RunOutcome run(const RunRequest& request, const ProgressSink& progress = {},
               std::stop_token stop = {});

/// The folder that the request names for its files; they are in the folder `below` it.
std::filesystem::path output_folder(const RunRequest& request, const std::filesystem::path& deck);

/// Digest of the run: deck with its sets, options, end, method and program version.
[[nodiscard]] std::string request_digest(const RunRequest& request, const LoadedDeck& deck);

}  // namespace adore::runs
