#pragma once

#include "adrplot/plot_document.hpp"

/// RESULTS.h5: all channels of all bodies of a run, whether they are monitored or not.
namespace adore::adrplot {

/// One page per channel and at most three panels: a panel for each race, flange, pocket surface or
/// component, a curve for each rolling element or body. Values in the units of the classic files
/// (deg, rpm). Only the values of shown channels are read; of a channel with more than
/// `most_values` values every n-th step. A channel that this version does not know has the label
/// and unit of the file.
/// @throws InputError for a file that is not ours or damaged
[[nodiscard]] PlotDocument open_h5(const std::filesystem::path& path,
                                   const results::SolRange& range, std::size_t most_values);

}  // namespace adore::adrplot
