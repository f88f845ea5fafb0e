#pragma once

#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "base/single.hpp"
#include "tribology/film_thickness.hpp"
#include "tribology/laws/contact_point.hpp"

/// The film of a contact as traction laws have it: contact_film.hpp for numbers and for vectors of
/// numbers, with the state's own load, speed, slip, curvature and ellipse. Points go by Hamrock &
/// Dowson also where k < 1 (which grooves do not make), lines by Dowson & Toyoda and Dowson.
namespace adore::tribology {

template <class T>
struct LocalFilm {
  T thickness;  ///< in the middle [m]
  T thinnest;   ///< [m]
  T share;      ///< w of the film in the traction, the rest is metal: 0 to 1
  T factor;     ///< φT φS, in both thicknesses
};

/// Logarithms of what enters a contact: its film and the rolling resistance of its inlet read them.
template <class T>
struct InletLogarithms {
  T curve;                           ///< 1/R [1/m]
  T speed2;                          ///< u² and what keeps it above 0 [m²/s²]
  T log_speed, log_curve, log_load;  ///< ln u, ln 1/R, ln W
};

/// A contact in single precision, twice in each vector.
template <class T>
[[gnu::always_inline]] inline ContactConditions<typename SinglePrecisionOf<T>::Type>
to_single_precision(const ContactConditions<T>& c) {
  using To = SinglePrecisionOf<T>;
  return {To::both(c.load),       To::both(c.peak_pressure), To::both(c.half_major),
          To::both(c.half_minor), To::both(c.entrainment),   To::both(c.slip),
          To::both(c.curvature)};
}

/// Constants of the films of one race at the temperature of its inlets, which stays for the run.
/// SI. Set by film_law.hpp.
struct ContactFilmModel {
  bool line = false;
  double log_central = 0.0, log_minimum = 0.0;  ///< ln of c G^m (μ0/E')^s of the regressions
  double inverse_modulus = 0.0;                 ///< 1/E' [1/Pa]
  double curvature = 0.0;                       ///< 1/R of contacts that do not say theirs [1/m]
  double least_speed2 = 0.0;                    ///< added to u² [m²/s²]
  double log_heating = 0.0;                     ///< ln of L/u²
  double meniscus = 0.0, log_meniscus = 0.0;    ///< strParam
  double critical = 0.0;                        ///< reRaceFilm [m]

  template <class T>
  [[gnu::always_inline]] InletLogarithms<T> inlet_logarithms(const ContactConditions<T>& c) const {
    using M = ScalarMath<T>;
    using Log = ScalarLog<T>;
    const T curve = M::pick(c.curvature > 0.0, c.curvature, T(curvature));
    const T speed2 = c.entrainment * c.entrainment + least_speed2;
    const T area = line ? curve : curve * curve;
    return {curve, speed2, 0.5 * Log::log(speed2), Log::log(curve),
            Log::log(M::max(c.load * inverse_modulus * area, T(kLeastLoadGroup)))};
  }
  template <class T>
  [[gnu::always_inline]] LocalFilm<T> at(const ContactConditions<T>& c) const {
    return at(c, inlet_logarithms(c));
  }
  /// The same by floats: to some 1e-6.
  template <class T>
  [[gnu::always_inline]] LocalFilm<T> by_floats(const ContactConditions<T>& c) const {
    using To = SinglePrecisionOf<T>;
    const auto here = at(to_single_precision(c));
    LocalFilm<T> out;
    T twice;
    To::unpack(here.thickness, out.thickness, twice);
    To::unpack(here.thinnest, out.thinnest, twice);
    To::unpack(here.share, out.share, twice);
    To::unpack(here.factor, out.factor, twice);
    return out;
  }
  template <class T>
  [[gnu::always_inline]] LocalFilm<T> at(const ContactConditions<T>& c,
                                         const InletLogarithms<T>& inlet) const {
    using M = ScalarMath<T>;
    using Log = ScalarLog<T>;
    const FilmRegression& central = line ? kLineCentral : kPointCentral;
    const FilmRegression& minimum = line ? kLineMinimum : kPointMinimum;
    const T &u2 = inlet.speed2, &log_u = inlet.log_speed, &log_curve = inlet.log_curve,
            &log_W = inlet.log_load;
    T log_h = log_central + (central.speed - 1.0) * log_curve + central.speed * log_u -
              central.load * log_W;
    const T log_least = log_minimum + (minimum.speed - 1.0) * log_curve + minimum.speed * log_u -
                        minimum.load * log_W;
    T shape_least = 1.0;
    if (!line) {
      const T k = c.half_major / M::max(c.half_minor, T(1e-30));
      shape_least = 1.0 - minimum.shape * M::exp(-minimum.decay * k);
      log_h = log_h + Log::log(1.0 - central.shape * M::exp(-central.decay * k));
    }
    const T isothermal = M::exp(log_h);
    // Inlet heating, with its floor of 0.1 (thermal_reduction.hpp).
    const T log_L = log_heating + 2.0 * log_u;
    const T slide = M::exp(0.415 * Log::log(c.slip * c.slip / u2 + 1e-8));
    const T raw = (1.0 - 13.2 * inverse_modulus * c.peak_pressure * M::exp(0.42 * log_L)) /
                  (1.0 + 0.213 * (1.0 + 2.23 * slide) * M::exp(0.64 * log_L));
    const T above = raw - kFloor;
    const T inside = M::min(M::max(above, T(-kWidth)), T(kWidth)) + kWidth;
    const T thermal = kFloor + M::max(above - kWidth, T(0.0)) + inside * inside / (4.0 * kWidth);
    // Starvation (starvation.hpp); half widths that are none give no film.
    const T reach = 0.5 * c.half_minor * c.half_minor * inlet.curve;
    const T log_psi = (2.0 / 3.0) * (Log::log(M::max(reach, T(1e-30))) - log_h) + log_meniscus;
    const T near = M::min(log_psi, T(kFlooded));
    const T log_dry = -1.68005 * M::exp(0.8315 * near) + 0.260137 * M::exp(1.558 * near) -
                      0.016146 * M::exp(2.296 * near);
    const T factor = thermal * M::max(one_minus_exp(log_dry), T(0.0));
    const T thinnest = factor * shape_least * M::exp(log_least);
    const T s =
        M::min(M::max((thinnest - 0.95 * critical) / (0.1 * critical + 1e-15), T(0.0)), T(1.0));
    return {factor * isothermal, thinnest, s * s * (3.0 - 2.0 * s), factor};
  }

 private:
  /// 1 - e^x; floats would lose what little is left of a starved film.
  template <class T>
  [[gnu::always_inline]] static T one_minus_exp(const T& x) {
    using M = ScalarMath<T>;
    const T plain = 1.0 - M::exp(x);
    if constexpr (IsSinglePrecision<T>::value) {
      const T y = 0.0 - x;
      const T series =
          y * (1.0 - y * (0.5 - y * (1.0 / 6.0 - y * (1.0 / 24.0 - y * (1.0 / 120.0)))));
      return M::pick(y < 0.25, series, plain);
    }
    return plain;
  }
  static constexpr double kFloor = 0.1, kWidth = 0.05, kFlooded = 7.0;
};

}  // namespace adore::tribology
