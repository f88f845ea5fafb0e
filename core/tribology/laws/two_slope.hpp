#pragma once

#include "base/scalar_math.hpp"
#include "tribology/laws/contact_point.hpp"

namespace adore::tribology {

/// κ = A + B u for u <= u0, A + B u0 + C (u - u0) above (traction_curve.hpp, type 0).
struct TwoSlopeLaw {
  double A = 0.0, B = 0.0, C = 0.0, u0 = 0.0;

  static constexpr bool kDependsOnPressure = false;
  static constexpr bool kDependsOnlyOnSlip = true;

  template <class T>
  struct Here {
    T A, B, C, u0;
    [[gnu::always_inline]] T operator()(const T& slip, const T&) const {
      const T below = ScalarMath<T>::min(slip, u0);
      return A + B * below + C * (slip - below);
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>&) const {
    return {T(A), T(B), T(C), T(u0)};
  }
  [[nodiscard]] double kink() const { return u0; }
  [[nodiscard]] double start() const { return u0; }
  [[nodiscard]] double at_rest() const { return A; }
};

}  // namespace adore::tribology
