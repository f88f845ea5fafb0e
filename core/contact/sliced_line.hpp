#pragma once

#include "contact/line_contact.hpp"
#include "contact/roller_profile.hpp"

#include <vector>

/// A sliced roller against a straight race in the plane of its axis: δ_k = δ0 + slope x_k - drop_k,
/// power law. SI. The small-angle form of slice_contact.hpp for cylinders; what simple quasi-static
/// models use. Accuracy of the midpoint rule: load 0.1 % with 20 slices straight, 43 fully crowned
/// (R_c 1.8 m, L 12 mm); the moment of a pure small tilt is low by 1/n² [derived].
namespace adore::contact {

struct SlicedLine {
  std::vector<double> x, width, drop;  ///< of each slice [m]
  PowerLaw law;
};

/// Slices of a profile with widths cut to a land of width B about o (B infinite: no limit); drops
/// from the straight side.
[[nodiscard]] SlicedLine sliced_line(const RollerProfile& profile, int count, double line_constant,
                                     double land_width = std::numeric_limits<double>::infinity(),
                                     double land_offset = 0.0);

struct LineResultant {
  double load = 0.0;    ///< Q = Σ Q_k [N]
  double moment = 0.0;  ///< M = Σ Q_k x_k [N m]
  double load_by_approach = 0.0, load_by_slope = 0.0,
         moment_by_slope = 0.0;  ///< ∂Q/∂δ0, ∂Q/∂slope = ∂M/∂δ0, ∂M/∂slope
  int loaded = 0;                ///< slices that carry load
  double largest_load = 0.0;     ///< of a slice [N]
  double largest_delta = 0.0;    ///< [m]
};
/// Hot path: no allocation.
[[nodiscard]] LineResultant line_resultant(const SlicedLine& line, double delta0,
                                           double slope) noexcept;

/// δ0 that gives the load Q at this slope. Q(δ0) is convex, so Newton from above falls to the root
/// without overshooting.
/// @throws InputError when Q is not positive or no slice has width; SolverError when it does not
/// converge.
[[nodiscard]] double approach_for_load(const SlicedLine& line, double slope, double load);

}  // namespace adore::contact
