#pragma once

#include "statics/dual.hpp"

#include <array>
#include <cmath>
#include <limits>

/// How a ball rolls between two turning races at given contact angles: orbital speed, spin and its
/// axis.
///
/// In the frame that orbits with the ball (x axial, r radial, t circumferential) the ball spins
/// with
/// (-ω_R cos β, ω_R sin β, 0), β the pitch angle. Contact j turns relative to that frame with (Ω_j
/// - ω_m) e_x. No slip at both contact centres, with γ = D/d_m, ρ_o = 1 + γ cos α_o, ρ_i = 1 - γ
/// cos α_i (undeformed radii):
///   (Ω_o - ω_m) ρ_o = -γ ω_R cos(β - α_o),   (Ω_i - ω_m) ρ_i = γ ω_R cos(β - α_i)
/// so  ω_R = (Ω_i - Ω_o)/(γ [cos(β-α_i)/ρ_i + cos(β-α_o)/ρ_o]),  ω_m = Ω_o + γ ω_R cos(β-α_o)/ρ_o.
/// With Ω_o = 0 these are the classical formulas of one turning race. Sources: [jones1959],
/// [harris2006]. Relative spin over rolling at a contact, W_n/W_c of race minus ball: outer σ_o = γ
/// sin α_o - ρ_o tan(α_o - β); inner -σ_i with σ_i = γ sin α_i + ρ_i tan(α_i - β), the sign in
/// which the reference cases give it.
namespace adore::statics {

/// Sine and cosine of an angle.
template <class S>
struct Direction {
  S sin = 0.0;
  S cos = 1.0;
};

/// cos(a - b) and sin(a - b).
template <class S>
S cos_between(const Direction<S>& a, const Direction<S>& b) {
  return a.cos * b.cos + a.sin * b.sin;
}
template <class S>
S sin_between(const Direction<S>& a, const Direction<S>& b) {
  return a.sin * b.cos - a.cos * b.sin;
}

/// Pitch angle for which the relative spin vanishes at one race: tan β = sin α_o/(cos α_o + γ), sin
/// α_i/(cos α_i - γ).
template <class S>
Direction<S> race_control_axis(const Direction<S>& alpha, double gamma, bool outer) {
  const S cosine_part = alpha.cos + (outer ? gamma : -gamma);
  const S norm = square_root(alpha.sin * alpha.sin + cosine_part * cosine_part);
  return {alpha.sin / norm, cosine_part / norm};
}

template <class S>
struct PureRollingSpeeds {
  S orbital = 0.0;  ///< ω_m [rad/s]
  S spin = 0.0;     ///< ω_R, relative to the orbiting frame, sign of Ω_i - Ω_o [rad/s]
  bool possible =
      true;  ///< false when the spin axis is so tilted that no rolling at both races exists
};

/// No slip at both contact centres for a given pitch angle.
template <class S>
PureRollingSpeeds<S> roll_without_slip(const std::array<Direction<S>, 2>& alpha,
                                       const Direction<S>& beta, double gamma,
                                       const std::array<double, 2>& race_speed) {
  const S outer = cos_between(beta, alpha[0]) / (1.0 + gamma * alpha[0].cos);
  const S inner = cos_between(beta, alpha[1]) / (1.0 - gamma * alpha[1].cos);
  const S sum = outer + inner;
  PureRollingSpeeds<S> result;
  if (!(value_of(sum) > 0.02)) {
    result.possible = false;
    result.orbital = 0.5 * (race_speed[0] + race_speed[1]);
    return result;
  }
  const S relative = (race_speed[1] - race_speed[0]) / sum;  // γ ω_R
  result.spin = relative / gamma;
  result.orbital = race_speed[0] + relative * outer;
  return result;
}

/// One contact as seen by the least-heat rule.
struct HeatContact {
  Direction<double> alpha;   ///< contact angle
  double load = 0.0;         ///< Q [N], > 0
  double half_major = 0.0;   ///< a [m]; grows with Q^(1/3)
  double log_a_slope = 0.0;  ///< d ln a/dα at constant load [1/rad]
  double aspect = 1.0;       ///< a/b
  double surface_radius =
      0.0;  ///< ρ = 2fD/(2f+1), of the deformed surface along the major axis [m]
};

/// Pitch angle of least frictional heat and its derivatives over angles and loads (implicit
/// function theorem).
struct LeastHeatAxis {
  double beta = 0.0;                   ///< [rad]
  std::array<double, 2> over_angle{};  ///< ∂β/∂α_j [-]
  std::array<double, 2> over_load{};   ///< ∂β/∂Q_j [rad/N]
};

/// Minimises over β, at a constant friction coefficient and without slip at both contact centres,
///   Σ_j Q_j |W_c,j| G_j,  G = ¾∫(1-s²) sqrt((σ a s + a² s²/(2ρ))² + σ² b² (1-s²)/4) ds, -1..1 (12
///   Gauss points),
/// i.e. the heat of spin AND of the differential slip of the curved contact surface; across the
/// narrow axis η² is replaced by its mean. Without the curvature term the heat is a sum of |σ_j|
/// with kinks, and its minimum is always plain race control of one race or the other.
/// `guess` starts the search; NaN: the control angles weighted by load and contact length. The
/// answer does not depend on it.
[[nodiscard]] LeastHeatAxis least_heat_axis(
    const std::array<HeatContact, 2>& contacts, double gamma,
    double guess = std::numeric_limits<double>::quiet_NaN());

/// That heat (over friction coefficient and |Ω_i - Ω_o|/γ) at a given pitch angle, and its slope.
struct HeatOfAxis {
  double heat = 0.0;
  double slope = 0.0;
};
[[nodiscard]] HeatOfAxis heat_of_axis(const std::array<HeatContact, 2>& contacts, double gamma,
                                      double beta);

}  // namespace adore::statics
