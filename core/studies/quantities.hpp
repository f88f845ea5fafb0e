#pragma once

#include "results/key_results.hpp"
#include "studies/study.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Results of a run for the quantities of the study.
namespace adore::studies {

/// Does one of them need RESULTS.h5?
[[nodiscard]] bool needs_channels(const std::vector<Quantity>& quantities);

struct QuantityValues {
  std::vector<double> values;  ///< one per quantity, SI; NaN: the run does not say
  std::string missing;         ///< a sentence that names missing quantities; empty: none
};

/// @param folder of the run's files
/// @param why reason for a missing key result, from the deck; may return nothing
/// @throws results::ReaderKilled, whose cause is not the run
[[nodiscard]] QuantityValues answer(const std::vector<Quantity>& quantities,
                                    const results::KeyResults& summary,
                                    const std::filesystem::path& folder,
                                    const std::function<std::string(const Quantity&)>& why);

/// Statistic of a sampled quantity. `values` holds `width` values for each time. Mean, rms and
/// deviation weigh time by the trapezoidal rule; percentiles count stored values.
[[nodiscard]] double statistic(Statistic of, double percent, const std::vector<double>& times,
                               const std::vector<double>& values, std::size_t width);

/// Value below which `percent` of the sorted values lie, linear between neighbors (the definition
/// of NumPy and of MATLAB's "exact"). NaN without values.
[[nodiscard]] double percentile_of_sorted(const std::vector<double>& sorted, double percent);

}  // namespace adore::studies
