#pragma once

#include "base/rotation.hpp"

#include <array>

/// Prescribed motion of both races at one time: stored with the state of a
/// run, so that a run that continues under other loads, speeds or laws of time knows the
/// changes.
///
/// A prescribed race continues to turn from its position, ψ(t) = ψ(t0) + ∫Ω dt, for any previous
/// speed: waves and lobes of its surface do not jump. A race that moves freely in some
/// directions keeps its state there; in the others position, attitude, velocity and speed take the
/// difference between the previous and the present prescription. SI, rad, base axes.
namespace adore::dynamics {

struct PrescribedRace {
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
  Quat attitude{1, 0, 0, 0};   ///< without its turn
  double speed = 0.0;          ///< about its axis
  double angle = 0.0;          ///< that it has turned, whether prescribed or not
  double turned_before = 0.0;  ///< part of `angle` beyond what the deck's speeds make of the time
};
using PrescribedRaces = std::array<PrescribedRace, 2>;

}  // namespace adore::dynamics
