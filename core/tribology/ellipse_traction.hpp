#pragma once

#include "bearing/bearing.hpp"
#include "tribology/ellipse_sum.hpp"
#include "tribology/traction_law.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

/// Traction, moment and heat of one Hertz contact ellipse at given kinematics.
///
/// Local axes (c, t, n), right-handed c × t = n: t rolling direction, n from the ball into the
/// race, c = t × n along the major axis. Point of the ellipse from the ball center: p = ξ c + η t +
/// h(ξ) n. Slip u is race minus ball, the traction on the ball is along it
/// (tests/reference/dynamics_README.md):
///
///   u_c = u0_c + W_t h - W_n η          dF = κ(|u|) p (u/|u|) dA on the ball
///   u_t = u0_t + W_n ξ - W_c h          dM = p × dF = (-h f_t, h f_c, ξ f_t - η f_c) in (c, t, n)
///
/// At fixed ξ, u_t does not depend on η and u_c is linear in it. Tractions lie in the (c, t) plane
/// of the contact center also on curved surfaces. Limits: a < ρ; no micro-slip, no elastic creep.
namespace adore::tribology {

/// Height h(ξ) of the contact surface over the ball center. CurvedEdge (Heathcote) is the run's
/// default.
enum class ContactSurface : unsigned char {
  CurvedEdge,  ///< arc of radius ρ through the two ends of the major axis on the undeformed ball
  CurvedHalf,  ///< arc of radius ρ, half the approach below the ball's surface at the center
  CurvedUndeformed,  ///< arc of radius ρ touching the undeformed ball at the center
  FlatUndeformed,    ///< plane at the ball radius ("without Heathcote")
  FlatHalf,          ///< plane half the approach below it
  FlatEdge           ///< plane through the two ends of the major axis
};

using EllipseKinematics = EllipseMotion<double>;

struct EllipseGeometry {
  double Q = 0.0, a = 0.0, b = 0.0;  ///< load [N], semi axes along c and t [m]
  double rho = 0.0;                  ///< radius of the deformed surface [m]; 0 = flat
  double h0 = 0.0;                   ///< h(0) [m]

  /// h(ξ) = h0 - (ρ - √(ρ²-ξ²)), flat: h0. The form without cancellation.
  [[nodiscard]] double height(double xi) const noexcept {
    if (!(rho > 0.0)) return h0;
    return h0 - xi * xi / (rho + ScalarMath<double>::root(rho * rho - xi * xi));
  }
};

/// Slip in the middle of the ellipse [m/s].
[[nodiscard]] inline double middle_slip(const EllipseGeometry& g,
                                        const EllipseKinematics& m) noexcept {
  return std::hypot(m.u_c + m.W_t * g.h0, m.u_t - m.W_c * g.h0);
}

/// Radius of the deformed surface of a ball in a groove, 2 r_b R/(r_b + R) [m].
[[nodiscard]] constexpr double surface_radius(double ball_radius, double groove_radius) noexcept {
  return 2.0 * ball_radius * groove_radius / (ball_radius + groove_radius);
}
[[nodiscard]] constexpr bool is_curved(ContactSurface surface) noexcept {
  return surface == ContactSurface::CurvedEdge || surface == ContactSurface::CurvedHalf ||
         surface == ContactSurface::CurvedUndeformed;
}
[[nodiscard]] constexpr SurfacePosition place_of(ContactSurface surface) noexcept {
  switch (surface) {
    case ContactSurface::CurvedEdge:
    case ContactSurface::FlatEdge:
      return SurfacePosition::ThroughEdge;
    case ContactSurface::CurvedHalf:
    case ContactSurface::FlatHalf:
      return SurfacePosition::HalfApproach;
    case ContactSurface::CurvedUndeformed:
    case ContactSurface::FlatUndeformed:
      break;
  }
  return SurfacePosition::Undeformed;
}

/// Sets ρ = 2 r_b R/(r_b + R) (or 0) and h(0) of a surface convention. Needs a < r_b < R.
/// @param approach δ [m], read by the two "half" conventions.
void set_contact_surface(EllipseGeometry& geometry, ContactSurface surface, double ball_radius,
                         double groove_radius, double approach) noexcept;

struct EllipseTraction {
  double F_c = 0.0, F_t = 0.0;             ///< on the ball [N]
  double M_c = 0.0, M_t = 0.0, M_n = 0.0;  ///< on the ball about its center [N m]
  double heat = 0.0;                       ///< ∫ κ p |u| dA [W]
  double load_slip = 0.0;                  ///< ∫ p |u| dA [W]
  double max_slip = 0.0;                   ///< largest |u|, at the edge of the ellipse [m/s]
};

/// Quadrature rule of a run for the Hertz pressure. With s = ξ/a and v = η/(b sqrt(1-s²)) the load
/// element is p dA = Q ¾(1-s²) ds (2/π) sqrt(1-v²) dv. Over v always Gauss-Chebyshev of the second
/// kind. Over s either
///  - product: Gauss-Gegenbauer (weight 1-s²), best for smooth integrands; or
///  - split: Gauss-Legendre in five pieces whose ends, per contact, are where u_t = ±w. There a law
///  with a steep
///    start changes from sticking to sliding (Heathcote's bands), which `major` fixed nodes see
///    only to ~1/major². w⁴ = slip_scale(law)⁴ + (W_n b/2)⁴; u_t is taken as a parabola in s for
///    this purpose only. Films: pieces with separate nodes (make_film_rule).
/// Both are continuous in the motion, sum to the load and keep the power balance of traction
/// exactly.
struct EllipseRule {
  int major = 0, minor = 0;
  bool split = false;
  std::array<int, kEllipsePieces> of_piece{};  ///< split: nodes in each, together `major`
  double sweep = 0.0;     ///< split: |u_t| at the ends of the pieces over W_n b; 0: that of the law
  std::vector<double> s;  ///< product: ξ/a of each major node, ascending; split: nodes of the first
                          ///< piece in 0..1, then those of the second ...
  std::vector<double> weight_s;  ///< of the load: sums to 1; split: of ds within the piece
  std::vector<double> v;         ///< η/(b sqrt(1-s²)) of each minor node, ascending
  std::vector<double> weight_v;  ///< sums to 1
  // Derived, so that the hot path need not repeat them.
  std::vector<double> chord;      ///< sqrt(1-s²), product only
  std::vector<double> weight_v1;  ///< weight_v v
  std::vector<double> weight_v2;  ///< weight_v v²
  std::vector<double> chord_v;    ///< sqrt(1-v²)

