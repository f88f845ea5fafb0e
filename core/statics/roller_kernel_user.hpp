#pragma once

#include "base/simd_math.hpp"
#include "contact/roller_race_sum.hpp"
#include "statics/roller_kernel.hpp"
#include "tribology/laws/user_law.hpp"

#include <cstddef>

/// A user law in the roller kernels: the slices of all rollers on a race are evaluated
/// once and stored, the routine is called once for those with load, and forces, moments and
/// heat are added with its answers, in the order of a built-in law. Decision 431.
namespace adore::statics {
namespace {

struct UserSliceCollector {
  const UserLawSlices& to;
  double floor;  ///< ε² of the rounded slip [m²/s²]
  std::size_t& column;

  template <class T>
  [[gnu::always_inline]] void keep(const contact::LoadedSlice<T>& c,
                                   const contact::SliceContactState<T>& at) const {
    T inverse;
    const T slip = ScalarMath<T>::sqrt_and_inverse(c.square + floor, inverse), none = 0.0;
    const T* contact[7] = {&at.load_per_length, &at.peak_pressure, &none,   &at.half_width,
                           &at.entrainment,     &at.curvature,     &at.slip};
    for (int k = 0; k < 7; ++k) contact[k]->copy_to(to.contact[k] + column, stdx::element_aligned);
    const T* kept[11] = {&c.Q,     &c.n.x,    &c.n.y,    &c.n.z,    &c.arm.x, &c.arm.y,
                         &c.arm.z, &c.slip.x, &c.slip.y, &c.slip.z, &c.square};
    for (int k = 0; k < 11; ++k) kept[k]->copy_to(to.kept[k] + column, stdx::element_aligned);
    slip.copy_to(to.slip + column, stdx::element_aligned);
    inverse.copy_to(to.inverse + column, stdx::element_aligned);
    column += T::size();
  }
};

/// Asks for what was collected. The pressure of the point is that of the line.
inline void call_user_routine(const tribology::UserTractionLaw& law, const UserLawSlices& user,
                              std::size_t n) {
  if (n == 0) return;
  const auto count = static_cast<long>(n);
  law.of->ask(law.of->routine, {law.kind, law.race, count, 1, count, user.slip,
                                law.of->wants_pressure ? user.contact[1] : nullptr, user.contact[0],
                                user.contact[1], user.contact[2], user.contact[3], user.contact[4],
                                user.contact[5], user.contact[6], user.kappa});
}

inline void add_user_law_results(const UserLawSlices& user, std::size_t column,
                                 contact::RollerRaceSums<SimdReal>& sums) {
  using T = SimdReal;
  const auto at = [column](const double* from) { return T(from + column, stdx::element_aligned); };
  double* const* k = user.kept;
  const contact::LoadedSlice<T> slice{at(k[0]),
                                      {at(k[1]), at(k[2]), at(k[3])},
                                      {at(k[4]), at(k[5]), at(k[6])},
                                      {at(k[7]), at(k[8]), at(k[9])},
                                      at(k[10])};
  contact::add_loaded_slice(sums, slice,
                            ScalarMath<T>::over(at(user.kappa), at(user.slip), at(user.inverse)));
}

}  // namespace
}  // namespace adore::statics
