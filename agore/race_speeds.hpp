#pragma once

#include "agore/animation.hpp"

#include <string>

/// Rotation of the races, and divisor of the ratios of speeds: always inner minus outer race
/// (decision 776).
namespace adore::agore {

/// Divisor of a ratio of speeds.
enum class SpeedDivisor : unsigned char {
  Races,      ///< inner minus outer race, at the time of the value
  Mean,       ///< the same, on average over the file
  FasterRace  ///< as in the SOL file of a cage (N54): known if the outer race is at rest
};
/// Of the curves of the cage, or of an element (from 0).
[[nodiscard]] SpeedDivisor cage_speed_divisor(const Animation& animation);
[[nodiscard]] SpeedDivisor element_speed_divisor(const Animation& animation, std::size_t element);

/// Does the outer race turn, according to the known data?
[[nodiscard]] bool is_outer_race_rotating(const Animation& animation);

/// Do both races rotate together? Then their speed difference is 0, and ratios are relative to
/// their common speed.
[[nodiscard]] bool races_rotate_together(const Animation& animation);

/// "runs at 10000 rpm", "races at -8000 (outer) and 0 rpm (inner)"; empty without rotation.
[[nodiscard]] std::string speed_text(const Animation& animation);

/// Text of the divisor of a ratio: "inner minus outer race, 16000 rpm".
[[nodiscard]] std::string divisor_text(const Animation& animation, SpeedDivisor over);

}  // namespace adore::agore
