#pragma once

#include <limits>
#include <numbers>

/// Numbers that most of the solver needs.
namespace adore {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180.0;  ///< [rad]
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();  ///< not computed

}  // namespace adore
