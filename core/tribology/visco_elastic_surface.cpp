#include "tribology/visco_elastic_surface.hpp"

#include "base/errors.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/viscoelastic_strip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace adore::tribology {
namespace {

constexpr double kSofteningReference = 313.15;
constexpr int kCells = 60;                                 ///< with Richardson
constexpr double kLeastSpeed = 3e-3, kLargestSpeed = 2.0;  // of the race speed
constexpr double kLeastSlip = -6.0, kLargestSlip = 26.0;   // w

ViscoElasticStrip strip_of(const Lubricant& oil, double T, double peak, double transit) {
  const double soft = std::exp(-oil.softening * (T - kSofteningReference));
  ViscoElasticStrip s;
  s.sinh_law = oil.sinh_law;
  s.half_length = 1.0;
  s.peak_pressure = peak;
  s.thickness = 1.0;  // so that slip is the rate of shear
  s.speed = 1.0 / transit;
  s.viscosity = oil.base_viscosity(T);
  s.alpha = oil.base_alpha(T);
  s.modulus = oil.modulus * soft;
  s.modulus_p = oil.modulus_p * soft;
  s.stress = oil.stress * soft;
  s.stress_p = oil.stress_p * soft;
  return s;
}

/// Limit of κ: ∫τ0 dx/∫p dx.
double ceiling_of(const ViscoElasticStrip& s) {
  return s.stress_p + 4.0 / std::numbers::pi * s.stress / s.peak_pressure;
}

/// Coefficients of the spline through values at from, from + step ..., its third derivative
/// continuous at the second place from each end (quadratic ends: c = 3 c' - 3 c'' + c''').
void to_spline(std::vector<double>& v, std::size_t first, std::size_t stride, std::size_t n) {
  // (c[k-1] + 4 c[k] + c[k+1])/6 = v[k]. With such ends the equations of the first and last value
  // become v[0] = (6 c1 - 2 ... )/6; the ends are found from their neighbours instead: unknown
  // second differences d[k] = c[k-1] - 2 c[k] + c[k+1], c[k] = v[k] - d[k]/6, d[0] = 2 d[1] - d[2].
  std::vector<double> value(n), d(n, 0.0), upper(n, 0.0), right(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) value[k] = v[first + (k + 1) * stride];
  // d[k-1] + 4 d[k] + d[k+1] = 6 (v[k-1] - 2 v[k] + v[k+1]), 0 < k < n - 1.
  for (std::size_t k = 1; k + 1 < n; ++k) {
    double below = 1.0, middle = 4.0, above = 1.0;
    if (k == 1) middle = 6.0, above = 0.0, below = 0.0;
    if (k + 2 == n) middle = 6.0, below = 0.0, above = 0.0;
    const double b = 6.0 * (value[k - 1] - 2.0 * value[k] + value[k + 1]);
    const double pivot = middle - below * upper[k - 1];
    upper[k] = above / pivot;
    right[k] = (b - below * right[k - 1]) / pivot;
  }
  for (std::size_t k = n - 2; k >= 1; --k)
    d[k] = right[k] - upper[k] * (k + 2 < n ? d[k + 1] : 0.0);
  d[0] = 2.0 * d[1] - d[2];
  d[n - 1] = 2.0 * d[n - 2] - d[n - 3];
  std::vector<double> c(n + 2, 0.0);
  for (std::size_t k = 0; k < n; ++k) c[k + 1] = value[k] - d[k] / 6.0;
  c[0] = d[0] + 2.0 * c[1] - c[2];
  c[n + 1] = d[n - 1] + 2.0 * c[n] - c[n - 1];
  for (std::size_t k = 0; k < n + 2; ++k) v[first + k * stride] = c[k];
}

struct Sizes {  // values, of the spline one more at each end
  std::size_t transits, pressures, slips, corner_transits, corner_pressures;
};

SplineAxis axis(double from, double to, std::size_t values) {
  return {static_cast<int>(values) + 2, from, static_cast<double>(values - 1) / (to - from)};
}
double place(const SplineAxis& a, std::size_t k, double beyond = 0.0) {
  return a.from + (static_cast<double>(k) + beyond) / a.inverse_step;
}

class Builder {
 public:
  Builder(const Lubricant& oil, double T, double width_over_pressure, double race_speed)
      : oil_(oil),
        T_(T),
        from_(std::log(width_over_pressure / (kLargestSpeed * race_speed))),
        to_(std::log(width_over_pressure / (kLeastSpeed * race_speed))) {}

