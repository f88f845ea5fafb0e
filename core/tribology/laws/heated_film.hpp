#pragma once

#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "tribology/laws/contact_point.hpp"

namespace adore::tribology {

/// Numbers of an elastohydrodynamic contact of one race, at the temperatures of its parts, which
/// stay for the run. SI. Set by film_law.hpp.
struct HeatedFilm {
  // Isothermal film: h = central u^0.67 Q^-0.067 in the middle, minimum u^0.68 Q^-0.073 at its
  // thinnest.
  double log_central = 0.0, log_minimum = 0.0;
  double least_load = 0.0;        ///< Q is never taken below it [N]
  double least_speed2 = 0.0;      ///< added to u² [m²/s²]
  double log_heating = 0.0;       ///< ln of L/u²
  double pressure_scale = 0.0;    ///< 13.2/E' [1/Pa]
  double meniscus = 0.0;          ///< strParam
  double inverse_diameter = 0.0;  ///< 1/(2R), R of both bodies along rolling [1/m]
  // Traction, equal walls: μ* and β* at their temperature.
  double viscosity = 0.0;   ///< μ* [Pa s]
  double half_alpha = 0.0;  ///< α*/2 [1/Pa]
  double heating = 0.0;     ///< √(β* μ*/(8 K)) [s/m]
  double limit = 0.0;       ///< τ <= Λ p; 0: none
  double critical = 0.0;    ///< reRaceFilm [m]
};

/// Elastohydrodynamic traction of a Newtonian film that its own shear heats (kTrac 1 to 7, 9):
///   h by film_thickness.hpp (Hamrock & Dowson), thermal_reduction.hpp and starvation.hpp,
///   τ by newton_film.hpp with μ = μ* exp(α* p), κ_film = τ/p, with a limiting stress
///   (κ^-4 + Λ^-4)^(-1/4).
/// Where the thinnest film falls below the critical one the contact is metallic: κ of record 10.1,
/// Metal. Both are blended over h/h_crit 0.95 to 1.05 by w = s² (3 - 2s): κ = w κ_film + (1 - w)
/// κ_metal (decision 273). No rolling, no load: no film, metal contact.
/// Limits: those of the formulas; walls at the bulk temperatures, no flash.
template <class Metal>
struct HeatedFilmLaw {
  Metal metal;
  HeatedFilm film;

  static constexpr bool kOfPressure = true;

  template <class T>
  struct Here {
    decltype(std::declval<const Metal&>().at(std::declval<const ContactPoint<T>&>())) metal;
    T thickness;     ///< in the middle [m]
    T share;         ///< w
    T stress_scale;  ///< μ*/(h √(β* μ*/(8 K))) [Pa]
    T heating, half_alpha;
    double inverse_limit2 = 0.0;  ///< 1/Λ²; 0: no limit

    [[gnu::always_inline]] T operator()(const T& slip, const T& pressure) const {
      using M = ScalarMath<T>;
      if (!M::any(share > 0.0)) return metal(slip, pressure);
      const T root_viscosity = M::exp(half_alpha * pressure);
      const T S = heating * slip * root_viscosity;
      const T S2 = S * S;
      T inverse;
      const T root = M::root_and_inverse(1.0 + S2, inverse);
      // asinh(S) from its series below 1e-3, which the logarithm would round away.
      const T series = S * (1.0 - S2 * (1.0 / 6.0 - S2 * 0.075));
      const T asinh = M::pick(S < 1e-3, series, ScalarLog<T>::log(S + root));
      T kappa = stress_scale * root_viscosity * asinh * inverse / M::max(pressure, T(1.0));
      if (inverse_limit2 > 0.0) {
        const T over = kappa * kappa * inverse_limit2;
        const T once = M::inverse_sqrt(1.0 + over * over);
        kappa = kappa * M::root(once);
      }
      if (!M::any(share < 1.0)) return kappa;
      return share * kappa + (1.0 - share) * metal(slip, pressure);
    }
  };

  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactPoint<T>& c) const {
    using M = ScalarMath<T>;
    using Log = ScalarLog<T>;
    const T u2 = c.entrainment * c.entrainment + film.least_speed2;
    const T log_u = 0.5 * Log::log(u2);
    const T log_Q = Log::log(M::max(c.load, T(film.least_load)));
    const T log_h = film.log_central + 0.67 * log_u - 0.067 * log_Q;
    // Inlet heating, with its floor of 0.1 (thermal_reduction.hpp).
    const T log_L = film.log_heating + 2.0 * log_u;
    const T slide = M::exp(0.415 * Log::log(c.slip * c.slip / u2 + 1e-8));
    const T raw = (1.0 - film.pressure_scale * c.peak_pressure * M::exp(0.42 * log_L)) /
                  (1.0 + 0.213 * (1.0 + 2.23 * slide) * M::exp(0.64 * log_L));
    const T above = raw - kFloor;
    const T inside = M::min(M::max(above, T(-kWidth)), T(kWidth)) + kWidth;
    const T thermal = kFloor + M::max(above - kWidth, T(0.0)) + inside * inside / (4.0 * kWidth);
    // Starvation (starvation.hpp); half widths that are none give no film.
    const T reach = c.half_minor * c.half_minor * film.inverse_diameter;
    const T log_psi =
        (2.0 / 3.0) * (Log::log(M::max(reach, T(1e-30))) - log_h) + Log::log(T(film.meniscus));
    const T near = M::min(log_psi, T(kFlooded));
    const T dry = M::exp(-1.68005 * M::exp(0.8315 * near) + 0.260137 * M::exp(1.558 * near) -
                         0.016146 * M::exp(2.296 * near));
    const T factor = thermal * M::max(1.0 - dry, T(0.0));
    const T thickness = factor * M::exp(log_h);
    const T thinnest = factor * M::exp(film.log_minimum + 0.68 * log_u - 0.073 * log_Q);
    const T s = M::min(
        M::max((thinnest - 0.95 * film.critical) / (0.1 * film.critical + 1e-15), T(0.0)), T(1.0));
    const T safe = M::max(thickness, T(1e-12));
    return {metal.at(c),
            thickness,
            s * s * (3.0 - 2.0 * s),
            film.viscosity / (film.heating * safe),
            T(film.heating),
            T(film.half_alpha),
            film.limit > 0.0 ? 1.0 / (film.limit * film.limit) : 0.0};
  }
  [[nodiscard]] double kink() const { return metal.kink(); }
  /// Slip at which heating sets in (S = 1) at 1 GPa.
  [[nodiscard]] double start() const {
    return 1.0 / (film.heating * std::exp(1e9 * film.half_alpha));
  }
  [[nodiscard]] double at_rest() const { return metal.at_rest(); }

 private:
  static constexpr double kFloor = 0.1, kWidth = 0.05, kFlooded = 7.0;
};

}  // namespace adore::tribology
