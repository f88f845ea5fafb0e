#pragma once

#include "contact/roller_race_sum.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/traction_laws.hpp"

/// Laws of traction as the slices of rollers ask for them (contact/roller_race_sum.hpp). Seen by
/// the roller kernels.
namespace adore::dynamics {

/// A law with a lubricant's film: each slice has the film of its own load per length, speed and
/// slip, and the mean traction over its strip along rolling.
template <class Law>
struct FilmOnSlices {
  const Law& law;
  double floor;  ///< ε² of the rounded slip [m²/s²]

  template <class T>
  struct Here {
    const Law& law;
    const contact::SlicePlace<T>& s;
    double floor;
    /// κ(s)/s from u². A call, so that a kernel has one copy of each law.
    [[gnu::noinline]] T operator()(const T& square) const {
      const auto here =
          law.at(tribology::ContactPoint<T>{s.load_per_length, s.peak_pressure, T(0.0),
                                            s.half_width, s.entrainment, s.slip, s.curvature});
      const auto strip = here.strip(s.peak_pressure);
      return tribology::RoundedLaw<decltype(strip)>{strip, floor}(square, s.peak_pressure);
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> on(const contact::SlicePlace<T>& s) const {
    return {law, s, floor};
  }
};

/// f(traction) with what roller_race_sums wants of a law on T.
template <class T, class Law, class F>
[[gnu::always_inline]] inline decltype(auto) with_slice_law(const Law& law, double floor, F&& f) {
  if constexpr (tribology::kHasFilm<Law>) {
    return f(FilmOnSlices<Law>{law, floor});
  } else {
    const auto here = law.at(tribology::ContactPoint<T>{});
    return f(tribology::RoundedLaw<decltype(here)>{here, floor});
  }
}

}  // namespace adore::dynamics
