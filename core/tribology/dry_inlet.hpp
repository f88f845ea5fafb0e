#pragma once

namespace adore::tribology {

/// Meniscus that represents an inlet without oil (strParam 0) in the laws of films, whose
/// logarithms need one: far too near for any film. The thickness of such a film is rounding,
/// reported as 0.
inline constexpr double kDryMeniscus = 1e-9;

}  // namespace adore::tribology
