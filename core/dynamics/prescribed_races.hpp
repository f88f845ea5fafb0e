#pragma once

#include "base/rotation.hpp"

#include <array>

/// What a deck makes of both races at one time, beside what acts on them: kept with the state of a
/// run, so that a run which goes on under other loads, speeds or laws of the time knows what
/// changed.
///
/// A race that is prescribed turns on from where it was, ψ(t) = ψ(t0) + ∫Ω dt, whatever its speed
/// was before: waves and lobes of its surface do not jump. A race that moves freely in some
/// directions keeps its state there; in the others place, attitude, velocity and speed take the
/// difference of what was prescribed and what is now. SI, rad, base axes.
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
