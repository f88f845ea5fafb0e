#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "tribology/laws/film_of_contact.hpp"
#include "tribology/laws/limited.hpp"

/// Rolling resistance of the oil in the inlet of a contact, for numbers and for vectors of numbers:
/// of equilibria (statics/friction.hpp) and of motion (dynamics/effects/rolling_resistance.cpp).
/// SI.
///
/// Pressure rises where the oil enters, and its gradient shears both surfaces backwards alike:
///   F = ∫ h/2 dp/dx dx  on each, against the entrainment u,
/// while the pressure on the convergent surfaces pushes body k along u by 2 F R/R_k through its
/// center of curvature; together they are in balance, 1/R = 1/R_1 + 1/R_2. They take 2 F u.
///   point  F = F_i + (F_e - F_i)/(1 + 6.6/M),  M = 0.5549 r^-0.6029 W U^-3/4
///          F_e = 7.5826 E' R² r^0.4055 U^3/4 W^1/3   elastic
///          F_i = 2.9766 E' R² r^0.3316 U^2/3 W^1/3   rigid, light loads
///          (Biboulet & Houpert 2010 for flooded inlets, as printed in Lubricants 2015, 3, 222;
///          decision 520), r = R_y/R_x of both bodies, k = 1.03 r^0.64
///   line, per length   F = (F_e^-4 + F_i^-4)^-1/4   [choice]
///          F_e = 4.318 R/α (G U)^0.658 W^0.0126   elastic (Goksem & Hargreaves 1978, recalled)
///          F_i = 2.0796 E' R (U W)^1/2            rigid: h0 = 4.9 μ0 u R/w, F = 4.6 μ0 u √(R/h0)
///                                                 of Reynolds' exit [derived, test]
///   U = μ0 u/(E' R), G = α E', W as in film_thickness.hpp (at least 1e-9)
/// times φT φS of the contact's film (heated and starved inlets). Checked: the line against
/// numerical solutions of Reynolds' equation with elastic bodies, within 15 % (test); the point
/// against torques measured on three balls, experiments SPIN-DOWN.
/// The law of points has no pressure coefficient, lines go with G^-0.342. Reynolds' equation solved
/// for points (test; k 3 and 8, 0.6 to 2 GPa, α 10 and 20/GPa) has 0.97 of it at U = 4e-12, 0.93 at
/// 4e-11 and 0.76 to 0.88 at 4e-10, between it and strips that resist as lines (0.71, 0.59, 0.4 to
/// 0.5): outputs say how much it may be too large where strips have less than half (friction.hpp).
/// No oil shears more than 0.11 of the load, as a smooth minimum of fourth order [choice]: it
/// counts where an oil is nearly a solid, 200 K below its range.
/// F has the sign of u and is odd in it, smooth at u = 0; it vanishes with load and film. Limits:
/// no asperities, no elastic hysteresis; entrainment along the rolling direction only; inlets at
/// the mean bulk temperature of both bodies.
namespace adore::tribology {

/// Of the contacts with one race; set by film_law.hpp.
struct RollingResistance {
  ContactFilmModel film;      ///< says whether contacts are lines, too
  double log_speed = 0.0;     ///< ln(μ0/E') [s]
  double log_material = 0.0;  ///< ln G
  double modulus = 0.0;       ///< E' [Pa]
  bool single = false;        ///< vectors by floats: to some 1e-6

  /// F with the sign of the entrainment [N]; of lines per length [N/m].
  template <class T>
  [[gnu::always_inline]] T force(const ContactConditions<T>& c) const {
    if constexpr (kHasSingle<T>) {
      if (single) {
        T F, twice;
        SinglePrecisionOf<T>::unpack(evaluate_force(to_single_precision(c)), F, twice);
        return F;
      }
    }
    return evaluate_force(c);
  }
  /// The same where the film of the contact is known. @param factor φT φS
  template <class T>
  [[gnu::always_inline]] T force(const ContactConditions<T>& c, const InletLogarithms<T>& inlet,
                                 const T& factor) const {
    using M = ScalarMath<T>;
    const T log_U = log_speed + inlet.log_speed + inlet.log_curve;
    const T area = film.line ? inlet.curve : inlet.curve * inlet.curve;
    const T size = film.line ? dimensionless_line_force(log_U, inlet.log_load)
                             : dimensionless_point_force(c, log_U, inlet.log_load);
    const T load = M::max(c.load, T(1e-30));
    const T ratio = TractionLimiter::at(kMostOfLoad).of(size * modulus / area * factor / load);
    return M::pick(c.load > 0.0, ratio * load * c.entrainment * M::inverse_sqrt(inlet.speed2),
                   T(0.0));
  }

 private:
  template <class T>
  [[gnu::always_inline]] T evaluate_force(const ContactConditions<T>& c) const {
    const InletLogarithms<T> inlet = film.inlet_logarithms(c);
    return force(c, inlet, film.at(c, inlet).factor);
  }
  static constexpr double kMostOfLoad = 0.11;
  static constexpr double kLogRound = 0.029558802241544403;  ///< ln 1.03

  template <class T>
  [[gnu::always_inline]] static T scaled_exp(double factor, const T& x) {
    return factor * ScalarMath<T>::exp(x);
  }
  /// Over E' R².
  template <class T>
  [[gnu::always_inline]] T dimensionless_point_force(const ContactConditions<T>& c, const T& log_U,
                                                     const T& log_W) const {
    using M = ScalarMath<T>;
    const T k = M::max(c.half_major / M::max(c.half_minor, T(1e-30)), T(1e-3));
    const T log_r = (ScalarLog<T>::log(k) - kLogRound) * (1.0 / 0.64);
    const T third = (1.0 / 3.0) * log_W;
    const T rigid = scaled_exp(2.9766, 0.3316 * log_r + (2.0 / 3.0) * log_U + third);
    const T elastic = scaled_exp(7.5826, 0.4055 * log_r + 0.75 * log_U + third);
    const T inverse_M = scaled_exp(6.6 / 0.5549, 0.75 * log_U + 0.6029 * log_r - log_W);
    return rigid + (elastic - rigid) / (1.0 + inverse_M);
  }
  /// Over E' R.
  template <class T>
  [[gnu::always_inline]] T dimensionless_line_force(const T& log_U, const T& log_W) const {
    const T elastic = scaled_exp(4.318, 0.658 * log_U - 0.342 * log_material + 0.0126 * log_W);
    const T rigid = scaled_exp(2.0796, 0.5 * (log_U + log_W));
    const T ratio = elastic / rigid, ratio2 = ratio * ratio;
    return elastic * InverseRoots<T>::fourth(1.0 + ratio2 * ratio2);
  }
};

}  // namespace adore::tribology
