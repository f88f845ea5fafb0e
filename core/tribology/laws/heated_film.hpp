#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "base/single.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/limited.hpp"

#include <cmath>

namespace adore::tribology {

/// Traction of a Newtonian film that its own shear heats (kTrac 1 to 7, 9): τ by newton_film.hpp
/// with μ = μ* exp(α* p), κ = τ/p, with a limiting stress (limited.hpp). Limits: those of the
/// formula; walls at the bulk temperatures, no flash. SI.
struct HeatedFilm {
  double viscosity = 0.0;   ///< μ* at the walls' temperature [Pa s]
  double half_alpha = 0.0;  ///< α*/2 [1/Pa]
  double heating = 0.0;     ///< √(β* μ*/(8 K)) [s/m]
  TractionLimiter limit;
  double single_until = -1.0;  ///< film_law_of.hpp

  static constexpr bool kIsStripLaw = false;

  template <class T>
  struct Here {
    T stress_scale;  ///< μ*/(h √(β* μ*/(8 K))) [Pa]
    double heating, half_alpha;
    TractionLimiter limit;

    [[gnu::always_inline]] auto single() const requires kHasSingle<T> {
      return Here<typename SinglePrecisionOf<T>::Type>{SinglePrecisionOf<T>::both(stress_scale),
                                                       heating, half_alpha, limit};
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
      T root_viscosity[P], scale[P];
#pragma GCC unroll 8
      for (int k = 0; k < P; ++k) {
        root_viscosity[k] = M::exp(half_alpha * pressure[k]);
        scale[k] =
            stress_scale * root_viscosity[k] * InverseRoots<T>::first(M::max(pressure[k], T(1.0)));
      }
#pragma GCC unroll 8
      for (int i = 0; i < N; ++i) {
        const T S = heating * slip[i] * root_viscosity[i % P];
        const T S2 = S * S;
        T inverse;
        const T root = M::sqrt_and_inverse(1.0 + S2, inverse);
        const T asinh = ScalarAsinh<T>::of(S, S2, root, inverse);
        kappa[i] = limit.of(scale[i % P] * asinh * inverse);
      }
    }
  };

  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>&, const T& thickness) const {
    return {viscosity / (heating * thickness), heating, half_alpha, limit};
  }
};

}  // namespace adore::tribology
