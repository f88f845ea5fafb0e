#pragma once

#include "base/scalar_math.hpp"
#include "tribology/laws/contact_point.hpp"

namespace adore::tribology {

/// κ = (A + B u) exp(-C u) + D (traction_curve.hpp, types -1, 1 and 2).
struct ExponentialLaw {
  double A = 0.0, B = 0.0, C = 0.0, D = 0.0;

  static constexpr bool kDependsOnPressure = false;
  static constexpr bool kDependsOnlyOnSlip = true;

  template <class T>
  struct Here {
    T A, B, C, D;
    [[gnu::always_inline]] T operator()(const T& slip, const T&) const {
      return (A + B * slip) * ScalarMath<T>::exp(-C * slip) + D;
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>&) const {
    return {T(A), T(B), T(C), T(D)};
  }
  [[nodiscard]] double kink() const { return 0.0; }
  [[nodiscard]] double start() const { return C > 0.0 ? 1.0 / C : 0.0; }
  [[nodiscard]] double at_rest() const { return A + D; }
};

}  // namespace adore::tribology
