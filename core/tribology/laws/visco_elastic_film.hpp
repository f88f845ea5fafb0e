#pragma once

#include "base/constants.hpp"
#include "base/scalar_lanes.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "base/single.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/laws/spline_axis.hpp"

namespace adore::tribology {

/// Constants of a visco-elastic liquid at the temperature of the walls (viscoelastic_strip.hpp).
struct ViscoElasticLiquid {
  bool sinh_law = false;
  double viscosity = 0.0, alpha = 0.0;  ///< μ0 [Pa s], α [1/Pa]
  double modulus = 0.0, modulus_p = 0.0, stress = 0.0, stress_p = 0.0;
};

/// Traction of a visco-elastic film (kTrac 8, 12): the stress integrated along each strip of
/// rolling (viscoelastic_strip.hpp), read from a surface that is made at set-up
/// (visco_elastic_surface.hpp, which measures its error), or integrated on the spot. SI.
///
/// With ξ = x/b the strip's equation is dτ/dξ = (G b/u)(γ - (τ0/μ) F(τ/τ0)): its mean stress
/// depends on its peak pressure p, on γ = slip/h and on b/u, which is c p with c = b/(u p0) the
/// same for all strips of a contact. With κ_s the stress limit over the pressure and γ_r(p, c) the
/// rate at which κ would reach it along its slope at no slip, both cubic splines over √p and ln c,
///   κ = κ_s exp S(w, p, c),  w = ln(γ/γ_r),
/// S a cubic spline. Below the least w κ is linear in γ (S = w), and above the largest the stress
/// is at its limit. Where p or c lie beyond the surface the strip is integrated (`integral`), never
/// held at the edge; so are all strips where `direct` is set. κ is a function of the size of the
/// slip: traction is odd in it.
///
/// iTherm (kTrac 12): walls are hotter than their bodies by the mean flash of the strip under its
/// own heat, ΔT = q/Σ C, q = κ p̄ slip, p̄ = π p/4; C = 3/2 k √(π (1.273 + Pe))/(2 b) of each body,
/// Pe = u b ρc/(2k): two thirds of the largest rise (contact_flash.hpp), the share of a moving
/// band. Moduli and limits soften by s = exp(-bT ΔT), the viscosity by m(ΔT). The equation then is
/// that of the walls' temperature with γ ρ, c/ρ and the result times s, ρ = m/s, exactly where α
/// does not change; its change is taken at p̄. κ(ΔT) falls, so that there is one ΔT; found by two
/// chords.
struct ViscoElasticFilm {
  const double* saturation = nullptr;   ///< S: [transit][pressure][slip]
  const double* corner = nullptr;       ///< ln γ_r: [transit][pressure], separate axes
  double stress = 0.0, stress_p = 0.0;  ///< κ_s = stress_p + 4/π stress/p
  /// Both for single precision: 16 powers of each cell over pressure and slip, of all transits
  /// one behind the other; over transit and pressure of the corner (base/single.hpp).
  const float *tiles = nullptr, *corner_tiles = nullptr;
  double single_until = -1.0;  ///< film_law_of.hpp
  SplineAxis root_pressure, log_rate, log_transit, corner_root_pressure, corner_log_transit;
  double pressure[2] = {};       ///< that the surface covers [Pa]
  double range_transit[2] = {};  ///< ln c that it covers
  bool direct = false;           ///< integrate every strip
  ViscoElasticLiquid liquid;
  /// κ of one strip: peak pressure, γ [1/s], b/u [s].
  double (*integral)(const ViscoElasticLiquid&, double, double, double) noexcept = nullptr;

  struct WallHeating {
    bool on = false;
    double conductivity[2] = {};         ///< k of both bodies [W/(m K)]
    double inverse_diffusivity[2] = {};  ///< ρc/(2k) [s/m²]
    double softening = 0.0;              ///< bT [1/K]
    /// -ln m = ΔT/(inverse[0] + inverse[1] ΔT); α falls by ΔT/(alpha[0] + alpha[1] ΔT).
    double inverse[2] = {1.0, 0.0}, alpha[2] = {1e30, 0.0};
  };
  WallHeating heating;

