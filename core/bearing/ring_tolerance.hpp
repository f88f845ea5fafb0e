#pragma once

#include "bearing/size_limits.hpp"

#include <string>
#include <string_view>

/// Tolerances of bearing rings (classes of ISO 492) and their fits on shaft and in housing.
namespace adore::bearing {

enum class RingToleranceClass : unsigned char { Normal, Six, Five, Four, Two };

/// "Normal", "P0" or "0", "6" or "P6", "5", "4", "2". @throws InputError naming the classes
[[nodiscard]] RingToleranceClass ring_class(std::string_view name);

/// Deviations of the mean diameter in a plane, of radial bearings that are not tapered: the bore
/// and the outside diameter are at most nominal.
struct RingTolerance {
  SizeLimits limits;
  bool seen = true;  ///< false: recalled, not compared with a printed table
};
/// @param nominal [m] @throws InputError when the class does not have this size
[[nodiscard]] RingTolerance bore_tolerance(RingToleranceClass ring, double nominal);
[[nodiscard]] RingTolerance outside_diameter_tolerance(RingToleranceClass ring, double nominal);

/// Interference of two mating diameters, on the diameter; < 0: clearance [m]. Probable limits:
/// both sizes vary independently, so that the tolerances add as squares about the mean.
struct Interference {
  double least = 0.0, mean = 0.0, most = 0.0;
  double probable_least = 0.0, probable_most = 0.0;
};
[[nodiscard]] Interference interference(const SizeLimits& inner_part, const SizeLimits& outer_part);

}  // namespace adore::bearing
