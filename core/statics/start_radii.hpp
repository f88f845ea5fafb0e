#pragma once

#include "bearing/bearing.hpp"
#include "contact/race_surface.hpp"
#include "statics/ball_friction.hpp"
#include "statics/ball_statics.hpp"

#include <memory>
#include <optional>
#include <span>

/// Elements that are out of round (user routine ADRX5) in equilibria. At the start of a motion the
/// axes of each element are those of its azimuth frame, its z axis points outward: a roller touches
/// the outer race at azimuth 0 of its own and the inner race at π, a ball in the directions of its
/// contact angles. An equilibrium is that of the radii there. SI, rad.
namespace adore::statics {

using Forms = std::span<const std::shared_ptr<const bearing::SurfaceSeries>>;

/// Radius of a race that acts as 1 of the radius of its rollers: 1/n_r, n_r the radial part of the
/// nominal contact normal.
[[nodiscard]] double race_growth(const contact::RaceSurface& race);

/// The bearing for its statics. Rollers: a larger roller is a smaller outer and a larger inner race
/// at its azimuth; a series takes radius, taper and their slopes there,
///   p(ψ) = Σ_k (v_k + s_k sin(ψ - ψ_k)) F(ψ - ψ_k),  F(x) = (sin(nx/2)/(n sin(x/2)))² [derived].
/// @return empty: a race with a table or land offsets; rollers keep their mean radius
[[nodiscard]] std::optional<bearing::Bearing> with_start_radii(const bearing::Bearing& bearing,
                                                               Forms forms);

/// Balls in equilibrium, and in friction equilibrium (solve_ball_friction_balance). Not round:
/// loads are those of a diameter that has the heights h at both contacts more, and the ball is (h_o
/// - h_i)/2 nearer to the inner race. The contact angles of round balls are the places, then those
/// found there.
[[nodiscard]] StaticSolution solve_balls_with_friction(const bearing::Bearing& bearing,
                                                       const BallStaticsOptions& options,
                                                       Forms forms, FrictionBalance& balance);

}  // namespace adore::statics
