#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace adore::dynamics {

/// Sums over all elements of one race at this evaluation.
struct RaceContactTotals {
  double power = 0.0;                          ///< that the race exerts on elements and cage [W]
  double heat = 0.0;                           ///< [W]
  double damping = 0.0;                        ///< power that damping takes [W]
  double rolling = 0.0;                        ///< rolling resistance of rollers [W]
  std::vector<double> rolling_of, damping_of;  ///< the same by roller; empty: none, or balls [W]
  double load_slip = 0.0;                      ///< ∫ p u dA [W]
  double load_slip_element1 = 0.0;
  /// What holds or loads the race, as reported, for a look [N, N m].
  std::array<double, 3> force{}, moment{};

  template <class Vector>
  void keep(const Vector& of_force, const Vector& of_moment) noexcept {
    for (int k = 0; k < 3; ++k) {
      force[static_cast<std::size_t>(k)] = of_force[k];
      moment[static_cast<std::size_t>(k)] = of_moment[k];
    }
  }
};

}  // namespace adore::dynamics
