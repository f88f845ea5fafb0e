#pragma once

/// Input of a traction law for one contact, from which it makes its functor. SI. T is double or a
/// vector of doubles, one contact a lane; unused values cost nothing.
///
/// A law is a value type with
///   template <class T> auto at(const ContactConditions<T>&) const;   per contact, once
///       -> functor: T operator()(const T& slip, const T& pressure) const   κ at slip > 0 [m/s] and
///          pressure [Pa]
///   static constexpr bool kDependsOnPressure;   false: the pressure is not formed, and is passed
///   as 0 double kink() const;    slip where κ bends, for integrals that are split there; 0:
///   nowhere double start() const;   slip over which κ rises from 0 (split ellipse rule); 0: none
///   double at_rest() const; κ(0); not 0: rounded over kRegularizationSlip (decision 042)
/// in a file of its own, which includes nothing but this and base/scalar_math.hpp and
/// scalar_log.hpp (race kernels see it), and a place in TractionLawList (traction_laws.hpp). That
/// is all: kernels, converged integrals, slices and reports take it from there. Laws with a
/// lubricant's film are written as the film alone (film_law_of.hpp).
namespace adore::tribology {

/// A point contact, or a line: then loads are per length and half_major is not read.
template <class T>
struct ContactConditions {
  T load{};                      ///< Q [N]; line: [N/m]
  T peak_pressure{};             ///< of Hertz [Pa]
  T half_major{}, half_minor{};  ///< a, b: across and along rolling [m]
  T entrainment{};  ///< mean speed of both surfaces along the rolling direction, relative to the
                    ///< contact [m/s]; signed
  T slip{};         ///< in the middle of the contact [m/s], >= 0
  T curvature{};    ///< 1/R of both bodies along rolling [1/m]; 0: that of the law
};

/// Does the law have a film? Then strips along rolling are available (film_law_of.hpp).
template <class Law>
inline constexpr bool kHasFilm = requires(const Law& law) {
  law.film;
};
/// Does its functor want the peak pressure of a strip along rolling instead of that of a point?
template <class Law>
[[nodiscard]] constexpr bool is_strip_law() {
  if constexpr (requires { Law::kIsStripLaw; })
    return Law::kIsStripLaw;
  else
    return false;
}

}  // namespace adore::tribology
