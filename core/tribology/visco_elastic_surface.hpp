#pragma once

#include "tribology/laws/visco_elastic_film.hpp"
#include "tribology/lubricant.hpp"

#include <array>
#include <memory>
#include <vector>

/// The surface of laws/visco_elastic_film.hpp, made at set-up from the integral along the strip
/// (viscoelastic_strip.hpp). It is refined until its error in the middles of its cells, a hold-out
/// grid, is below what is wanted, at most twice.
namespace adore::tribology {

/// Peak pressures of strips that the surface covers [Pa].
inline constexpr double kSurfacePressure[2] = {1e4, 5e9};

struct ViscoElasticSurface {
  ViscoElasticFilm film;  ///< points into the table
  std::shared_ptr<const std::vector<double>> table;
  /// Relative errors of κ on the hold-out grid: the largest, and the root of the mean square.
  std::array<double, 2> error{};
  int evaluations = 0;   ///< of the strip
  double speed[2] = {};  ///< rolling speeds that it covers [m/s]
};

/// Wanted relative error of κ [choice]: a tenth of what the constants are known to at best.
inline constexpr double kSurfaceError = 5e-3;

/// @param width_over_pressure b/p0 of the contacts [m/Pa]
/// @param race_speed scale of the rolling speeds [m/s]
[[nodiscard]] ViscoElasticSurface visco_elastic_surface(const Lubricant& lubricant,
                                                        double temperature,
                                                        double width_over_pressure,
                                                        double race_speed,
                                                        double wanted = kSurfaceError);

/// κ of a strip without a surface: peak pressure, γ = slip/h [1/s] and b/u [s].
[[nodiscard]] double visco_elastic_strip(const Lubricant& lubricant, double temperature,
                                         double peak, double shear_rate, double transit);

}  // namespace adore::tribology
