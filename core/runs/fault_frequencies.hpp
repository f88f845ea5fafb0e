#pragma once

#include "results/averages.hpp"
#include "results/key_results.hpp"
#include "runs/prepare.hpp"

#include <optional>
#include <string>
#include <vector>

/// Frequencies at which a flaw of one part is passed [Hz]: outer race (BPFO), inner race (BPFI),
/// spin of an element relative to the cage (BSF; a flaw of the element strikes a race at twice
/// this), cage (FTF). Nominal: rolling without slip at the free contact angle of the bearing as it
/// is made. Computed: from the orbital (cage) and spin speeds of the solution.
namespace adore::runs {

struct FaultFrequencies {
  double outer = 0.0, inner = 0.0;
  std::optional<double> spin;  ///< not averaged over a motion
  double cage = 0.0;           ///< signed, about +x
};

[[nodiscard]] FaultFrequencies nominal_fault_frequencies(const Prepared& prepared);
/// Of the equilibrium: mean over the loaded elements, or all if none is loaded.
[[nodiscard]] FaultFrequencies equilibrium_fault_frequencies(const Prepared& prepared);
/// Of a motion, from the mean speed of the elements relative to the speed of the races; empty when
/// the races do not turn at constant speeds or nothing was averaged.
[[nodiscard]] std::optional<FaultFrequencies> motion_fault_frequencies(
    const Prepared& prepared, const results::Averages& averages);

/// bpfo_nominal_Hz ... ftf_nominal_Hz, and bpfo_Hz ... ftf_Hz of `computed`.
void add_fault_frequencies(results::KeyResults& out, const Prepared& prepared,
                           const std::optional<FaultFrequencies>& computed);
/// Two sentences; none when the races turn together.
[[nodiscard]] std::vector<std::string> fault_frequency_lines(
    const Prepared& prepared, const std::optional<FaultFrequencies>& computed);

}  // namespace adore::runs
