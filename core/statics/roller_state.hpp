#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace adore::statics {

/// Where a roller is, and how it moves with the inner race.
struct RollerState {
  std::size_t number = 0;
  double sin = 0.0, cos = 1.0;                  ///< of the azimuth
  double skew_sin = 0.0, skew_cos = 1.0;        ///< of the skew, its axis towards y; given
  Eigen::Vector3d e = Eigen::Vector3d::Zero();  ///< x, r - d_m/2 [m], tilt + axis angle [rad]
  bool known = false;                           ///< e comes from an earlier equilibrium
  bool idle = false;                            ///< at rest and touching nothing
  Eigen::Matrix<double, 3, 5> follow = Eigen::Matrix<double, 3, 5>::Zero();  ///< de/dq
};

}  // namespace adore::statics