  static constexpr bool kIsStripLaw = true;

  using Four = double __attribute__((vector_size(4 * sizeof(double))));
  [[gnu::always_inline]] static void add(double weight, const double* four, Four& sum) {
    Four one;
    __builtin_memcpy(&one, four, sizeof one);
    sum += weight * one;
  }

  /// Of one contact.
  template <class T>
  struct Place {
    const ViscoElasticFilm* film;
    T log_thickness, log_transit;  ///< ln c
    T width_over_pressure, speed;  ///< b/p0 [m/Pa], u
    T wanted;                      ///< 0: its κ is not read (a contact of metal)
  };

  template <class T>
  struct Row {
    const Place<T>* at;
    T peak;
    T log_corner;                                 ///< of γ_r h
    T ceiling;                                    ///< κ_s
    T outside;                                    ///< 1: the strip is integrated
    T log_transit;                                ///< of b/u
    const double* sheet[ScalarLanes<T>::kCount];  ///< first of the 16 lines over slip
    double weight[16][ScalarLanes<T>::kCount];

    /// At the temperature of the walls.
    [[gnu::always_inline]] T isothermal_coefficient(const T& slip) const {
      using M = ScalarMath<T>;
      using Lanes = ScalarLanes<T>;
      const ViscoElasticFilm* film = at->film;
      const T log_slip = ScalarLog<T>::log(M::max(slip, T(1e-30)));
      T kappa = 0.0;
      if (!film->direct) {
        const T w = log_slip - log_corner;
        const auto cell = film->log_rate.at(w);
        const int slips = film->log_rate.knots, size = film->root_pressure.knots * slips;
        double value[Lanes::kCount], first[Lanes::kCount], across[4][Lanes::kCount];
        Lanes::put(cell.cell, first);
        for (int i = 0; i < 4; ++i) Lanes::put(cell.weight[i], across[i]);
        for (int l = 0; l < Lanes::kCount; ++l) {
          const double* lines = sheet[l] + static_cast<int>(first[l]);
          Four sum{};
          for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
              add(weight[4 * i + j][l], lines + i * size + j * slips, sum);
          value[l] = across[0][l] * sum[0] + across[1][l] * sum[1] + across[2][l] * sum[2] +
                     across[3][l] * sum[3];
        }
        kappa = ceiling * M::exp(Lanes::from(value) + M::min(w - film->log_rate.from, T(0.0)));
      }
      if (!M::any(outside > 0.5)) return kappa;
      const T rate = M::exp(log_slip - at->log_thickness), transit = M::exp(log_transit);
      double value[Lanes::kCount];
      for (int l = 0; l < Lanes::kCount; ++l)
        value[l] = Lanes::get(outside, l) > 0.5
                       ? film->integral(film->liquid, Lanes::get(peak, l), Lanes::get(rate, l),
                                        Lanes::get(transit, l))
                       : Lanes::get(kappa, l);
      return Lanes::from(value);
    }

    [[gnu::always_inline]] T operator()(const T& slip) const {
      const T kappa = isothermal_coefficient(slip);
      return at->film->heating.on ? heated_coefficient(slip, kappa) : kappa;
    }

