#pragma once

#include "base/finding.hpp"
#include "statics/contact_films.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What every quasi-static solution says of the inner race.
namespace adore::statics {

struct RaceResult {
  /// Inner race minus its free position, the datum that the deck's geometry alone fixes (decision
  /// 140): x, y, z of its reference point [m] (the outer race does not translate), tilts about y
  /// and z [rad] measured from the base frame, R = R_y R_z; an outer misalignment tilts the outer
  /// race the same way. The reference point is the centre of the groove-centre circle for balls,
  /// the middle of the bearing (x = 0 of the row) for rollers.
  std::array<double, 5> displacement{};
  std::array<double, 5> load{};  ///< what the shaft side applies to the inner race in this state
                                 ///< (given or reaction) [N, N m]
  Eigen::Matrix<double, 5, 5>
      stiffness;               ///< d load / d displacement, exact linearisation at fixed speed
  double max_load = 0.0;       ///< largest element-race contact load [N]
  double max_stiffness = 0.0;  ///< largest dQ/dδ of any element-race contact [N/m]; 0 when nothing
                               ///< is loaded
  double max_deflection = 0.0;  ///< largest approach of any element-race contact [m]
  /// The same by displacing the race (stiffness_difference.hpp); only where it was asked for.
  std::optional<Eigen::Matrix<double, 5, 5>> stiffness_by_difference;
  double difference_step = 0.0;  ///< of that displacement [m]
  /// Stable equilibria found beside an unstable one (displacement as above); empty when the
  /// equilibrium is stable, or when nothing was found.
  std::vector<std::array<double, 5>> other_equilibria;
  std::optional<LubricantFilms> films;  ///< with a lubricant, once computed (contact_films)
  int iterations = 0;
  double residual = 0.0;       ///< largest force residual over the load scale
  std::vector<Finding> notes;  ///< statics.outer_only, statics.held ...
};

}  // namespace adore::statics
