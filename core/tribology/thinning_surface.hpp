#pragma once

#include "tribology/laws/shear_thinning_law.hpp"
#include "tribology/spline_axes.hpp"

#include <array>
#include <memory>
#include <vector>

/// The surface of laws/shear_thinning_law.hpp, made at set-up from its equation solved to the end:
/// ln(τ/(G r0)) over ln r0 and ½ ln D0, from where neither thinning nor heating is felt (3e-4 of
/// the modulus, S = 3e-4: 1e-7 of the stress) to e^40 and e^16, beyond what glass does. One for
/// each n; refined in three sizes until the largest of its errors on a hold-out grid is below what
/// is wanted. A process keeps those that it made.
namespace adore::tribology {

struct ThinningSurface {
  SplineAxis log_rate, log_heat;
  std::shared_ptr<const std::vector<double>> table;
  std::shared_ptr<const Tiles> tiles;  ///< the same as powers of each cell
  /// Relative errors of the stress on the hold-out grid: the largest, and the root of the mean
  /// square.
  std::array<double, 2> error{};
  double wanted = 0.0;                ///< of the first
  std::array<std::size_t, 2> size{};  ///< values over ln r0 and ½ ln D0
  int held_out = 0;
  /// Makes the film read it, which then needs the table.
  void give(ShearThinningFriction& film) const;
};

/// Wanted largest relative error of a stress: 0.6 √tolerance, at least 5e-5 and at most the 7e-4
/// that solving a point may err by [choice].
[[nodiscard]] double target_thinning_error(double tolerance);
[[nodiscard]] ThinningSurface thinning_surface(double half_power, double wanted);

/// ln(τ/(G r0)) of the equation. @param rate, heat ln r0 and ½ ln D0
[[nodiscard]] double log_stress_ratio(double half_power, double rate, double heat) noexcept;

}  // namespace adore::tribology
