#pragma once

#include "contact/line_contact.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_profile.hpp"

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

/// Forces of one roller on one race with their exact derivatives.
///
/// A race is a surface of revolution, so a roller's pose relative to it has four coordinates,
///   p = (x, r, t, f):  middle C at x along and r from the race axis; roller axis
///   a = (√(1-t²-f²), f, t) in the race's axes (x along it, z from it to C, y = z × x).
/// The slice loads derive from U(p) = Σ ∫Q_k dδ_k, δ_k the penetration of
/// contact/slice_contact.hpp. δ_k is a maximum over the slice circle, position χ, so that [derived]
///   ∂δ/∂p = n·X_p,   ∂²δ/∂p∂q = n·X_pq + X_p·N X_q - δ_χp δ_χq/δ_χχ,
/// X the contact point at fixed χ and N = ∇∇φ the curvature tensor of the race's distance function:
/// n_r/r across the meridian, 1/l along it on a groove.
/// The width of a slice on the land depends on its place along the race, and U with it
/// (contact/land_edge.hpp; the linear slices, of reference family D, leave that out).
namespace adore::statics {

using Vec4 = Eigen::Matrix<double, 4, 1>;
using Mat4 = Eigen::Matrix<double, 4, 4>;

/// dU over p and its derivative.
struct PairPotential {
  Vec4 gradient = Vec4::Zero();  ///< ∂U/∂p [N, N, N m, N m]
  Mat4 hessian = Mat4::Zero();   ///< derivative of the gradient over p
  double total = 0.0;            ///< Σ Q_k [N]
  double stiffness = 0.0;        ///< Σ dQ_k/dδ [N/m]
};

/// Slices of one roller against one race.
struct SliceSet {
  contact::RaceSurface race;
  std::span<const contact::RollerSlice> slices;
  double width = 0.0;  ///< of each slice [m]
  contact::PowerLaw law;
};

/// Adds the slice loads at p. `each` (if not empty, one per slice) receives penetration, contact
/// width and load.
struct SliceResult {
  double delta = 0.0, width = 0.0, load = 0.0, slope = 0.0;
  double rolling_curvature = 0.0;         ///< of the race, to be added to 1/ρ [1/m]
  double normal_x = 0.0, normal_r = 0.0;  ///< of n in the race's meridian plane of C
};
void add_slices(const SliceSet& set, const Vec4& p, PairPotential& sum,
                std::span<SliceResult> each = {});

/// First order in everything about an aligned roller on a cylinder: δ = σ(r + s t - R) + ρ.
void add_slices_linear(const SliceSet& set, const Vec4& p, PairPotential& sum,
                       std::span<SliceResult> each = {});

/// One elliptical contact Q = K δ^1.5 of a barrel in a groove: the same geometry with the arc's
/// centre as a slice of (negative) radius ρ_A and a groove of radius r_g - Rc.
/// The arc ends where the corners begin. Where the normal through both centres meets the roller
/// beyond that, or on its far side, δ is that of the deeper end: the deepest point of the arc that
/// exists, with a continuous gradient [derived].
struct PointContactSet {
  contact::RaceSurface race;    ///< groove_radius = r_g - Rc
  contact::RollerSlice centre;  ///< s_A = -Rc sin ν, ρ_A = D/2 - Rc cos ν
  double K = 0.0;
  double crown_radius = 0.0;                 ///< Rc [m]
  contact::RaceSurface groove;               ///< as it is
  std::array<contact::RollerSlice, 2> ends;  ///< of the arc: -s, +s
};
void add_point_contact(const PointContactSet& set, const Vec4& p, PairPotential& sum,
                       SliceResult* each = nullptr);

}  // namespace adore::statics
