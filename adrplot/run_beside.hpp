#pragma once

#include "adrplot/page_builder.hpp"

#include <cstddef>
#include <filesystem>
#include <set>

/// Data of the run from the files next to a plot file: bearing frequencies from RESULTS.h5, the
/// fastest contact from RUN.json, and extremes between stored steps.
namespace adore::adrplot {

/// Mean frequencies of a run, measured over it [Hz]: of the shaft (inner against outer race), FTF
/// (the elements' orbit), BSF (an element's spin about itself, seen from its orbit), BPFO and BPFI
/// (elements that pass a point of the outer, inner race: n |f_orbit - f_race|), with twice and
/// three times them, and the cage's whirl. Those that the run holds.
[[nodiscard]] std::vector<desktop::ChartMark> bearing_frequencies(
    const std::filesystem::path& results_h5);

/// All data for the pages of `file`; empty if the files in its folder are from another run or
/// missing. Never throws for an invalid file.
[[nodiscard]] PageContext context_of(const results::SolFile& file);

/// Adds the extremes of these columns (indices in sol_columns) if missing in the context; empty
/// ones if RESULTS.h5 has none. Never throws for an invalid file.
void read_bands(const results::SolFile& file, const std::set<std::size_t>& columns,
                PageContext& out);

}  // namespace adore::adrplot
