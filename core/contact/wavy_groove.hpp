#pragma once

#include "contact/angle_law.hpp"
#include "contact/ball_groove.hpp"
#include "contact/race_wave.hpp"

/// A ball in the groove of a race that is not one of revolution (race_wave.hpp), for motion: what
/// contact/ball_groove.hpp states, with a groove whose bottom, radius and place follow the azimuth
/// ψ of the ball in the race. SI.
///
/// ξ, η and s of ball_groove.hpp change with ψ, so does K = K_nominal k(ψ), K_nominal fixed or
/// after contact/angle_law.hpp (the curvature that it comes from follows the groove radius). One
/// potential V = 0.4 K(ψ) δ^2.5, δ = l - s:
///   Q = K δ^1.5,  D = ∂δ/∂ψ = -n_k x' - n_e Rc' - s' of the groove's change (race_wave.hpp)
///   force on the ball  -Q n + L c - (Q (D + 0.4 δ k'/k) + L E)/R t,  the opposite on the race,
/// L of constants that follow the angle, E = n_k Rc' - n_e x':
/// The normal leans by R'/r against the direction of growing ψ, t. Its power on ball and race is
/// -dV/dt, whatever turns the race.
/// Q stands for the force along n: the leaning one is longer by (D/R)²/2, 1e-7 of it.
/// Limits: whole numbers of waves per turn; waves much longer than the contact is wide. The contact
/// axes, the arms of traction and the surface it acts on are those of the nominal groove.
namespace adore::contact {

/// Over those of the nominal groove, polynomials in (change of f)/(largest change): Hertz's K, and
/// the half axes of the ellipse at one approach. Coefficients are numbers or one a lane.
template <class C>
struct GrooveRatios {
  static constexpr int kTerms = AngleLaw::kTerms;
  C stiffness[kTerms]{C(1.0)}, major[kTerms]{C(1.0)}, minor[kTerms]{C(1.0)};
};

struct WavyGroove {
  RaceForm form;
  double curvature_diameter = 0.0;        ///< D of the nominal ball [m]
  double normal_x = 0.0, normal_r = 1.0;  ///< n of the nominal contact
  bool varying = false;                   ///< the curvature changes
  double per_factor = 0.0;                ///< 1/(largest change of f)
  GrooveRatios<double> ratios;            ///< of one ball
};

template <class T>
struct WavyTouch {
  GrooveTouch<T> touch;
  T turn;    ///< D [m/rad]
  T across;  ///< -l ∂(n_e)/∂ψ / n_k, of the angle's change with ψ [m/rad]
  T stiffness = 1.0, log_stiffness_slope = 0.0;  ///< k, k'/k [-, 1/rad]
  T major = 1.0, minor = 1.0;                    ///< half axes over the nominal ones
};

/// @param ratios of the ball, or of the one in each lane; psi its azimuth in the race; offset s of
/// the nominal groove [m]
template <class T, class C, class S>
[[nodiscard, gnu::always_inline]] inline WavyTouch<T> wavy_touch(const WavyGroove& groove,
                                                                 const GrooveRatios<C>& ratios,
                                                                 const AzimuthDirection<T>& psi,
                                                                 const T& axial, const T& lift,
                                                                 const S& offset) {
  const LocalRaceErrorOf<T> e = race_error_at(groove.form, psi);
  const auto change_of = [&](const T& radius, const T& factor) {
    return groove_change(radius, factor, groove.curvature_diameter, groove.normal_x,
                         groove.normal_r);
  };
  const GrooveChange<T> change = change_of(e.radius, e.curvature_factor);
  const GrooveChange<T> slope = change_of(e.radius_slope, e.curvature_factor_slope);
  WavyTouch<T> out;
  out.touch = groove_touch(T(axial - change.x), T(lift - change.centre_radius), offset);
  out.touch.approach = out.touch.approach - change.radius;
  out.turn = -out.touch.n_k * slope.x - out.touch.n_e * slope.centre_radius - slope.radius;
  out.across = out.touch.n_k * slope.centre_radius - out.touch.n_e * slope.x;
  if (groove.varying) {
    const T w = e.curvature_factor * groove.per_factor;
    const PolynomialValue<T> k = polynomial_with_slope(ratios.stiffness, w);
    out.stiffness = k.value;
    out.log_stiffness_slope = k.slope * (e.curvature_factor_slope * groove.per_factor) / k.value;
    out.major = polynomial(ratios.major, w);
    out.minor = polynomial(ratios.minor, w);
  }
  return out;
}

/// Part of the force on the ball along t.
/// @param load Q; leaning L of angle_law.hpp, 0 with fixed constants
template <class T>
[[nodiscard, gnu::always_inline]] inline T wavy_push(const WavyTouch<T>& at, const T& load,
                                                     const T& leaning, const T& approach,
                                                     const T& distance) {
  return -(load * (at.turn + 0.4 * approach * at.log_stiffness_slope) + leaning * at.across) /
         distance;
}

/// Azimuth of the ball in a race whose zero direction (across k, turning with the race) is `zero`.
template <class T>
[[nodiscard, gnu::always_inline]] inline AzimuthDirection<T> azimuth_in_race(
    const Triple<T>& k, const Triple<T>& e, const Triple<T>& zero) {
  return {dot(e, zero), -dot(cross(k, e), zero)};
}

}  // namespace adore::contact
