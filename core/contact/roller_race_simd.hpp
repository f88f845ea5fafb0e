#pragma once

#include "base/simd_math.hpp"
#include "contact/roller_race_sum.hpp"

/// roller_race_sum.hpp with a slice in every lane of the widest vector that the including
/// translation unit is compiled for.
namespace adore::contact {

template <class Abi>
struct SliceLanes<stdx::simd<double, Abi>> {
  using V = stdx::simd<double, Abi>;
  static constexpr std::size_t kSize = V::size();
  static_assert(8 % kSize == 0);  // RollerRaceSlices::kPadding
  static V read(const double* from) { return V(from, stdx::element_aligned); }
  static double sum(const V& x) { return stdx::reduce(x); }
};

}  // namespace adore::contact