  [[nodiscard]] EllipseNodes nodes() const noexcept;
};
/// Product rule. @throws InputError unless 1 <= major, minor <= 200.
[[nodiscard]] EllipseRule make_ellipse_rule(int major, int minor);

/// Split rule with ceil(major/5) nodes in each piece, at least 2. @throws InputError as above.
[[nodiscard]] EllipseRule make_split_ellipse_rule(int major, int minor);

/// Split rules for the films of a run (decision 328): pieces with nodes as they need them, tuned
/// over pressures, spins, speeds and films of all lubricants, and judged on contacts that the
/// tuning has not seen. Traction that follows the pressure point by point: 2, 2, 4, 2 and 2 nodes
/// in the five pieces times four across; films of whole strips: 4, 2, 4, 2 and 4 times two. All
/// integrate the load exactly.
[[nodiscard]] EllipseRule make_film_rule();
[[nodiscard]] EllipseRule make_strip_rule();

/// Nodes along and across of these two, and the rule that a run means by its numbers: one of them,
/// or the split rule.
struct EllipseNodeCounts {
  int major = 0, minor = 0;
  friend bool operator==(const EllipseNodeCounts&, const EllipseNodeCounts&) = default;
};
inline constexpr EllipseNodeCounts kFilmNodes{12, 4}, kStripNodes{16, 2};
[[nodiscard]] EllipseRule make_run_rule(EllipseNodeCounts size);

/// The fixed rule of a run, as its kernels have it (ellipse_sum.hpp). max_slip is largest_slip.
[[nodiscard]] EllipseTraction ellipse_traction(const TractionLaw& law,
                                               const EllipseGeometry& geometry,
                                               const EllipseKinematics& motion,
                                               const EllipseRule& rule) noexcept;

/// By largest_slip.hpp, for any law and rule [m/s].
[[nodiscard]] double largest_slip(const EllipseGeometry& geometry,
                                  const EllipseKinematics& motion) noexcept;

/// The converged answer: integrals split at slip reversals and at the kink of the law; relative
/// accuracy ~1e-10. Slip is not rounded: κ(0) ≠ 0 means no force at exactly zero slip.
[[nodiscard]] EllipseTraction ellipse_traction_converged(const TractionLaw& law,
                                                         const EllipseGeometry& geometry,
                                                         const EllipseKinematics& motion);

/// A law given as a function, for comparisons with models outside of the list.
struct TractionFunction {
  std::function<double(double slip, double pressure)> coefficient;  ///< κ, smooth except at `bend`
  double bend = 0.0;  ///< slip where κ bends [m/s]; 0 = none

  static constexpr bool kDependsOnPressure = true;
  template <class T>
  [[nodiscard]] const std::function<double(double, double)>& at(const ContactConditions<T>&) const {
    return coefficient;
  }
  [[nodiscard]] double kink() const { return bend; }
};
[[nodiscard]] EllipseTraction ellipse_traction_converged(const TractionFunction& law,
                                                         const EllipseGeometry& geometry,
                                                         const EllipseKinematics& motion);

}  // namespace adore::tribology
