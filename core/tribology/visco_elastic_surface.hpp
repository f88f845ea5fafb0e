#pragma once

#include "tribology/laws/visco_elastic_film.hpp"
#include "tribology/lubricant.hpp"

#include <array>
#include <memory>
#include <vector>

/// The surface of laws/visco_elastic_film.hpp, made at set-up from the integral along the strip
/// (viscoelastic_strip.hpp). It is refined, from coarse to fine in three sizes, until the root of
/// the mean square of its errors on a hold-out grid is below what is wanted, and the largest of
/// them (where films turn from liquid to solid, within a factor of three of γ_r) below ten times
/// that. A process keeps the surfaces that it made: both races, the equilibrium, the plan and the
/// run share them.
namespace adore::tribology {

/// Peak pressures of strips that the surface covers [Pa]. Below, the elastic part of the slope goes
/// as ln p, which no spline over √p follows, and contacts carry micronewtons.
inline constexpr double kSurfacePressure[2] = {1e6, 5e9};

struct ViscoElasticSurface {
  ViscoElasticFilm film;  ///< points into the table
  std::shared_ptr<const std::vector<double>> table;
  /// Relative errors of κ on the hold-out grid: the largest, and the root of the mean square.
  std::array<double, 2> error{};
  double wanted = 0.0;                ///< of the second
  std::array<std::size_t, 3> size{};  ///< values over transit, pressure and slip
  int evaluations = 0;                ///< of the strip
  int held_out = 0;                   ///< places of the hold-out grid
  double speed[2] = {};               ///< rolling speeds that it covers, at least [m/s]
};

/// Wanted relative error of κ of a run with a tolerance of 1e-6 [choice]: a tenth of what the
/// constants are known to at best.
inline constexpr double kSurfaceError = 5e-3;
/// Largest error that is wanted, over the wanted root of the mean square [choice].
inline constexpr double kLargestOverMean = 10.0;
/// 5 √tolerance, at least 1e-3 (what the integral itself is known to) and at most 1e-2 [choice].
[[nodiscard]] double target_surface_error(double tolerance);

/// @param width_over_pressure b/p0 of the contacts [m/Pa]
/// @param race_speed scale of the rolling speeds [m/s]
[[nodiscard]] ViscoElasticSurface visco_elastic_surface(const Lubricant& lubricant,
                                                        double temperature,
                                                        double width_over_pressure,
                                                        double race_speed,
                                                        double wanted = kSurfaceError);

/// The film without a surface: every strip is integrated.
[[nodiscard]] ViscoElasticFilm direct_visco_elastic_film(const Lubricant& lubricant,
                                                         double temperature);

/// A body under the film.
struct FilmWall {
  double conductivity = 0.0;   ///< [W/(m K)]
  double heat_capacity = 0.0;  ///< ρc [J/(m³ K)]
};
/// Makes walls hotter than their bodies (iTherm).
void set_wall_heating(ViscoElasticFilm& film, const Lubricant& lubricant, double temperature,
                      const std::array<FilmWall, 2>& walls);

/// κ of a strip without a surface: peak pressure, γ = slip/h [1/s] and b/u [s].
[[nodiscard]] double visco_elastic_strip_coefficient(const Lubricant& lubricant, double temperature,
                                                     double peak, double shear_rate,
                                                     double transit);

}  // namespace adore::tribology
