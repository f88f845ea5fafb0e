#pragma once

#include "results/sol_file.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

/// What RESULTS.h5 beside a classic file adds to it. The classic files alone are enough to plot and
/// to play; where the HDF5 file of the same run lies in their folder, its numbers are used.
namespace adore::results {

/// Replaces the values of a SOL1-SOL7 file by those of RESULTS.h5 in the same folder: all digits,
/// and numbers where the file shows stars. Columns without a channel, and steps that RESULTS.h5
/// does not hold, keep what they have.
/// Returns an empty text when values were replaced, else why the file was left as it is, for
/// example that there is no RESULTS.h5, or that it is of another run: its run code differs, or a
/// number beyond the digits that the classic file shows. Never throws for a bad RESULTS.h5.
[[nodiscard]] std::string use_full_precision(SolFile& file);

/// Extremes of a column since the step before in the file, one per step, in the file's unit; NaN
/// where they are not known.
struct ColumnBand {
  std::vector<double> low, high;
};
/// Those of the columns (places in sol_columns) that RESULTS.h5 in the same folder has, by column;
/// none of a file of another run. Steps of RESULTS.h5 that the file passes over count, too.
/// @throws InputError when RESULTS.h5 is damaged
[[nodiscard]] std::map<std::size_t, ColumnBand> bands_of(const SolFile& file,
                                                         const std::set<std::size_t>& columns);

}  // namespace adore::results
