#pragma once

#include <array>
#include <vector>

namespace adore::life {

/// Factors of ISO 281 for bearings of 15 degrees, by relative axial load f0 Fa/C0 [recalled].
struct SpindleRows {
  double X = 0.0;
  std::vector<std::array<double, 3>> rows;  ///< relative load, e, Y
};
/// Of resources/life_constants.json.
[[nodiscard]] const SpindleRows& spindle_rows();

}  // namespace adore::life
