#pragma once

#include "base/scalar_math.hpp"
#include "contact/slice_circle.hpp"
#include "contact/triple.hpp"

/// What the edge of a land does to a roller that reaches over it: U_k = 9/19 Q_k δ_k has the width
/// w_k of the slice that lies on the land as a factor, so that its energy falls as the slice leaves
/// the land, and
///   ∂U_k/∂x = 9/19 Q_k δ_k/w_k w'_k/cos α,   w'_k = ∓1 at the edge at ±x, else 0
/// pushes the roller off the land along its generator: energy per length of the contact, 0.1 to
/// 0.3 % of its load, for each edge [derived]. Without it a roller that slides over an edge to and
/// fro takes energy from nowhere. The place of a slice is slice_axial_position,
///   x_k = x + s_k a_x + σ ρ_k b1_x,  b1_x = -t/m,  t = a_z, f = a_y, m² = 1 - f².
/// Plain numbers in the meridian frame, for kernels too. SI.
/// Limit: the force begins at once when the outermost slice reaches the edge; stresses at edges are
/// not those of independent slices.
namespace adore::contact {

/// Where a slice lies along the race's axis, for the edges of its land: its circle's point in the
/// meridian plane of the roller. It goes with the pose of the roller axis alone, not with the
/// place where the circle is deepest (second order in the skew) [choice]. x of C on the race axis.
template <class T>
[[nodiscard, gnu::always_inline]] inline T slice_axial_position(const RaceSurface& race,
                                                                const SliceAxes& axes, double x,
                                                                const T& s, const T& radius) {
  return x + axes.a.x * s + (race.sigma() * axes.b1.x) * radius;
}

template <class T>
struct LandEdgeForce {
  T force = 0.0;         ///< Σ ∂U_k/∂x_k [N]
  T along = 0.0;         ///< Σ s_k ∂U_k/∂x_k [N m]
  T across = 0.0;        ///< Σ ρ_k ∂U_k/∂x_k [N m]
  bool reached = false;  ///< some slice reaches over an edge

  /// @param narrows w', 0 where a slice lies on the land or beyond it
  void add(const T& load, const T& depth, const T& width, const T& narrows, double cos_angle,
           const T& s, const T& radius) {
    using M = ScalarMath<T>;
    constexpr double kShare = 9.0 / 19.0;
    const T out = (kShare / cos_angle) * load * depth / M::max(width, T(1e-30)) * narrows;
    force += out;
    along += out * s;
    across += out * radius;
    reached = true;
  }

  /// Adds force and moment about C on the roller, minus the gradient of U. @param r of C
  void add_to_roller(const SliceAxes& axes, double sigma, double r, Triple<T>& on,
                     Triple<T>& about) const {
    const double f = axes.a.y, t = axes.a.z, m = std::sqrt(1.0 - f * f);
    // ∂x over the components of a.
    const Triple<T> over{along, (-sigma * t * f / (m * m * m)) * across, (-sigma / m) * across};
    const Triple<T> moment = cross(over, axes.a);
    on.x -= force;
    // Nothing turns the race about its axis.
    on.y += moment.x * (1.0 / r);
    about = about + moment;
  }
};

}  // namespace adore::contact
