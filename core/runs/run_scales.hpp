#pragma once

#include "deck/deck.hpp"

#include <map>
#include <string>

namespace adore::runs {

/// Conversion of the deck's dimensionless times to seconds and revolutions.
struct RunScales {
  double time = 0.0;              ///< unit of stpInit, stpMin, stpMax and fTime [s]
  double turns_per_second = 0.0;  ///< of the shaft, inner against outer race [1/s]; 0: no turns
};

/// Solves the equilibrium for it. @param options run options that are given
/// @throws InputError for a quasi-static deck and as prepare(), SolverError
[[nodiscard]] RunScales run_scales(const deck::Deck& deck,
                                   const std::map<std::string, std::string>& options);

}  // namespace adore::runs