  ViscoElasticSurface make(const Sizes& n) {
    ViscoElasticSurface out;
    ViscoElasticFilm& f = out.film;
    const double low = std::sqrt(kSurfacePressure[0]), high = std::sqrt(kSurfacePressure[1]);
    f.root_pressure = axis(low, high, n.pressures);
    f.corner_root_pressure = axis(low, high, n.corner_pressures);
    f.log_rate = axis(kLeastSlip, kLargestSlip, n.slips);
    f.log_transit = axis(from_, to_, n.transits);
    f.corner_log_transit = axis(from_, to_, n.corner_transits);
    const ViscoElasticStrip any = strip_of(oil_, T_, 1e9, 1.0);
    f.stress = any.stress, f.stress_p = any.stress_p;
    const std::size_t slips = n.slips + 2, sheet = (n.pressures + 2) * slips,
                      saturation = (n.transits + 2) * sheet, corners = n.corner_pressures + 2;
    auto table =
        std::make_shared<std::vector<double>>(saturation + (n.corner_transits + 2) * corners);
    std::vector<double>& v = *table;
    for (std::size_t i = 0; i < n.corner_transits; ++i)
      for (std::size_t j = 0; j < n.corner_pressures; ++j)
        v[saturation + (i + 1) * corners + j + 1] = std::log(
            corner_of(at(place(f.corner_log_transit, i), place(f.corner_root_pressure, j))));
    for (std::size_t i = 0; i < n.corner_transits; ++i)
      to_spline(v, saturation + (i + 1) * corners, 1, n.corner_pressures);
    for (std::size_t j = 0; j < corners; ++j)
      to_spline(v, saturation + j, corners, n.corner_transits);
    for (std::size_t i = 0; i < n.transits; ++i)
      for (std::size_t j = 0; j < n.pressures; ++j) {
        const ViscoElasticStrip s = at(place(f.log_transit, i), place(f.root_pressure, j));
        const double corner = corner_of(s);
        for (std::size_t k = 0; k < n.slips; ++k)
          v[(i + 1) * sheet + (j + 1) * slips + k + 1] =
              log_kappa(s, std::exp(place(f.log_rate, k)) * corner) - std::log(ceiling_of(s));
      }
    for (std::size_t i = 0; i < n.transits; ++i)
      for (std::size_t j = 0; j < n.pressures; ++j)
        to_spline(v, (i + 1) * sheet + (j + 1) * slips, 1, n.slips);
    for (std::size_t i = 0; i < n.transits; ++i)
      for (std::size_t k = 0; k < slips; ++k) to_spline(v, (i + 1) * sheet + k, slips, n.pressures);
    for (std::size_t k = 0; k < sheet; ++k) to_spline(v, k, sheet, n.transits);
    f.saturation = v.data();
    f.corner = v.data() + saturation;
    out.table = std::move(table);
    return out;
  }

  /// Relative errors of κ in the middles of the cells: the largest, and the root of the mean
  /// square.
  std::array<double, 2> error(const ViscoElasticFilm& film, const Sizes& n) {
    double largest = 0.0, squares = 0.0;
    int count = 0;
    for (std::size_t i = 0; i + 1 < n.transits; ++i)
      for (std::size_t j = 0; j + 1 < n.pressures; ++j) {
        const ViscoElasticStrip s =
            at(place(film.log_transit, i, 0.5), place(film.root_pressure, j, 0.5));
        // A contact with that transit over its pressure, film 1 m, so that slip is γ.
        ContactPoint<double> contact;
        contact.peak_pressure = s.peak_pressure;
        contact.half_minor = 1.0;
        contact.entrainment = s.speed;
        const auto row = film.at(contact, 1.0).row(s.peak_pressure);
        for (std::size_t k = 0; k + 1 < n.slips; ++k) {
          const double rate = std::exp(place(film.log_rate, k, 0.5) + row.log_corner);
          const double miss = std::log(row(rate)) - log_kappa(s, rate);
          largest = std::max(largest, std::abs(miss));
          squares += miss * miss;
          ++count;
        }
      }
    return {largest, std::sqrt(squares / count)};
  }
  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  [[nodiscard]] ViscoElasticStrip at(double log_transit, double root_pressure) const {
    const double peak = root_pressure * root_pressure;
    return strip_of(oil_, T_, peak, std::exp(log_transit) * peak);
  }
  double log_kappa(const ViscoElasticStrip& s, double rate) {
    ++evaluations_;
    return std::log(strip_coefficient(s, rate, kCells, true));
  }
  /// Rate at which κ would reach its limit along its first slope.
  double corner_of(const ViscoElasticStrip& s) {
    // No stress of the strip exceeds 2 G b/u γ.
    const double small = 1e-4 * s.stress / (2.0 * (s.modulus + s.modulus_p * s.peak_pressure)) *
                         s.speed / s.half_length;
    return ceiling_of(s) * small / std::exp(log_kappa(s, small));
  }

  const Lubricant& oil_;
  double T_, from_, to_;  ///< of ln c
  int evaluations_ = 0;
};

}  // namespace

ViscoElasticSurface visco_elastic_surface(const Lubricant& oil, double temperature,
                                          double width_over_pressure, double race_speed,
                                          double wanted) {
  demand(oil.model == LubricantModel::ViscoElastic, "a visco-elastic lubricant");
  demand(width_over_pressure > 0.0 && race_speed > 0.0, "a contact that rolls");
  Builder builder(oil, temperature, width_over_pressure, race_speed);
  ViscoElasticSurface out;
  for (const Sizes& n : {Sizes{5, 20, 26, 16, 120}, Sizes{8, 32, 40, 24, 180}}) {
    out = builder.make(n);
    out.error = builder.error(out.film, n);
    if (out.error[1] <= wanted) break;
  }
  out.evaluations = builder.evaluations();
  out.speed[0] = kLeastSpeed * race_speed;
  out.speed[1] = kLargestSpeed * race_speed;
  // The corner of a strip at 1 GPa and half the race's speed, under a usual film.
  ContactPoint<double> usual;
  usual.peak_pressure = 1e9;
  usual.half_minor = width_over_pressure * usual.peak_pressure;
  usual.entrainment = 0.5 * race_speed;
  constexpr double kFilm = 3e-7;
  out.film.start_slip = std::max(
      std::exp(out.film.at(usual, kFilm).row(usual.peak_pressure).log_corner), kRegularisationSlip);
  return out;
}

double visco_elastic_strip(const Lubricant& oil, double temperature, double peak, double shear_rate,
                           double transit) {
  const ViscoElasticStrip s = strip_of(oil, temperature, peak, transit);
  return strip_coefficient(s, shear_rate, kCells, true);
}

}  // namespace adore::tribology
