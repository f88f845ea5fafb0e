#pragma once

#include "adrplot/page_builder.hpp"
#include "results/h5_reader.hpp"

#include <cstddef>
#include <filesystem>
#include <set>

/// Data of the run from the files next to a plot file: bearing frequencies from RESULTS.h5, the
/// fastest contact from RUN.json, and extremes between stored steps.
namespace adore::adrplot {

/// Mean frequencies of a run, measured over it [Hz]: shaft (inner relative to outer race), FTF
/// (orbit of the elements), BSF (spin of an element relative to its orbit), BPFO and BPFI (elements
/// that pass a point of the outer or inner race: n |f_orbit - f_race|), with twice and three times
/// these values, and the whirl of the cage. Only those contained in the run.
[[nodiscard]] std::vector<desktop::ChartMark> bearing_frequencies(
    const std::filesystem::path& results_h5);

/// Rotation of shaft, elements and cage at some hundred of the steps of a run.
[[nodiscard]] std::vector<MarkEventCounts> mark_event_counts(const results::H5Reader& reader);

/// All data for the pages of `file`; empty if the files in its folder are from another run or
/// missing. Never throws for an invalid file.
[[nodiscard]] PageContext page_context_of(const results::SolFile& file);

/// Adds the extremes of these columns (indices in sol_columns) if missing in the context; empty
/// ones if RESULTS.h5 has none. Never throws for an invalid file.
void read_min_max_bands(const results::SolFile& file, const std::set<std::size_t>& columns,
                        PageContext& out);

}  // namespace adore::adrplot
