#pragma once

#include "results/channels.hpp"

#include <span>
#include <vector>

namespace adore::results {

/// A table, with lowest, highest and mean value since the step stored before ("X_low", "X_high",
/// "X_mean") behind each channel X that is looked at between stored steps (step_band.hpp).
[[nodiscard]] std::vector<Channel> with_band_channels(std::span<const Channel> table);

}  // namespace adore::results
