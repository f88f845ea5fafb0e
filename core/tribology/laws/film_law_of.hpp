#pragma once

#include "base/scalar_math.hpp"
#include "base/single.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/film_of_contact.hpp"
#include "tribology/laws/metal.hpp"

#include <utility>

/// A law of traction of contacts with a lubricant's film (film_of_contact.hpp). Where the thinnest
/// film falls below the critical one the contact is metallic: κ of record 10.1. Both are blended
/// over h/h_crit 0.95 to 1.05 by w = s² (3 - 2s): κ = w κ_film + (1 - w) κ_metal (decision 273). No
/// rolling, no load: no film, metal contact.
///
/// A film is a value type with
///   template <class T> auto at(const ContactConditions<T>&, const T& thickness) const;
///       -> functor: T operator()(const T& slip, const T& pressure) const   κ of the film
///   static constexpr bool kIsStripLaw;   true: the functor wants the peak pressure of the strip
///   along
///       rolling in which the point lies, gives the mean over the strip at that slip, and has
///       row(peak) -> T operator()(const T& slip), the same with the strip's part done once
/// where its points are dear, wanted(share) of the functor: 0 for those that are not read;
/// and, where it is a long chain of dependent sums, several<N, P>(slip, pressure, kappa) for N
/// points at once, whose chains overlap, point i at pressure i % P. Where single(), the same
/// functor in single precision, is there too, points up to the pressure single_until of the film (<
/// 0: none) are taken with it, by vectors of twice as many: relative errors of κ are a few 1e-6, at
/// two thirds of the cost (decision 460). try_several may leave points to double
/// precision. Slip is rounded over kRegularizationSlip by all of them (decision 275).
namespace adore::tribology {

/// Mean of κ over a strip along rolling, weighted by its pressure p √(1 - x²): six Chebyshev points
/// of the second kind, of which three differ. Error of κ some 0.1 %, up to 2.5 % where a limiting
/// stress is reached inside the strip.
template <class Here, class T>
struct StripMean {
  /// The same where the film may leave points to double precision; false: it does.
  [[gnu::always_inline]] bool try_strip_mean(const T& slip, T& mean) const {
    if constexpr (requires(T * at) { law.template try_several<3, 3>(at, at, at); }) {
      const T slips[3] = {slip, slip, slip};
      const T pressures[3] = {0.43388373911756 * peak, 0.78183148246803 * peak,
                              0.97492791218182 * peak};
      T kappa[3];
      if (!law.template try_several<3, 3>(slips, pressures, kappa)) return false;
      mean =
          0.10757434232608 * kappa[0] + 0.34929169541609 * kappa[1] + 0.54313396225783 * kappa[2];
    } else {
      mean = (*this)(slip);
    }
    return true;
  }

  const Here& law;
  T peak;
  [[gnu::always_inline]] T operator()(const T& slip) const {
    // sin(jπ/7) and 4/7 sin²(jπ/7), j = 1, 2, 3.
    if constexpr (requires(T * at) { law.template several<3, 3>(at, at, at); }) {
      const T slips[3] = {slip, slip, slip};
      const T pressures[3] = {0.43388373911756 * peak, 0.78183148246803 * peak,
                              0.97492791218182 * peak};
      T kappa[3];
      law.template several<3, 3>(slips, pressures, kappa);
      return 0.10757434232608 * kappa[0] + 0.34929169541609 * kappa[1] +
             0.54313396225783 * kappa[2];
    } else {
      return 0.10757434232608 * law(slip, 0.43388373911756 * peak) +
             0.34929169541609 * law(slip, 0.78183148246803 * peak) +
             0.54313396225783 * law(slip, 0.97492791218182 * peak);
    }
  }
};

template <class Film>
struct FilmTractionLaw {
  MetalLaw metal;
  ContactFilmModel film;
  Film fluid;

  static constexpr bool kDependsOnPressure = true;
  static constexpr bool kIsStripLaw = Film::kIsStripLaw;

  template <class T>
  struct Here {
    using Fluid = decltype(std::declval<const Film&>().at(
        std::declval<const ContactConditions<T>&>(), std::declval<const T&>()));
    MetalLaw::Here<T> metal;
    LocalFilm<T> film;
    Fluid fluid;
    double single_until;  ///< of the film [Pa]

    /// κ_film -> κ.
    template <class Kappa>
    [[gnu::always_inline]] T blend_with_metal(const T& slip, const Kappa& kappa) const {
      using M = ScalarMath<T>;
      if (!M::any(film.share > 0.0)) return metal(slip, T(0.0));
      const T of_film = kappa(slip);
      if (!M::any(film.share < 1.0)) return of_film;
      return film.share * of_film + (1.0 - film.share) * metal(slip, T(0.0));
    }
    [[gnu::always_inline]] T operator()(const T& slip, const T& pressure) const {
      return blend_with_metal(slip, [&](const T& s) { return fluid(s, pressure); });
    }

