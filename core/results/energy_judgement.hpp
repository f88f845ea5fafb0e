#pragma once

#include "scene/ledger.hpp"

#include <string>

/// Is the energy that a run cannot account for small enough to trust what it prints?
namespace adore::results {

/// Limits of |residual|: over the energy that moved (work or heat, energy_scale(), which has a
/// floor), and over the elastic energy of the quasi-static solution, which is what contact
/// vibration is measured by.
inline constexpr double kMovedWarning = 1e-4, kMovedLimit = 1e-2;
inline constexpr double kElasticWarning = 0.02, kElasticLimit = 0.5;
/// Of |residual| at the end over the heat (heat_scale()): the energy that moved may be much larger
/// than the heat, which then is an error of the integration to that share.
inline constexpr double kHeatWarning = 0.05;

enum class Trust : unsigned char { Full, Warned, None };

struct EnergyJudgment {
  Trust trust = Trust::Full;
  double over_moved = 0.0;    ///< |residual| / energy moved; 0 when nothing moved
  double over_heat = 0.0;     ///< |residual| / heat; 0 without heat
  double over_elastic = 0.0;  ///< |residual| / elastic energy; 0 when nothing is loaded
  std::string text;           ///< a sentence when trust is not Full
};

/// A NaN residual is never trusted.
/// @param elastic elastic energy of the quasi-static solution [J]; 0 without a reference:
/// nothing is loaded, or elements in balance (modes 1 and 2) do not vibrate
/// @param largest largest |residual| of the run at any stored step [J]: a temporary one is
/// warned of (contacts that open and close take energy and return it within a vibration). If one
/// above a limit ends above a warning, the run is not trusted (decision 482)
[[nodiscard]] EnergyJudgment judge_energy(const scene::EnergyLedger& energy, double elastic,
                                          double largest = 0.0);

}  // namespace adore::results
