#pragma once

#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/limited.hpp"
#include "tribology/laws/pressure_fit.hpp"

namespace adore::tribology {

/// Traction of a film that thins with shear (Carreau, a = 2) and is heated by it, with the measured
/// viscosity over pressure and temperature (kTrac 11, 13 to 20), with a limiting stress. SI.
///
/// The stress of shear_thinning_film.hpp: τ = G r E, E = (1 + r²)^((n-1)/2), where r solves
///   r = r0 f(S),  S² = D0 E,  r0 = μ1 Δu/(h G),  D0 = Δu² β μ1/(8 K),  f = asinh(S)/(S √(1 + S²)).
/// In ln r the right side rises with a slope m below 1 - n: Newton in ln r, from the step at r = r0
/// but not below r0/(1 + ⅔ D0), which f(√D0) exceeds. A fixed number of steps, so that κ is smooth
/// and every lane ends alike; powers of ratios near 1 by (1 + e)^k = (1 + (1+k) e/2)/(1 + (1-k)
/// e/2). Two steps leave 7e-4 of the stress at n = 0.35 in the worst of r0 1e-4 to 1e8, D0 1e-6 to
/// 1e7, and below 1e-5 nearly everywhere (measured in the tests).
struct ThinningFilm {
  PressureFit log_viscosity;  ///< ln μ1 [Pa s]
  PressureFit log_heating;    ///< ln √(β μ1/(8 K)) [s/m]
  double modulus = 0.0;       ///< G [Pa]
  double half_power = 0.0;    ///< (n - 1)/2
  LimitedTraction limit;
  double start_slip = 0.0;

  static constexpr bool kOfStrip = false;

  template <class T>
  struct Here {
    const ThinningFilm* film;
    T inverse_thickness;

    [[gnu::always_inline]] T operator()(const T& slip, const T& pressure) const {
      T kappa[1];
      several<1>(&slip, &pressure, kappa);
      return kappa[0];
    }
    /// Of N points at once (film_law_of.hpp).
    template <int N>
    [[gnu::always_inline]] void several(const T* slip, const T* pressure, T* kappa) const {
      using M = ScalarMath<T>;
      using Log = ScalarLog<T>;
      const auto inverse_of = [](const T& x) {  // of what is positive
        const T root = M::inverse_sqrt(x);
        return root * root;
      };
      const double half = film->half_power, over_modulus = 1.0 / film->modulus;
      T log_viscosity[N], log_heating[N];
      film->log_viscosity.template at<N>(pressure, log_viscosity);
      film->log_heating.template at<N>(pressure, log_heating);
      T r0[N], D0[N], w[N], product[N];  // w: r/r0, product: w E
      for (int i = 0; i < N; ++i) {
        r0[i] = M::exp(log_viscosity[i]) * slip[i] * inverse_thickness * over_modulus;
        const T S0 = slip[i] * M::exp(log_heating[i]);
        D0[i] = S0 * S0;
        w[i] = product[i] = 1.0;
      }
      for (int step = 0; step < 3; ++step)
        for (int i = 0; i < N; ++i) {
          // f, E and their slopes in ln w.
          const T r = r0[i] * w[i], q = r * r;
          const T E = M::exp(half * Log::log(1.0 + q)),
                  E_slope = 2.0 * half * q * inverse_of(1.0 + q);
          const T S2 = M::max(D0[i] * E, T(1e-30)), over_S = M::inverse_sqrt(S2), S = S2 * over_S;
          T over_root;
          const T root = M::root_and_inverse(1.0 + S2, over_root);
          const auto small = S < 1e-3;
          const T asinh = M::max(Log::log(S + root), T(1e-12));
          const T f = M::pick(small, 1.0 - S2 * (2.0 / 3.0 - S2 * (8.0 / 15.0)),
                              asinh * over_root * over_S);
          const T f_slope =
              M::pick(small, -(4.0 / 3.0) * S2,
                      S * over_root * inverse_of(asinh) - 1.0 - S2 * over_root * over_root);
          const T k = inverse_of(1.0 - 0.5 * f_slope * E_slope);
          if (step == 0) {
            w[i] = M::max(M::exp(k * Log::log(f)), inverse_of(1.0 + (2.0 / 3.0) * D0[i]));
            continue;
          }
          const T e = f * inverse_of(w[i]) - 1.0;
          const T ratio = (1.0 + 0.5 * (1.0 + k) * e) / (1.0 + 0.5 * (1.0 - k) * e);
          if (step == 2) {
            const T g = 1.0 + E_slope, d = ratio - 1.0;
            product[i] = w[i] * E * (1.0 + 0.5 * (1.0 + g) * d) / (1.0 + 0.5 * (1.0 - g) * d);
          }
          w[i] = w[i] * ratio;
        }
      for (int i = 0; i < N; ++i)
        kappa[i] = film->limit.of(film->modulus * r0[i] * product[i] / M::max(pressure[i], T(1.0)));
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactPoint<T>&, const T& thickness) const {
    return {this, 1.0 / thickness};
  }
  [[nodiscard]] double start() const { return start_slip; }
};

}  // namespace adore::tribology