    /// N points at once, where the film can.
    template <int N, int P>
    [[gnu::always_inline]] void several(const T* slip, const T* pressure,
                                        T* kappa) const requires requires {
      fluid.template several<N, P>(slip, pressure, kappa);
    }
    {
      using M = ScalarMath<T>;
      const bool any_film = M::any(film.share > 0.0), any_metal = M::any(film.share < 1.0);
      if (any_film) fluid_coefficients<N, P>(slip, pressure, kappa);
      if (!any_metal) return;
      for (int i = 0; i < N; ++i) {
        const T of_metal = metal(slip[i], T(0.0));
        kappa[i] = any_film ? film.share * kappa[i] + (1.0 - film.share) * of_metal : of_metal;
      }
    }

    /// κ of the film at N points: in single precision up to the pressure where the film has it.
    template <int N, int P>
    [[gnu::always_inline]] void fluid_coefficients(const T* slip, const T* pressure,
                                                   T* kappa) const {
      if constexpr (requires { fluid.single(); } && N % 2 == 0 && P % 2 == 0) {
        T most = pressure[0];
        for (int k = 1; k < P; ++k) most = ScalarMath<T>::max(most, pressure[k]);
        if (!ScalarMath<T>::any(most > single_until) &&
            try_single_precision<N, P>(slip, pressure, kappa))
          return;
      }
      fluid.template several<N, P>(slip, pressure, kappa);
    }
    template <int N, int P>
    [[gnu::always_inline]] bool try_single_precision(const T* slip, const T* pressure,
                                                     T* kappa) const {
      using To = SinglePrecisionOf<T>;
      typename To::Type slips[N / 2], pressures[P / 2], of[N / 2];
#pragma GCC unroll 8
      for (int i = 0; i < N / 2; ++i) slips[i] = To::pack(slip[2 * i], slip[2 * i + 1]);
#pragma GCC unroll 8
      for (int k = 0; k < P / 2; ++k) pressures[k] = To::pack(pressure[2 * k], pressure[2 * k + 1]);
      const auto single = fluid.single();
      if constexpr (requires { single.template try_several<N / 2, P / 2>(slips, pressures, of); }) {
        if (!single.template try_several<N / 2, P / 2>(slips, pressures, of)) return false;
      } else {
        single.template several<N / 2, P / 2>(slips, pressures, of);
      }
#pragma GCC unroll 8
      for (int i = 0; i < N / 2; ++i) To::unpack(of[i], kappa[2 * i], kappa[2 * i + 1]);
      return true;
    }

    /// The mean of a strip in single precision; false: double precision is wanted.
    [[gnu::always_inline]] bool try_strip_mean(const T& peak, const T& slip, T& kappa) const {
      using M = ScalarMath<T>;
      kappa = 0.0;
      const bool any_film = M::any(film.share > 0.0);
      if (any_film) {
        if constexpr (Film::kIsStripLaw) {
          if (!fluid.template try_several<1, 1>(&slip, &peak, &kappa)) return false;
        } else {
          if (!StripMean<Fluid, T>{fluid, peak}.try_strip_mean(slip, kappa)) return false;
        }
      }
      if (!M::any(film.share < 1.0)) return true;
      const T of_metal = metal(slip, T(0.0));
      kappa = any_film ? film.share * kappa + (1.0 - film.share) * of_metal : of_metal;
      return true;
    }

    /// One strip along rolling, peak pressure `peak`.
    template <class Row>
    struct Strip {
      const Here& law;
      Row row;
      [[gnu::always_inline]] T operator()(const T& slip, const T& = {}) const {
        return law.blend_with_metal(slip, row);
      }
    };
    [[gnu::always_inline]] auto strip(const T& peak) const {
      if constexpr (Film::kIsStripLaw) {
        using Row = decltype(fluid.row(peak));
        return Strip<Row>{*this, fluid.row(peak)};
      } else {
        return Strip<StripMean<Fluid, T>>{*this, {fluid, peak}};
      }
    }
  };

  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>& c) const {
    if constexpr (kHasSingle<T> && requires { fluid.single_until; })
      if (fluid.single_until >= 0.0) return at(c, film.by_floats(c));
    return at(c, film.at(c));
  }
  /// The same where the film of the contact is known.
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>& c, const LocalFilm<T>& here) const {
    double single = -1.0;
    if constexpr (requires { fluid.single_until; }) single = fluid.single_until;
    Here<T> out{metal.at(c), here, fluid.at(c, ScalarMath<T>::max(here.thickness, T(1e-12))),
                single};
    if constexpr (requires { out.fluid.wanted(here.share); }) out.fluid.wanted(here.share);
    return out;
  }
  [[nodiscard]] double kink() const { return metal.kink(); }
  /// Steep, and the steeper the larger the pressure: pieces end where spin has them (decision 414).
  [[nodiscard]] double start() const { return 0.0; }
  [[nodiscard]] double at_rest() const { return metal.at_rest(); }
};

}  // namespace adore::tribology
