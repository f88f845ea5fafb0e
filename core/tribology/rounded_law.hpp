#pragma once

#include "base/scalar_math.hpp"

/// The one rounding of slip (decisions 042 and 195). Seen by the race kernels.
namespace adore::tribology {

/// Slip below which laws with κ(0) ≠ 0 are rounded [m/s]. Stated in PRINT.txt.
inline constexpr double kRegularizationSlip = 1e-5;
/// ε² of laws that need no rounding [m²/s²]: κ(s)/s is finite at rest.
inline constexpr double kNoRegularization = 1e-24;

/// Traction over load and slip, κ(s)/s with the rounded slip s = √(u² + ε²): the traction on a body
/// is load × this × slip vector u. Finite at rest, smooth in every component of the slip; its power
/// is load × κ(s) u²/s >= 0, nothing at rest. ε = kRegularizationSlip when κ(0) ≠ 0, else 1e-12
/// m/s. Where κ(0) = κ0 ≠ 0 it damps slips below ε by κ0 load/ε [N s/m], which limits explicit
/// steps.
/// @param Here functor of one contact, or of one a lane (laws/contact_point.hpp)
template <class Here>
struct RegularizedLaw {
  Here law;
  double floor = kNoRegularization;  ///< ε² [m²/s²]

  /// @param square u² [m²/s²]; pressure [Pa]
  template <class T>
  [[gnu::always_inline]] T operator()(const T& square, const T& pressure = T(0.0)) const {
    T slip;
    return coefficient_over_slip(square + floor, pressure, slip);
  }
  /// The same from s²; also gives s [m/s].
  template <class T>
  [[gnu::always_inline]] T coefficient_over_slip(const T& rounded_square, const T& pressure,
                                                 T& slip) const {
    T inverse;
    slip = ScalarMath<T>::sqrt_and_inverse(rounded_square, inverse);
    return ScalarMath<T>::over(law(slip, pressure), slip, inverse);
  }
};

}  // namespace adore::tribology
