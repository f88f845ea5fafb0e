#pragma once

#include "contact/angle_law.hpp"
#include "contact/ball_groove.hpp"
#include "contact/race_table.hpp"
#include "contact/race_wave.hpp"

#include <cmath>
#include <cstddef>

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
/// A surface that varies across the groove, too, is a table (race_table.hpp) in the place of ψ's
/// waves: δ = l - s - w(ψ, φ), K = K_nominal k(ψ, φ), φ of the direction n of the nominal groove.
/// With ∂φ/∂d = ∓c/l the gradient has a part along c besides [derived]:
///   D = -w_ψ,  G = ±w_φ/l,  force along c  L - (Q G ∓ 0.4 δ Q (k_φ/k)/l)
/// A ball that is not round, by h(u) (user routine ADRX5), touches at u = Bᵀn, B its attitude: δ
/// grows by h. With g = ∂h/∂n along c and t [derived]:
///   D grows by n_e g_t,  G by g_c/l,  moment on the ball about its centre  Q (g_c t - g_t c)
/// It follows the rotation of the ball, and leaves no torque about the axis of a round race. Left
/// out: the curvature of its lobes under the contact.
/// Limits: whole numbers of waves per turn; waves much longer than the contact is wide, but of
/// tables, which setup/surface_table.hpp has rolled over by the ball. The contact
/// axes, the arms of traction and the surface it acts on are those of the nominal groove.
namespace adore::contact {

/// Over those of the nominal groove, polynomials in (change of f)/(largest change): Hertz's K, and
/// the half axes of the ellipse at one approach. Coefficients are numbers or one a lane.
template <class C>
struct HertzConstantRatios {
  static constexpr int kTerms = HertzAngleLaw::kTerms;
  C stiffness[kTerms]{C(1.0)}, major[kTerms]{C(1.0)}, minor[kTerms]{C(1.0)};
};

/// Balls that are not round (user routine ADRX5), on one race. h over the unit vector u from the
/// centre in the body's axes: azimuth about its x axis from its z axis, and latitude asin u_x.
struct BallFormErrors {
  const SurfaceDeviationTable* of_ball = nullptr;  ///< by ball, h in `height`; of no row: round
  const double* attitude = nullptr;  ///< by ball, body axes in base axes, one after the other
};

struct WavyGroove {
  RaceErrorModel form;
  double curvature_diameter = 0.0;        ///< D of the nominal ball [m]
  double normal_x = 0.0, normal_r = 1.0;  ///< n of the nominal contact
  bool varying = false;                   ///< the curvature changes
  double per_factor = 0.0;                ///< 1/(largest change of f)
  HertzConstantRatios<double> ratios;     ///< of one ball
  SurfaceDeviationTable table;            ///< its numbers live longer
  BallFormErrors* forms = nullptr;        ///< balls that are not round; null: all are
};

template <class T>
struct WavyGrooveContact {
  BallGrooveContact<T> touch;
  T turn;    ///< D [m/rad]
  T across;  ///< -l ∂(n_e)/∂ψ / n_k, of the angle's change with ψ [m/rad]
  T stiffness = 1.0, log_stiffness_slope = 0.0;  ///< k, k'/k [-, 1/rad]
  T major = 1.0, minor = 1.0;                    ///< half axes over the nominal ones
  T lean = 0.0, log_stiffness_lean = 0.0;  ///< of tables: along c, ∂δ [-] and ∂ln k [1/m]
  T lobe_c = 0.0, lobe_t = 0.0;  ///< of balls that are not round: ∂h/∂n along c, t [m]
};

/// @param ratios of the ball, or of the one in each lane; psi its azimuth in the race; offset s of
/// the nominal groove [m]
template <class T, class C, class S>
[[nodiscard, gnu::always_inline]] inline WavyGrooveContact<T> wavy_groove_contact(
    const WavyGroove& groove, const HertzConstantRatios<C>& ratios, const AzimuthDirection<T>& psi,
    const T& axial, const T& lift, const S& offset) {
  const LocalRaceErrorOf<T> e = race_error_at(groove.form, psi);
  const auto change_of = [&](const T& radius, const T& factor) {
    return groove_change(radius, factor, groove.curvature_diameter, groove.normal_x,
                         groove.normal_r);
  };
  const GrooveChange<T> change = change_of(e.radius, e.curvature_factor);
  const GrooveChange<T> slope = change_of(e.radius_slope, e.curvature_factor_slope);
  WavyGrooveContact<T> out;
  out.touch = ball_groove_contact(T(axial - change.x), T(lift - change.centre_radius), offset);
  out.touch.approach = out.touch.approach - change.radius;
  out.turn = -out.touch.n_k * slope.x - out.touch.n_e * slope.centre_radius - slope.radius;
  out.across = out.touch.n_k * slope.centre_radius - out.touch.n_e * slope.x;
  if (groove.table.around > 0) {
    const TableAtContact<T> at =
        TableLookup<T>::at(groove.table, psi, out.touch.n_k, out.touch.n_e);
    const T per_way = groove.table.side / out.touch.length;
    out.touch.approach = out.touch.approach - at.height;
    out.turn = out.turn - at.height_psi;
    out.lean = per_way * at.height_phi;
    if (groove.varying) {
      const T w = at.factor * groove.per_factor;
      const PolynomialValue<T> k = polynomial_with_slope(ratios.stiffness, w);
      const T per_factor = k.slope * groove.per_factor / k.value;
      out.stiffness = k.value;
      out.log_stiffness_slope = per_factor * at.factor_psi;
      out.log_stiffness_lean = -per_way * per_factor * at.factor_phi;
      out.major = polynomial(ratios.major, w);
      out.minor = polynomial(ratios.minor, w);
    }
    return out;
  }
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
[[nodiscard, gnu::always_inline]] inline T wavy_tangential_force(const WavyGrooveContact<T>& at,
                                                                 const T& load, const T& leaning,
                                                                 const T& approach,
                                                                 const T& distance) {
  return -(load * (at.turn + 0.4 * approach * at.log_stiffness_slope) + leaning * at.across) /
         distance;
}

/// Part of the force on the ball along c that tables add. @param load Q, elastic that without
/// damping
template <class T>
[[nodiscard, gnu::always_inline]] inline T wavy_transverse_force(const WavyGrooveContact<T>& at,
                                                                 const T& load, const T& elastic,
                                                                 const T& approach) {
  return -(load * at.lean + 0.4 * approach * elastic * at.log_stiffness_lean);
}

/// h and its derivatives along c and t at one ball; n, c, t in base axes.
struct Lobe {
  double height = 0.0, c = 0.0, t = 0.0;
};
[[nodiscard, gnu::always_inline]] inline Lobe lobe_at(const BallFormErrors& forms, std::size_t ball,
                                                      const Triple<double>& n,
                                                      const Triple<double>& c,
                                                      const Triple<double>& t) {
  const SurfaceDeviationTable& table = forms.of_ball[ball];
  if (table.across == 0) return {};
  const double* const B = forms.attitude + 9 * ball;
  const Triple<double> x{B[0], B[1], B[2]}, y{B[3], B[4], B[5]}, z{B[6], B[7], B[8]};
  const double u_x = dot(n, x), u_y = dot(n, y), u_z = dot(n, z);
  const double across = std::sqrt(u_y * u_y + u_z * u_z);
  const double cosine = across > 1e-2 ? across : 1e-2;  // at the poles azimuths mean nothing
  const TableValue h =
      table_value(table, table.height, std::atan2(-u_y, u_z), std::atan2(u_x, across));
  // On the unit sphere: ∂u/∂λ and the direction of growing azimuth.
  const double s_psi = -u_y / cosine, c_psi = u_z / cosine;
  const Triple<double> g = (h.phi * across) * x +
                           (h.phi * u_x * s_psi - h.psi / cosine * c_psi) * y +
                           (-h.phi * u_x * c_psi - h.psi / cosine * s_psi) * z;
  return {h.value, dot(g, c), dot(g, t)};
}

/// The touch with a lobe of the ball.
template <class T>
[[gnu::always_inline]] inline void add_lobe(WavyGrooveContact<T>& touch, const T& height,
                                            const T& g_c, const T& g_t) {
  touch.touch.approach = touch.touch.approach + height;
  touch.turn = touch.turn + touch.touch.n_e * g_t;
  touch.lean = touch.lean + g_c / touch.touch.length;
  touch.lobe_c = g_c;
  touch.lobe_t = g_t;
}

/// Azimuth of the ball in a race whose zero direction (across k, turning with the race) is `zero`.
template <class T>
[[nodiscard, gnu::always_inline]] inline AzimuthDirection<T> azimuth_in_race(
    const Triple<T>& k, const Triple<T>& e, const Triple<T>& zero) {
  return {dot(e, zero), -dot(cross(k, e), zero)};
}

}  // namespace adore::contact
