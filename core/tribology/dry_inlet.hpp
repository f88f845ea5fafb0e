#pragma once

namespace adore::tribology {

/// Meniscus that stands for an inlet without oil (strParam 0) in the laws of films, whose
/// logarithms need one: far too near for any film. What such a film is said to be is rounding, told
/// as 0.
inline constexpr double kDryMeniscus = 1e-9;

}  // namespace adore::tribology