   private:
    [[gnu::always_inline]] T heated_coefficient(const T& slip, const T& cold) const {
      using M = ScalarMath<T>;
      const WallHeating& heat = at->film->heating;
      constexpr double kMostRise = 400.0;
      const T width = M::max(at->width_over_pressure * peak, T(1e-12));
      T conductance = 0.0;
      for (int i = 0; i < 2; ++i)
        conductance += heat.conductivity[i] *
                       M::root(kPi * (1.273 + at->speed * width * heat.inverse_diffusivity[i]));
      conductance = 0.75 * conductance / width;
      const T mean = 0.25 * kPi * peak, per_kappa = mean * slip / conductance;
      const auto coefficient_at_rise = [&](const T& rise) {
        const T log_soft = -heat.softening * rise;
        const T log_rho = -rise / (heat.inverse[0] + heat.inverse[1] * rise) - log_soft -
                          mean * rise / (heat.alpha[0] + heat.alpha[1] * rise);
        Place<T> place = *at;
        place.log_thickness -= log_rho;
        place.log_transit -= log_rho;
        return M::exp(log_soft) * make_strip_row(place, peak).isothermal_coefficient(slip);
      };
      const auto chord = [&](const T& rise, const T& kappa) {  // from no rise
        return cold / (1.0 + per_kappa * (cold - kappa) / M::max(rise, T(1e-30)));
      };
      const T first = M::min(per_kappa * cold, T(kMostRise));
      const T second = M::min(per_kappa * chord(first, coefficient_at_rise(first)), T(kMostRise));
      return chord(second, coefficient_at_rise(second));
    }
  };

  template <class T>
  [[gnu::always_inline]] static Row<T> make_strip_row(const Place<T>& place, const T& peak) {
    using M = ScalarMath<T>;
    using Lanes = ScalarLanes<T>;
    constexpr double kFourOverPi = 1.2732395447351628;
    const ViscoElasticFilm* film = place.film;
    Row<T> out;
    out.at = &place;
    out.peak = peak;
    const T p = M::max(peak, T(1.0)), root = M::root(p);
    const T asked = M::pick(peak > 1.0, place.wanted, T(0.0));
    out.log_transit = place.log_transit + ScalarLog<T>::log(p);
    if (film->direct) {
      out.outside = M::pick(asked > 0.0, T(1.0), T(0.0));
      return out;
    }
    const T& c = place.log_transit;
    const T beyond = M::pick(p < film->pressure[0], T(1.0), T(0.0)) +
                     M::pick(p > film->pressure[1], T(1.0), T(0.0)) +
                     M::pick(c < film->range_transit[0], T(1.0), T(0.0)) +
                     M::pick(c > film->range_transit[1], T(1.0), T(0.0));
    out.outside = M::pick(asked > 0.0, beyond, T(0.0));
    out.ceiling = film->stress_p + kFourOverPi * film->stress / p;
    const auto transit = film->log_transit.at(c);
    const auto corner_transit = film->corner_log_transit.at(c);
    const auto pressure = film->root_pressure.at(root);
    const auto corner_pressure = film->corner_root_pressure.at(root);
    const int slips = film->log_rate.knots, size = film->root_pressure.knots * slips,
              corners = film->corner_root_pressure.knots;
    const T sheets =
        transit.cell * static_cast<double>(size) + pressure.cell * static_cast<double>(slips);
    double first[Lanes::kCount];
    Lanes::put(sheets, first);
    for (int l = 0; l < Lanes::kCount; ++l)
      out.sheet[l] = film->saturation + static_cast<int>(first[l]);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        Lanes::put(transit.weight[i] * pressure.weight[j], out.weight[4 * i + j]);
    const T place_of_corner =
        corner_transit.cell * static_cast<double>(corners) + corner_pressure.cell;
    out.log_corner = place.log_thickness;
    for (int i = 0; i < 4; ++i) {
      T sum = 0.0;
      for (int j = 0; j < 4; ++j)
        sum += corner_pressure.weight[j] *
               Lanes::gather(film->corner + i * corners + j, place_of_corner);
      out.log_corner += corner_transit.weight[i] * sum;
    }
    return out;
  }

