#pragma once

#include "runs/run.hpp"

#include <string>

/// Entries of each run in tables of many runs: sweeps and studies.
namespace adore::runs {

/// How a run ended, in any case.
struct RunEnding {
  RunOutcome outcome;
  std::string failure;  ///< input or solver error, interruption: the run has no outcome
  int exit_code = 0;    ///< as the command line's
  /// A file could not be written: no fault of the deck, and no result of the run.
  bool not_written = false;
  [[nodiscard]] const std::string& message() const {
    return failure.empty() ? outcome.message : failure;
  }
};

/// run(), with its errors as values. Bugs pass.
[[nodiscard]] RunEnding run_catching_errors(const RunRequest& request, const std::stop_token& stop);

/// A number as --set takes it: whole values without a decimal point, so that integer variables take
/// them; others with as many digits as they have.
[[nodiscard]] std::string value_text(double value);

/// Unit of the deck variable in the deck's system; empty for a pure number, or if deck or name
/// are wrong (the runs report it).
[[nodiscard]] std::string variable_unit(const DeckRequest& request, const std::string& variable);

/// A sentence as the last field of a table's line: quoted, on one line.
[[nodiscard]] std::string quoted_message_field(std::string message);

}  // namespace adore::runs
