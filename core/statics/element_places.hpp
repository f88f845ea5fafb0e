#pragma once

#include "statics/ball_statics.hpp"
#include "statics/race_equilibrium.hpp"
#include "statics/roller_statics.hpp"

#include <optional>
#include <span>
#include <vector>

/// Quasi-static places of rolling elements at any azimuths: the same balance as ball_statics.hpp
/// and roller_statics.hpp, for a bearing in motion, whose elements are not equally spaced.
///
/// Each element is in balance of its normal forces, centrifugal force, gyroscopic moment and field
/// forces in its azimuth plane; the force along its orbit is left out. Where a load of the inner
/// race is specified, the race is in balance, too; where its displacement is given, it stays.
namespace adore::statics {

/// Element in balance; vectors on e_x, e_r, e_θ.
struct ElementPosition {
  double x = 0.0, r = 0.0;                          ///< centre of a ball, middle of a roller [m]
  double tilt = 0.0;                                ///< of a roller axis [rad]
  double load = 0.0;                                ///< larger of both race loads [N]
  double orbital_speed = 0.0;                       ///< of pure rolling [rad/s]
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< of pure rolling, absolute [rad/s]
};

struct ElementPositions {
  Vec5 race = Vec5::Zero();       ///< displacement of the inner race [m, rad]
  Mat5 stiffness = Mat5::Zero();  ///< of the race on its elements [N/m ...]
  Vec5 load = Vec5::Zero();       ///< of the race [N, N m]
  std::vector<ElementPosition> elements;
  std::vector<StaticBall> balls;  ///< the same with all figures; one of both is empty
  std::vector<StaticRoller> rollers;
};

/// Statics of one bearing.
struct ElementPositionModel {
  const bearing::Bearing& bearing;  ///< its constraints give the misalignment of the outer race
  BallStaticsOptions balls;
  RollerOptions rollers;
  /// Constant Hertz constants and one orbital speed for all balls: a convex problem with a solution
  /// wherever there is one.
  bool conservative = false;
};

/// @param azimuth of every element [rad]
/// @param guess displacement of the inner race; given directions stay there
/// @return nothing when there is no equilibrium
[[nodiscard]] std::optional<ElementPositions> element_places(const ElementPositionModel& model,
                                                             std::span<const double> azimuth,
                                                             const RaceLoadCase& task,
                                                             const Vec5& guess);

}  // namespace adore::statics