  template <class T>
  struct Here {
    Place<T> place;
    [[gnu::always_inline]] Row<T> row(const T& peak) const { return make_strip_row(place, peak); }
    [[gnu::always_inline]] auto single() const requires kHasSingle<T> {
      using To = SinglePrecisionOf<T>;
      return Here<typename To::Type>{
          {place.film, To::both(place.log_thickness), To::both(place.log_transit),
           To::both(place.width_over_pressure), To::both(place.speed), To::both(place.wanted)}};
    }
    /// N slips on P strips of these peak pressures (film_law_of.hpp), slip i on strip i % P.
    template <int N, int P>
    [[gnu::always_inline]] void several(const T* slip, const T* peak, T* kappa) const {
      for (int k = 0; k < P; ++k) {
        const Row<T> strip = make_strip_row(place, peak[k]);
        for (int i = k; i < N; i += P) kappa[i] = strip(slip[i]);
      }
    }
    /// The same in single precision, from the tiles; false where they do not reach. Walls without
    /// flash.
    template <int N, int P>
    [[gnu::always_inline]] bool try_several(const T* slip, const T* peak, T* kappa) const {
      using M = ScalarMath<T>;
      using Tiles = ScalarTiles<T>;
      constexpr double kFourOverPi = 1.2732395447351628;
      const ViscoElasticFilm* film = place.film;
      const T& c = place.log_transit;
      const T transit_beyond = M::pick(c < film->range_transit[0], T(1.0), T(0.0)) +
                               M::pick(c > film->range_transit[1], T(1.0), T(0.0));
      const auto transit = film->log_transit.cell(c);
      const auto corner_transit = film->corner_log_transit.cell(c);
      T weight[4];
      SplineAxis::weights(transit.inside, weight);
      const double transits = film->log_transit.knots, line = (film->log_rate.knots - 3) * transits,
                   corners = film->corner_root_pressure.knots - 3;
#pragma GCC unroll 2
      for (int k = 0; k < P; ++k) {
        const T p = M::max(peak[k], T(1.0));
        const T asked = M::pick(peak[k] > 1.0, place.wanted, T(0.0));
        const T beyond = transit_beyond + M::pick(p < film->pressure[0], T(1.0), T(0.0)) +
                         M::pick(p > film->pressure[1], T(1.0), T(0.0));
        if (M::any(M::pick(asked > 0.0, beyond, T(0.0)) > 0.5)) return false;
        const T root = p * M::inverse_sqrt(p);
        const auto pressure = film->root_pressure.cell(root);
        const auto corner_pressure = film->corner_root_pressure.cell(root);
        const T log_corner =
            place.log_thickness + Tiles::at(film->corner_tiles,
                                            corner_transit.cell * corners + corner_pressure.cell,
                                            corner_transit.inside, corner_pressure.inside);
        const T ceiling = film->stress_p + kFourOverPi * film->stress / p;
        const T first = pressure.cell * line + transit.cell;
#pragma GCC unroll 4
        for (int i = k; i < N; i += P) {
          const T w = ScalarLog<T>::log(M::max(slip[i], T(1e-30))) - log_corner;
          const auto rate = film->log_rate.cell(w);
          const T value = Tiles::weighted_mean_at(film->tiles, rate.cell * transits + first,
                                                  pressure.inside, rate.inside, weight);
          kappa[i] = ceiling * M::exp(value + M::min(w - film->log_rate.from, T(0.0)));
        }
      }
      return true;
    }
    /// @param peak pressure of the strip
    [[gnu::always_inline]] T operator()(const T& slip, const T& peak) const {
      return row(peak)(slip);
    }
    /// Share of the film in the traction, for what is not read at all.
    [[gnu::always_inline]] void wanted(const T& share) { place.wanted = share; }
  };

  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>& c, const T& thickness) const {
    using M = ScalarMath<T>;
    using Log = ScalarLog<T>;
    Here<T> out;
    out.place.film = this;
    out.place.speed = M::max(M::abs(c.entrainment), T(1e-12));
    out.place.width_over_pressure = c.half_minor / M::max(c.peak_pressure, T(1.0));
    out.place.log_transit =
        Log::log(M::max(out.place.width_over_pressure / out.place.speed, T(1e-30)));
    out.place.log_thickness = Log::log(thickness);
    out.place.wanted = 1.0;
    return out;
  }
};

}  // namespace adore::tribology
