#pragma once

#include "adrplot/spectrum.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Stored values of a curve before its spectrum: gaps and rounding.
namespace adore::adrplot {

/// End of the reasons of missing values.
inline constexpr std::string_view kNoSpectrum = ", so there is no frequency spectrum.";

/// Smaller changes are rounding, not vibration: a thousandth of the smallest range of an axis
/// (1e-13 m, 1e-9 N; 1e-12 W or of a pure number), `known` of its panel, 2e-13 of the magnitude of
/// the values, or the last of the eight digits of a text file.
[[nodiscard]] bool is_only_rounding(const std::vector<double>& values, const std::string& unit,
                                    double known);

/// Values of a curve for a spectrum. Gaps are interpolated linearly, with a note in `told`, if at
/// most 1 % of the values is missing and no gap is longer than half a period of the highest line
/// above 10 % of the largest. Otherwise there are no values, with a reason; gaps at the ends are
/// never filled.
struct BridgedValues {
  std::vector<double> values;
  std::string told, why_none;
};
[[nodiscard]] BridgedValues bridge_gaps(const std::vector<double>& t,
                                        const std::vector<double>& values, Window window);

/// The highest frequency with an amplitude above a level; 0: none.
[[nodiscard]] double highest_frequency_above(const std::vector<double>& frequency,
                                             const std::vector<double>& amplitude, double level);

}  // namespace adore::adrplot
