#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/limited.hpp"
#include "tribology/laws/pressure_fit.hpp"

namespace adore::tribology {

/// Traction of a Newtonian film that its own shear heats, with the measured viscosity over pressure
/// and temperature (kTrac 10): τ by newton_film.hpp with μ1(p) and β(p) = -∂ln μ/∂T at the
/// temperature of the walls, and a limiting stress. Right for rises up to some 20 K through the
/// film, where β may be held. SI.
struct MeasuredFilm {
  PressureFit log_viscosity;  ///< ln μ1 [Pa s]
  PressureFit log_heating;    ///< ln √(β μ1/(8 K)) [s/m]
  LimitedTraction limit;

  static constexpr bool kOfStrip = false;

  template <class T>
  struct Here {
    const MeasuredFilm* film;
    T inverse_thickness;

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
      fits_at<P>(film->log_viscosity, film->log_heating, pressure, viscosity, heating);
      for (int k = 0; k < P; ++k) {
        viscosity[k] = M::exp(viscosity[k]) * inverse_thickness *
                       InverseRoots<T>::first(M::max(pressure[k], T(1.0)));  // over p h
        heating[k] = M::exp(heating[k]);
      }
      for (int i = 0; i < N; ++i) {
        const T S = slip[i] * heating[i % P];
        const T S2 = S * S;
        T inverse;
        const T root = M::root_and_inverse(1.0 + S2, inverse);
        const T thinning =
            M::pick(S < 1e-3, 1.0 - S2 * (2.0 / 3.0 - S2 * (8.0 / 15.0)),
                    ScalarLog<T>::log(S + root) * inverse * M::inverse_sqrt(M::max(S2, T(1e-30))));
        kappa[i] = film->limit.of(viscosity[i % P] * slip[i] * thinning);
      }
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactPoint<T>&, const T& thickness) const {
    return {this, 1.0 / thickness};
  }
};

}  // namespace adore::tribology
