#pragma once

#include "contact/triple.hpp"
#include "statics/dual.hpp"

#include <array>

namespace adore::statics {

using contact::Triple;

/// Axis of a race tilted by ξ about y, then ζ about the new z: R e_x.
template <class S>
Triple<S> tilted_axis(const S& about_y, const S& about_z) {
  const S cy = cosine(about_y);
  const S cz = cosine(about_z);
  return {cy * cz, sine(about_z), -(sine(about_y) * cz)};
}

/// Pose of a race, base frame.
template <class S>
struct RacePose {
  Triple<S> centre{S(0.0), S(0.0), S(0.0)};  ///< [m]
  Triple<S> axis{S(1.0), S(0.0), S(0.0)};    ///< unit vector
  std::array<S, 5>
      q{};  ///< x, y, z, about y, about z: displacement from the free position (linear kinematics)
};

}  // namespace adore::statics
