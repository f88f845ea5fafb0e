#pragma once

#include "bearing/bearing.hpp"

#include <cstddef>

/// Inertia of single rolling elements.
namespace adore::bearing {

/// Of element i from 0: element 1 may have its own (record 6.1); another ball, computed or given as
/// that of the nominal one, follows its diameter, m ~ D³ and I ~ D⁵ with the mass center at the
/// same place. Rollers have that of the nominal roller.
[[nodiscard]] inline Inertia inertia_of(const Bearing& bearing, std::size_t i) {
  if (i == 0 && bearing.first_inertia) return *bearing.first_inertia;
  Inertia out = bearing.element_inertia;
  const auto& growth = bearing.imperfections.ball_diameter;
  if (i >= growth.size() || growth[i] == 0.0) return out;
  const double ratio = (bearing.element_diameter() + growth[i]) / bearing.element_diameter();
  out.mass *= ratio * ratio * ratio;
  out.moments *= ratio * ratio * ratio * ratio * ratio;
  return out;
}

/// Radius of ball i, or of a nominal roller [m].
[[nodiscard]] inline double element_radius(const Bearing& bearing, std::size_t i) {
  const auto& growth = bearing.imperfections.ball_diameter;
  return 0.5 * (bearing.element_diameter() + (i < growth.size() ? growth[i] : 0.0));
}

/// Do balls differ in their diameter?
[[nodiscard]] inline bool has_unequal_balls(const Bearing& bearing) noexcept {
  for (const double growth : bearing.imperfections.ball_diameter)
    if (growth != 0.0) return true;
  return false;
}

}  // namespace adore::bearing
