#pragma once

#include <vector>

#include "bearing/bearing.hpp"

/// Traction, moment and heat of one Hertz contact ellipse at given kinematics.
/// Local axes (c, t, n): t rolling direction, n into the race, c = t × n along the major axis; point p = ξ c + η t + h(ξ) n from
/// the ball centre. Slip u = race minus ball. Formulas: tests/reference/dynamics_README.md, "Traction".
namespace adore::tribology {

/// Height h(ξ) of the contact surface over the ball centre. CurvedEdge (Heathcote) is the run's default.
enum class ContactSurface : unsigned char {
  CurvedEdge, CurvedHalf, CurvedUndeformed, FlatUndeformed, FlatHalf, FlatEdge
};

struct EllipseKinematics {
  double u_c = 0.0, u_t = 0.0;  ///< slip u0 at the ball centre, without the W terms [m/s]
  double W_c = 0.0, W_t = 0.0, W_n = 0.0;  ///< Ω_race - ω_ball on (c, t, n) [rad/s]
};

struct EllipseGeometry {
  double Q = 0.0, a = 0.0, b = 0.0;  ///< load [N], semi axes along c and t [m]
  double rho = 0.0;   ///< radius of the deformed surface [m]; 0 = flat
  double h0 = 0.0;    ///< h(0) [m]; h(ξ) = h0 - (ρ - sqrt(ρ²-ξ²)), flat: h0
};

struct EllipseTraction {
  double F_c = 0.0, F_t = 0.0;               ///< on the ball [N]
  double M_c = 0.0, M_t = 0.0, M_n = 0.0;    ///< on the ball about its centre [N m]
  double heat = 0.0;       ///< ∫ κ p |u| dA [W]
  double load_slip = 0.0;  ///< ∫ p |u| dA [W]
  double max_slip = 0.0;   ///< over the quadrature points and the ellipse edge [m/s]
};

/// Product rule of a run: Gauss points for the Hertz pressure weight, `major` nodes over ξ and `minor` over η.
/// Flat list of points in unit coordinates with weights that sum to 1 (∫ p dA = Q).
struct EllipseRule {
  int major = 0, minor = 0;
  std::vector<double> s;       ///< ξ/a of each major node
  std::vector<double> weight_s;
  std::vector<double> v;       ///< η/(b sqrt(1-s²)) of each minor node
  std::vector<double> weight_v;
};
[[nodiscard]] EllipseRule make_ellipse_rule(int major, int minor);

/// The fixed rule (scalar reference of the vectorised kernel).
[[nodiscard]] EllipseTraction ellipse_traction(const bearing::TractionCurve& curve, const EllipseGeometry& geometry,
                                               const EllipseKinematics& motion, const EllipseRule& rule) noexcept;

/// The converged answer: integrals split at slip reversals and at the kink of the law; relative accuracy ~1e-10.
[[nodiscard]] EllipseTraction ellipse_traction_converged(const bearing::TractionCurve& curve, const EllipseGeometry& geometry,
                                                         const EllipseKinematics& motion);

}  // namespace adore::tribology
