#pragma once

#include "adrplot/page_builder.hpp"

#include <cstddef>
#include <filesystem>
#include <set>

/// What the files beside a plot file say about its run: frequencies of the bearing from RESULTS.h5,
/// the fastest contact from RUN.json, and the extremes between stored steps.
namespace adore::adrplot {

/// Mean frequencies of a run, measured over it [Hz]: of the shaft (inner against outer race), FTF
/// (the elements' orbit), BSF (an element's spin about itself, seen from its orbit), BPFO and BPFI
/// (elements that pass a point of the outer, inner race: n |f_orbit - f_race|), with twice and
/// three times them, and the cage's whirl. Those that the run holds.
[[nodiscard]] std::vector<desktop::ChartMark> bearing_frequencies(
    const std::filesystem::path& results_h5);

/// Everything for the pages of `file`; empty where the files beside it are of another run, or not
/// there. Never throws for a bad file.
[[nodiscard]] PageContext context_of(const results::SolFile& file);

/// Adds the extremes of these columns (places in sol_columns) where the context does not have them;
/// empty ones where RESULTS.h5 beside the file has none. Never throws for a bad file.
void read_bands(const results::SolFile& file, const std::set<std::size_t>& columns,
                PageContext& out);

}  // namespace adore::adrplot
