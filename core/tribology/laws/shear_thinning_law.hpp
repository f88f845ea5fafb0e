#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "base/single.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/limited.hpp"
#include "tribology/laws/pressure_fit.hpp"
#include "tribology/laws/spline_axis.hpp"

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
///
/// ln(τ/(G r0)) is a function of ln r0 and ½ ln D0 alone, the same for all lubricants with that n:
/// where `surface` is set it is read from a cubic spline over both, made at set-up
/// (thinning_surface.hpp, which measures its error). Below the least of each it is that of no
/// thinning or no heating; points above the largest are solved as without a surface.
struct ShearThinningFriction {
  PressurePolynomial log_viscosity;  ///< ln μ1 [Pa s]
  PressurePolynomial log_heating;    ///< ln √(β μ1/(8 K)) [s/m]
  double modulus = 0.0;              ///< G [Pa]
  double half_power = 0.0;           ///< (n - 1)/2
  TractionLimiter limit;
  const double* surface = nullptr;  ///< [ln r0][½ ln D0]; null: every point is solved
  SplineAxis log_rate{}, log_heat{};
  double most_rate = 0.0, most_heat = 0.0;  ///< that the surface covers
  /// The surface for single precision: 16 powers of each cell (base/single.hpp).
  const float* tiles = nullptr;
  double single_until = -1.0;  ///< film_law_of.hpp

  static constexpr bool kIsStripLaw = false;

  template <class T>
  struct Here {
    const ShearThinningFriction* film;
    T log_scale;  ///< -ln(h G)

    [[gnu::always_inline]] auto single() const requires kHasSingle<T> {
      return Here<typename SinglePrecisionOf<T>::Type>{film, SinglePrecisionOf<T>::both(log_scale)};
    }
    [[gnu::always_inline]] T operator()(const T& slip, const T& pressure) const {
      T kappa[1];
      several<1, 1>(&slip, &pressure, kappa);
      return kappa[0];
    }
    /// ln(τ/(G r0)) of the surface.
    [[gnu::always_inline]] T read(const T& rate, const T& heat) const {
      using Lanes = ScalarLanes<T>;
      const auto along = film->log_rate.at(rate), across = film->log_heat.at(heat);
      const int lines = film->log_heat.knots;
      const T place = along.cell * static_cast<double>(lines) + across.cell;
      return Lanes::patch(film->surface, lines, place, along.weight, across.weight);
    }
    /// N points in single precision, from the tiles; false where they do not reach.
    template <int N, int P>
    [[gnu::always_inline]] bool try_several(const T* slip, const T* pressure, T* kappa) const {
      using M = ScalarMath<T>;
      T viscosity[P], heating[P], over_pressure[P];
      evaluate_polynomial_pair<P>(film->log_viscosity, film->log_heating, pressure, viscosity,
                                  heating);
#pragma GCC unroll 8
      for (int k = 0; k < P; ++k) {
        over_pressure[k] = film->modulus * InverseRoots<T>::first(M::max(pressure[k], T(1.0)));
        viscosity[k] = viscosity[k] + log_scale;
      }
      T rate[N], heat[N];  // ln r0, ½ ln D0
      T most_rate = -1e30, most_heat = -1e30;
#pragma GCC unroll 8
      for (int i = 0; i < N; ++i) {
        const T log_slip = ScalarLog<T>::log(M::max(slip[i], T(1e-30)));
        rate[i] = viscosity[i % P] + log_slip;
        heat[i] = heating[i % P] + log_slip;
        most_rate = M::max(most_rate, rate[i]);
        most_heat = M::max(most_heat, heat[i]);
      }
      if (M::any(most_rate > film->most_rate) || M::any(most_heat > film->most_heat)) return false;
      const double line = film->log_heat.knots - 3;
#pragma GCC unroll 8
      for (int i = 0; i < N; ++i) {
        const auto along = film->log_rate.cell(rate[i]), across = film->log_heat.cell(heat[i]);
        rate[i] = rate[i] + ScalarTiles<T>::at(film->tiles, along.cell * line + across.cell,
                                               along.inside, across.inside);
      }
#pragma GCC unroll 8
      for (int i = 0; i < N; ++i) kappa[i] = film->limit.of(M::exp(rate[i]) * over_pressure[i % P]);
      return true;
    }
    /// Of N points at once at P pressures (film_law_of.hpp).
    template <int N, int P>
    [[gnu::always_inline]] void several(const T* slip, const T* pressure, T* kappa) const {
      using M = ScalarMath<T>;
      T viscosity[P], heating[P], over_pressure[P];
      evaluate_polynomial_pair<P>(film->log_viscosity, film->log_heating, pressure, viscosity,
                                  heating);
      for (int k = 0; k < P; ++k)
        over_pressure[k] = film->modulus * InverseRoots<T>::first(M::max(pressure[k], T(1.0)));
      T rate[N], heat[N];  // ln r0, ½ ln D0
      for (int i = 0; i < N; ++i) {
        const T log_slip = ScalarLog<T>::log(M::max(slip[i], T(1e-30)));
        rate[i] = viscosity[i % P] + log_scale + log_slip;
        heat[i] = heating[i % P] + log_slip;
      }
      T stress[N];  // over G
      const bool on_surface = film->surface != nullptr;
      bool beyond = !on_surface;
      if (on_surface) {
        for (int i = 0; i < N; ++i) {
          stress[i] = M::exp(rate[i] + read(rate[i], heat[i]));
          beyond = beyond || M::any(rate[i] > film->most_rate) || M::any(heat[i] > film->most_heat);
        }
      }
      if (beyond) {
        T solved[N];
        solve<N>(rate, heat, solved);
        for (int i = 0; i < N; ++i)
          stress[i] = on_surface ? M::pick(rate[i] > film->most_rate, solved[i],
                                           M::pick(heat[i] > film->most_heat, solved[i], stress[i]))
                                 : solved[i];
      }
      for (int i = 0; i < N; ++i) kappa[i] = film->limit.of(stress[i] * over_pressure[i % P]);
    }

   private:
    /// τ/G of ln r0 and ½ ln D0 by the equation.
    template <int N>
    [[gnu::always_inline]] void solve(const T* rate, const T* heat, T* stress) const {
      using M = ScalarMath<T>;
      using Log = ScalarLog<T>;
      const auto inverse_of = [](const T& x) {  // of what is positive
        const T root = M::inverse_sqrt(x);
        return root * root;
      };
      const double half = film->half_power;
      T r0[N], D0[N], w[N], product[N];  // w: r/r0, product: w E
      for (int i = 0; i < N; ++i) {
        r0[i] = M::exp(rate[i]);
        const T S0 = M::exp(heat[i]);
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
          const T root = M::sqrt_and_inverse(1.0 + S2, over_root);
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
      for (int i = 0; i < N; ++i) stress[i] = r0[i] * product[i];
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>&, const T& thickness) const {
    return {this, -ScalarLog<T>::log(thickness * modulus)};
  }
};

}  // namespace adore::tribology
