#pragma once

#include "base/scalar_math.hpp"

/// Energy loss of a normal contact, of numbers or of vectors (one contact a lane), for kernels too.
/// SI.
///
///   F = max(0, Q + (d Q + c) δ̇),   c = e √k δ/(δ + δs)
/// Q the elastic load, k = dQ/dδ, δ̇ the rate of approach. Two losses, each with its own source:
/// 1. Impact: d = 3/2 α [huntcrossley1975], α [s/m] of the pair of materials. From m v dv/dδ =
///    -Q (1 + d v) an impact at speed v returns at e v,
///      d v (1 + e) = ln((1 + d v)/(1 - d e v)),  e = 1 - α v for small v     [derived, test]
/// 2. Material: loss factor η. A mass m on springs k that share it loses 2πη of its vibration
/// energy
///    per cycle, about any load, where every contact has c = η √(m k/n), n contacts on the same
///    mass [derived: c ω = η k at the natural frequency ω = √(n k/m)]; then e = η √(m/n) and the
///    logarithmic decrement is πη. In a point contact c goes with δ^(1/4), the law of Tsuji, Tanaka
///    and Ishida (1992), whose impact with α = 0 returns at the same e for every speed:
///      c = β √(m K) δ^(1/4),  β = -√5 ln e/√(π² + ln² e)          [Antypov and Elliott 2011, test]
///    Slices of a line: each has its share of the mass, e = η √(m/(n L)), with w k in place of k.
///    δs (kOnsetOverRadius) makes the onset of F continuous with its slope.
/// The squeeze of an oil film adds to e (contact/film_squeeze.hpp).
/// F never pulls: where the bracket would, F is 0. Power that is lost: (F - Q) δ̇ >= 0.
/// Limits: c is the viscous equivalent at the natural frequency of the element on its contacts;
/// slower vibrations (a shaft on all elements) lose less per cycle than a hysteretic material.
namespace adore::contact {

template <class S = double>
struct DampingLaw {
  S impact = 0.0;    ///< d [s/m]
  S material = 0.0;  ///< e [√kg]; of slices [√(kg/m)]
  S onset = 1.0;     ///< δs > 0 [m]
};

/// δs over the radius of the rolling element: a Hertz contact of steel bodies has a pressure of
/// 0.1 GPa there, (π p/(2 E*))² [choice]. Below it the roughness carries the load.
inline constexpr double kOnsetOverRadius = 2e-6;

template <class S>
[[nodiscard]] inline bool is_damped(const DampingLaw<S>& law) noexcept {
  return law.impact > 0.0 || law.material > 0.0;
}

/// F. @param stiffness k, of slices w k; approach >= 0 [m]; rate of approach [m/s]
template <class T, class S>
[[nodiscard, gnu::always_inline]] inline T damped_load(const DampingLaw<S>& law, const T& load,
                                                       const T& stiffness, const T& approach,
                                                       const T& rate) noexcept {
  using M = ScalarMath<T>;
  const T c = law.material * M::root(stiffness) * (approach / (approach + law.onset));
  return M::max(load + (law.impact * load + c) * rate, T(0.0));
}

/// k of a load that goes with a power of the approach, from the load and its energy.
[[nodiscard]] inline double power_law_stiffness(double load, double energy,
                                                double approach) noexcept {
  return load * (load / energy - 1.0 / approach);
}

}  // namespace adore::contact
