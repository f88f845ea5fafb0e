#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "base/single.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/limited.hpp"
#include "tribology/laws/pressure_fit.hpp"

namespace adore::tribology {

/// Traction of a Newtonian film that its own shear heats, with the measured viscosity over pressure
/// and temperature (kTrac 10): τ by newton_film.hpp with μ1(p) and β(p) = -∂ln μ/∂T at the
/// temperature of the walls, and a limiting stress. Right for rises up to some 20 K through the
/// film, where β may be held. SI.
struct MeasuredViscosityFilm {
  PressurePolynomial log_viscosity;  ///< ln μ1 [Pa s]
  PressurePolynomial log_heating;    ///< ln √(β μ1/(8 K)) [s/m]
  TractionLimiter limit;
  double single_until = -1.0;  ///< film_law_of.hpp

  static constexpr bool kIsStripLaw = false;

  template <class T>
  struct Here {
    const MeasuredViscosityFilm* film;
    T inverse_thickness;

    [[gnu::always_inline]] auto single() const requires kHasSingle<T> {
      return Here<typename SinglePrecisionOf<T>::Type>{
          film, SinglePrecisionOf<T>::both(inverse_thickness)};
    }
    [[gnu::always_inline]] T operator()(const T& slip, const T& pressure) const {
      T kappa[1];
      several<1, 1>(&slip, &pressure, kappa);
      return kappa[0];
    }
    /// Of N points at once at P pressures (film_law_of.hpp).
    template <int N, int P>
    [[gnu::always_inline]] void several(const T* slip, const T* pressure, T* kappa) const {
      using M = ScalarMath<T>;
      T viscosity[P], heating[P];
      evaluate_polynomial_pair<P>(film->log_viscosity, film->log_heating, pressure, viscosity,
                                  heating);
#pragma GCC unroll 8
      for (int k = 0; k < P; ++k) {
        heating[k] = M::exp(heating[k]);
        viscosity[k] =
            M::exp(viscosity[k]) * inverse_thickness *
            InverseRoots<T>::first(M::max(pressure[k], T(1.0)) * heating[k]);  // over p h
      }
#pragma GCC unroll 8
      for (int i = 0; i < N; ++i) {
        const T S = slip[i] * heating[i % P];
        const T S2 = S * S;
        T inverse;
        const T root = M::sqrt_and_inverse(1.0 + S2, inverse);
        kappa[i] =
            film->limit.of(viscosity[i % P] * ScalarAsinh<T>::of(S, S2, root, inverse) * inverse);
      }
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>&, const T& thickness) const {
    return {this, 1.0 / thickness};
  }
};

}  // namespace adore::tribology
