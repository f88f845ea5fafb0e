#pragma once

#include "contact/roller_race_sum.hpp"
#include "tribology/laws/rolling_resistance.hpp"

/// Rolling resistance of the slices of one roller on one race, each with the line force of its
/// load, speed and width: F back on the roller's surface, 2 F R'/r along the entrainment at its
/// axis, 1/R' the curvature of both bodies (rolling_resistance.hpp). Seen by the roller kernels.
namespace adore::statics {

/// Adds force, moment and heat of a slice. @param per_length F per length [N/m]
template <class T>
[[gnu::always_inline]] inline void add_rolling_resistance(const contact::LoadedSlice<T>& slice,
                                                          const contact::SliceContactState<T>& at,
                                                          const T& per_length,
                                                          const contact::RollerPose& roller,
                                                          contact::RollerRaceSums<T>& sum) {
  using contact::Triple;
  const T F = at.width * per_length;
  const Triple<T> push = T(2.0 * F / (at.curvature * at.radius)) * at.along;
  const Triple<T> drag = T(-F) * at.along;
  sum.force = sum.force + push + drag;
  sum.moment = sum.moment + cross(at.of_axis, push) + cross(slice.arm, drag);
  // Race less roller, as rigid motions, at the axis and at the surface.
  sum.heat += dot(push, roller.velocity + cross(roller.omega, at.of_axis)) + dot(drag, slice.slip);
}

/// For slices whose traction has no film: receiver of the slices of roller_race_sums.
template <class T>
struct SliceRollingResistance {
  const tribology::RollingResistance& law;
  const contact::RollerPose& roller;
  contact::RollerRaceSums<T>& sum;  ///< force, moment and heat are added

  [[gnu::always_inline]] void keep(const contact::LoadedSlice<T>& slice,
                                   const contact::SliceContactState<T>& at) const {
    add_rolling_resistance(slice, at,
                           law.force(tribology::ContactConditions<T>{
                               at.load_per_length, at.peak_pressure, T(0.0), at.half_width,
                               at.entrainment, at.slip, at.curvature}),
                           roller, sum);
  }
};

}  // namespace adore::statics
