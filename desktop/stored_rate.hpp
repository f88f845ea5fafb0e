#pragma once

#include <string>
#include <vector>

/// Storage interval of a run compared with its fastest contact. No Qt.
namespace adore::desktop {

/// Below so many values a period a line through stored values shows neither the shape of a
/// vibration nor its peaks: with six, the highest of them reaches 0.87 of the peak at worst.
inline constexpr double kTrueShape = 6.0;
/// With fewer points the lines show another, slower vibration.
inline constexpr double kAliased = 2.0;

/// The median: single steps may be longer or shorter. 0 of fewer than two times.
[[nodiscard]] double median_interval(const std::vector<double>& times);

/// Stored values in a period of `frequency` [Hz]; 0: not known.
[[nodiscard]] double values_per_period(const std::vector<double>& times, double frequency);

/// Note "Coarse: the fastest contact vibration, 26.3 kHz, has 2.2 stored steps per period ...";
/// empty if there are enough points, or for an unknown frequency. `every`: interval of the stored
/// steps among the times. @param beside_bands other lines of the picture have their extremes
[[nodiscard]] std::string coarse_storage_note(const std::vector<double>& times, double frequency,
                                              long every = 1, bool beside_bands = false);

}  // namespace adore::desktop
