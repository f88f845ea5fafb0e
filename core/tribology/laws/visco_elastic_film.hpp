#pragma once

#include "base/scalar_lanes.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"
#include "tribology/laws/contact_point.hpp"

namespace adore::tribology {

/// Uniform cubic B-splines over one variable: `knots` coefficients whose middles stand at from,
/// from + step ... less one at each end. Four of them are not 0 at a place; outside the edge holds.
struct SplineAxis {
  int knots = 4;
  double from = 0.0, inverse_step = 1.0;

  template <class T>
  struct Place {
    T cell;       ///< first of the four coefficients, a whole number
    T weight[4];  ///< sum to 1
  };
  template <class T>
  [[gnu::always_inline]] Place<T> at(const T& x) const {
    using M = ScalarMath<T>;
    const T last = static_cast<double>(knots - 3);  // cells
    const T s = M::min(M::max((x - from) * inverse_step, T(0.0)), last);
    const T cell = ScalarLanes<T>::floor(M::min(s, last - 1e-9)), f = s - cell, g = 1.0 - f;
    const T f2 = f * f, g2 = g * g;
    const T outer = g2 * g * (1.0 / 6.0), far = f2 * f * (1.0 / 6.0);
    const T near = 2.0 / 3.0 - f2 * (1.0 - 0.5 * f);
    return {cell, {outer, near, 1.0 - outer - near - far, far}};
  }
};

/// Traction of a visco-elastic film (kTrac 8, 12): the stress integrated along each strip of
/// rolling (viscoelastic_strip.hpp), at one temperature, read from a surface that is made at set-up
/// (visco_elastic_surface.hpp, which measures its error). SI.
///
/// With ξ = x/b the strip's equation is dτ/dξ = (G b/u)(γ - (τ0/μ) F(τ/τ0)): its mean stress
/// depends on its peak pressure p, on γ = slip/h and on b/u, which is c p with c = b/(u p0) the
/// same for all strips of a contact. With κ_s the stress limit over the pressure and γ_r(p, c) the
/// rate at which κ would reach it along its slope at no slip, both cubic splines over √p and ln c,
///   κ = κ_s exp S(w, p, c),  w = ln(γ/γ_r),
/// S a cubic spline. Below the least w κ is linear in γ (S = w); above the largest, where the
/// stress is at its limit, and beyond the ends of p and c the edge holds.
struct ViscoElasticFilm {
  const double* saturation = nullptr;   ///< S: [transit][pressure][slip]
  const double* corner = nullptr;       ///< ln γ_r: [transit][pressure], axes of its own
  double stress = 0.0, stress_p = 0.0;  ///< κ_s = stress_p + 4/π stress/p
  SplineAxis root_pressure, log_rate, log_transit, corner_root_pressure, corner_log_transit;
  double start_slip = 0.0;

  static constexpr bool kOfStrip = true;

  using Four = double __attribute__((vector_size(4 * sizeof(double))));
  [[gnu::always_inline]] static void add(double weight, const double* four, Four& sum) {
    Four one;
    __builtin_memcpy(&one, four, sizeof one);
    sum += weight * one;
  }

  template <class T>
  struct Row {
    const ViscoElasticFilm* film;
    T log_corner;                                 ///< of γ_r h
    T ceiling;                                    ///< κ_s
    const double* sheet[ScalarLanes<T>::kCount];  ///< first of the 16 lines over slip
    double weight[ScalarLanes<T>::kCount][16];

    [[gnu::always_inline]] T operator()(const T& slip) const {
      using M = ScalarMath<T>;
      using Lanes = ScalarLanes<T>;
      const T w = ScalarLog<T>::log(M::max(slip, T(1e-30))) - log_corner;
      const auto at = film->log_rate.at(w);
      const int slips = film->log_rate.knots, size = film->root_pressure.knots * slips;
      double value[Lanes::kCount];
      for (int l = 0; l < Lanes::kCount; ++l) {
        const double* lines = sheet[l] + static_cast<int>(Lanes::get(at.cell, l));
        Four sum{};
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) add(weight[l][4 * i + j], lines + i * size + j * slips, sum);
        value[l] = Lanes::get(at.weight[0], l) * sum[0] + Lanes::get(at.weight[1], l) * sum[1] +
                   Lanes::get(at.weight[2], l) * sum[2] + Lanes::get(at.weight[3], l) * sum[3];
      }
      return ceiling * M::exp(Lanes::from(value) + M::min(w - film->log_rate.from, T(0.0)));
    }
  };

  template <class T>
  struct Here {
    const ViscoElasticFilm* film;
    T log_thickness;
    SplineAxis::Place<T> transit, corner_transit;

    [[gnu::always_inline]] Row<T> row(const T& peak) const {
      using M = ScalarMath<T>;
      using Lanes = ScalarLanes<T>;
      constexpr double kFourOverPi = 1.2732395447351628;
      Row<T> out;
      out.film = film;
      const T p = M::max(peak, T(1.0)), root = M::root(p);
      out.ceiling = film->stress_p + kFourOverPi * film->stress / p;
      const auto pressure = film->root_pressure.at(root);
      const auto corner_pressure = film->corner_root_pressure.at(root);
      const int slips = film->log_rate.knots, size = film->root_pressure.knots * slips,
                corners = film->corner_root_pressure.knots;
      double log_corner[Lanes::kCount];
      for (int l = 0; l < Lanes::kCount; ++l) {
        out.sheet[l] = film->saturation + static_cast<int>(Lanes::get(transit.cell, l)) * size +
                       static_cast<int>(Lanes::get(pressure.cell, l)) * slips;
        const double* lines = film->corner +
                              static_cast<int>(Lanes::get(corner_transit.cell, l)) * corners +
                              static_cast<int>(Lanes::get(corner_pressure.cell, l));
        Four sum{};
        for (int i = 0; i < 4; ++i) {
          add(Lanes::get(corner_transit.weight[i], l), lines + i * corners, sum);
          for (int j = 0; j < 4; ++j)
            out.weight[l][4 * i + j] =
                Lanes::get(transit.weight[i], l) * Lanes::get(pressure.weight[j], l);
        }
        log_corner[l] = 0.0;
        for (int j = 0; j < 4; ++j)
          log_corner[l] += Lanes::get(corner_pressure.weight[j], l) * sum[j];
      }
      out.log_corner = Lanes::from(log_corner) + log_thickness;
      return out;
    }
    /// @param peak pressure of the strip
    [[gnu::always_inline]] T operator()(const T& slip, const T& peak) const {
      return row(peak)(slip);
    }
  };

  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactPoint<T>& c, const T& thickness) const {
    using M = ScalarMath<T>;
    using Log = ScalarLog<T>;
    const T speed = M::max(M::abs(c.entrainment), T(1e-12));
    const T transit =
        Log::log(M::max(c.half_minor / (speed * M::max(c.peak_pressure, T(1.0))), T(1e-30)));
    return {this, Log::log(thickness), log_transit.at(transit), corner_log_transit.at(transit)};
  }
  [[nodiscard]] double start() const { return start_slip; }
};

}  // namespace adore::tribology
