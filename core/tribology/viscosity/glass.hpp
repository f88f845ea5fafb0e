#pragma once

#include <algorithm>

namespace adore::tribology {

/// Every viscosity law ends here: a liquid of 1e12 Pa s is a glass. ln(1e12).
inline constexpr double kLogGlassViscosity = 27.631021115928547;

/// ln μ, at most that of the glass; also for NaN (outside of a law).
[[nodiscard]] inline double liquid(double log_viscosity) {
  return log_viscosity < kLogGlassViscosity ? log_viscosity : kLogGlassViscosity;
}

}  // namespace adore::tribology
