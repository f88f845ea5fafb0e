#pragma once

#include "results/sol_file.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

/// Additions of RESULTS.h5 to a classic file in the same folder. The classic files alone are
/// sufficient to plot and to play; if the HDF5 file of the same run is in their folder, its numbers
/// are used.
namespace adore::results {

/// Parts of a classic file that came from RESULTS.h5.
struct FullPrecisionStatus {
  std::string why_not;      ///< empty: values were replaced
  std::size_t exact = 0;    ///< of the file's own steps have all digits
  long end = 0;             ///< the last step of RESULTS.h5
  bool from_start = false;  ///< they are the first ones, without a gap between them
  std::size_t added = 0;    ///< steps behind the file's last one
  bool more = false;        ///< RESULTS.h5 has others behind, for which there was no room
};

/// Replaces the values of a SOL1-SOL7 file by those of RESULTS.h5 in the same folder: all digits,
/// and numbers instead of stars. Columns without a channel, and steps that are not in RESULTS.h5,
/// do not change. Up to `most_added` steps of RESULTS.h5 after the
/// file's last one are added, at the same interval as those read from the file: a killed
/// run loses the end of either.
/// If the file is not changed, `why_not` has the reason, for example that there is no RESULTS.h5,
/// or that it belongs to another run: its run code differs, or a number beyond the digits that the
/// classic file shows. Never throws for a bad RESULTS.h5.
[[nodiscard]] FullPrecisionStatus use_full_precision(SolFile& file, std::size_t most_added = 0);

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
