#pragma once

#include "results/sol_file.hpp"

#include <string>
#include <vector>

/// What RESULTS.h5 beside a classic file adds to it. The classic files alone are enough to plot and
/// to play; where the HDF5 file of the same run lies in their folder, its numbers are used.
namespace adore::results {

/// What RESULTS.h5 gave to a classic file.
struct FullPrecision {
  std::string why_not;      ///< empty: values were replaced
  std::size_t exact = 0;    ///< of the file's own steps have all digits
  bool from_start = false;  ///< they are the first ones, without a gap between them
  std::size_t added = 0;    ///< steps behind the file's last one
  bool more = false;        ///< RESULTS.h5 has others behind, for which there was no room
};

/// Replaces the values of a SOL1-SOL7 file by those of RESULTS.h5 in the same folder: all digits,
/// and numbers where the file shows stars. Columns without a channel, and steps that RESULTS.h5
/// does not hold, keep what they have. Up to `most_added` steps that RESULTS.h5 has behind the
/// file's last one are added, as far apart as the file's own: a run that was killed loses the end
/// of either.
/// The file is left as it is, `why_not` saying why, for example when there is no RESULTS.h5, or
/// when it is of another run: its run code differs, or a number beyond the digits that the classic
/// file shows. Never throws for a bad RESULTS.h5.
[[nodiscard]] FullPrecision use_full_precision(SolFile& file, std::size_t most_added = 0);

}  // namespace adore::results
