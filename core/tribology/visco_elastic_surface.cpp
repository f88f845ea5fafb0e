#include "tribology/visco_elastic_surface.hpp"

#include "base/errors.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/spline_axes.hpp"
#include "tribology/viscoelastic_strip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <numbers>

namespace adore::tribology {
namespace {

constexpr double kSofteningReference = 313.15;
constexpr int kCells = 60;                                 ///< with Richardson
constexpr double kLeastSpeed = 3e-3, kLargestSpeed = 2.0;  // of the race speed
constexpr double kLeastSlip = -6.0, kLargestSlip = 26.0;   // w
constexpr double kBin = 2.0;                               // of ln c, to which ranges are widened

ViscoElasticLiquid liquid_of(const Lubricant& oil, double T) {
  const double soft = std::exp(-oil.softening * (T - kSofteningReference));
  return {oil.sinh_law,         oil.base_viscosity(T), oil.base_alpha(T),  oil.modulus * soft,
          oil.modulus_p * soft, oil.stress * soft,     oil.stress_p * soft};
}

ViscoElasticStrip strip_of(const ViscoElasticLiquid& liquid, double peak, double transit) {
  ViscoElasticStrip s;
  s.sinh_law = liquid.sinh_law;
  s.half_length = 1.0;
  s.peak_pressure = peak;
  s.thickness = 1.0;  // so that slip is the rate of shear
  s.speed = 1.0 / transit;
  s.viscosity = liquid.viscosity;
  s.alpha = liquid.alpha;
  s.modulus = liquid.modulus;
  s.modulus_p = liquid.modulus_p;
  s.stress = liquid.stress;
  s.stress_p = liquid.stress_p;
  return s;
}

double integral(const ViscoElasticLiquid& liquid, double peak, double shear_rate,
                double transit) noexcept {
  return strip_coefficient(strip_of(liquid, peak, transit), shear_rate, kCells, true);
}

/// Limit of κ: ∫τ0 dx/∫p dx.
double ceiling_of(const ViscoElasticStrip& s) {
  return s.stress_p + 4.0 / std::numbers::pi * s.stress / s.peak_pressure;
}

/// Rate at which κ would reach its limit along its first slope.
double corner_rate(const ViscoElasticStrip& s) {
  // No stress of the strip exceeds 2 G b/u γ.
  const double small = 1e-4 * s.stress / (2.0 * (s.modulus + s.modulus_p * s.peak_pressure)) *
                       s.speed / s.half_length;
  return ceiling_of(s) * small / strip_coefficient(s, small, kCells, true);
}

struct Sizes {  // values, of the spline one more at each end; transits for 6.5 of ln c
  std::size_t transits, pressures, slips, corner_transits, corner_pressures;
};
constexpr Sizes kLevels[] = {{5, 20, 26, 16, 120}, {8, 32, 40, 24, 180}, {11, 44, 56, 32, 240}};

/// All that a film points at.
struct Tables {
  std::vector<double> numbers;
  Tiles tiles, corner_tiles;
};

class Builder {
 public:
  /// @param from, to of ln c
  Builder(const ViscoElasticLiquid& liquid, double from, double to)
      : liquid_(liquid), from_(from), to_(to) {}

  ViscoElasticSurface make(const Sizes& n) {
    ViscoElasticSurface out;
    ViscoElasticFilm& f = out.film;
    const double low = std::sqrt(kSurfacePressure[0]), high = std::sqrt(kSurfacePressure[1]);
    f.root_pressure = spline_axis(low, high, n.pressures);
    f.corner_root_pressure = spline_axis(low, high, n.corner_pressures);
    f.log_rate = spline_axis(kLeastSlip, kLargestSlip, n.slips);
    f.log_transit = spline_axis(from_, to_, n.transits);
    f.corner_log_transit = spline_axis(from_, to_, n.corner_transits);
    f.stress = liquid_.stress, f.stress_p = liquid_.stress_p;
    f.pressure[0] = kSurfacePressure[0], f.pressure[1] = kSurfacePressure[1];
    f.range_transit[0] = from_, f.range_transit[1] = to_;
    f.liquid = liquid_;
    f.integral = integral;
    const std::size_t slips = n.slips + 2, sheet = (n.pressures + 2) * slips,
                      saturation = (n.transits + 2) * sheet, corners = n.corner_pressures + 2;
    auto tables = std::make_shared<Tables>();
    std::vector<double>& v = tables->numbers;
    v.resize(saturation + (n.corner_transits + 2) * corners);
    for (std::size_t i = 0; i < n.corner_transits; ++i)
      for (std::size_t j = 0; j < n.corner_pressures; ++j)
        v[saturation + (i + 1) * corners + j + 1] = std::log(corner_of(at(
            spline_abscissa(f.corner_log_transit, i), spline_abscissa(f.corner_root_pressure, j))));
    for (std::size_t i = 0; i < n.corner_transits; ++i)
      values_to_spline_coefficients(v, saturation + (i + 1) * corners, 1, n.corner_pressures);
    for (std::size_t j = 0; j < corners; ++j)
      values_to_spline_coefficients(v, saturation + j, corners, n.corner_transits);
    for (std::size_t i = 0; i < n.transits; ++i)
      for (std::size_t j = 0; j < n.pressures; ++j) {
        const ViscoElasticStrip s =
            at(spline_abscissa(f.log_transit, i), spline_abscissa(f.root_pressure, j));
        const double corner = corner_of(s);
        for (std::size_t k = 0; k < n.slips; ++k)
          v[(i + 1) * sheet + (j + 1) * slips + k + 1] =
              log_kappa(s, std::exp(spline_abscissa(f.log_rate, k)) * corner) -
              std::log(ceiling_of(s));
      }
    for (std::size_t i = 0; i < n.transits; ++i)
      for (std::size_t j = 0; j < n.pressures; ++j)
        values_to_spline_coefficients(v, (i + 1) * sheet + (j + 1) * slips, 1, n.slips);
    for (std::size_t i = 0; i < n.transits; ++i)
      for (std::size_t k = 0; k < slips; ++k)
        values_to_spline_coefficients(v, (i + 1) * sheet + k, slips, n.pressures);
    for (std::size_t k = 0; k < sheet; ++k) values_to_spline_coefficients(v, k, sheet, n.transits);
    f.saturation = v.data();
    f.corner = v.data() + saturation;
    tables->tiles = make_tiles(v.data(), n.pressures + 2, slips, n.transits + 2);
    tables->corner_tiles = make_tiles(f.corner, n.corner_transits + 2, corners);
    f.tiles = tables->tiles.data()->power;
    f.corner_tiles = tables->corner_tiles.data()->power;
    out.table = std::shared_ptr<const std::vector<double>>(tables, &tables->numbers);
    return out;
  }

  /// Relative errors of κ on a hold-out grid: the largest, and the root of the mean square. One
  /// place in each cell, that of Weyl's sequence with the cell's number, so that no plane of the
  /// grid is favoured.
  std::array<double, 2> error(const ViscoElasticFilm& film, const Sizes& n) {
    double largest = 0.0, squares = 0.0;
    held_out_ = 0;
    const auto weyl = [this](double irrational) {
      const double x = irrational * (held_out_ + 1);
      return x - std::floor(x);
    };
    for (std::size_t i = 0; i + 1 < n.transits; ++i)
      for (std::size_t j = 0; j + 1 < n.pressures; ++j)
        for (std::size_t k = 0; k + 1 < n.slips; ++k) {
          const ViscoElasticStrip s =
              at(spline_abscissa(film.log_transit, i, weyl(0.8191725133961645)),
                 spline_abscissa(film.root_pressure, j, weyl(0.6710436067037893)));
          // A contact with that transit over its pressure, film 1 m, so that slip is γ.
          ContactConditions<double> contact;
          contact.peak_pressure = s.peak_pressure;
          contact.half_minor = 1.0;
          contact.entrainment = s.speed;
          const auto here = film.at(contact, 1.0);
          const auto row = here.row(s.peak_pressure);
          const double rate = std::exp(spline_abscissa(film.log_rate, k, weyl(0.5497004779019703)) +
                                       row.log_corner);
          const double miss = std::log(row(rate)) - log_kappa(s, rate);
          largest = std::max(largest, std::abs(miss));
          squares += miss * miss;
          ++held_out_;
        }
    return {largest, std::sqrt(squares / held_out_)};
  }
  [[nodiscard]] int held_out() const { return held_out_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  [[nodiscard]] ViscoElasticStrip at(double log_transit, double root_pressure) const {
    const double peak = root_pressure * root_pressure;
    return strip_of(liquid_, peak, std::exp(log_transit) * peak);
  }
  double log_kappa(const ViscoElasticStrip& s, double rate) {
    ++evaluations_;
    return std::log(strip_coefficient(s, rate, kCells, true));
  }
  double corner_of(const ViscoElasticStrip& s) {
    ++evaluations_;
    return corner_rate(s);
  }

  const ViscoElasticLiquid& liquid_;
  double from_, to_;  ///< of ln c
  int evaluations_ = 0, held_out_ = 0;
};

/// Surfaces of this process: both races, the equilibrium, the plan and the run ask for the same.
std::shared_ptr<const ViscoElasticSurface> surface_of(const ViscoElasticLiquid& liquid, double from,
                                                      double to, double wanted) {
  using Key = std::array<double, 10>;
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const ViscoElasticSurface>> kept;
  constexpr std::size_t kMost = 32;  // each thermal step has a different temperature
  const Key key{liquid.sinh_law ? 1.0 : 0.0,
                liquid.viscosity,
                liquid.alpha,
                liquid.modulus,
                liquid.modulus_p,
                liquid.stress,
                liquid.stress_p,
                from,
                to,
                wanted};
  const std::lock_guard lock(mutex);
  if (const auto known = kept.find(key); known != kept.end()) return known->second;
  Builder builder(liquid, from, to);
  ViscoElasticSurface out;
  for (Sizes n : kLevels) {
    const double share = (to - from) / std::log(kLargestSpeed / kLeastSpeed);
    const auto longer = [&](std::size_t values) {
      return static_cast<std::size_t>(std::ceil(share * static_cast<double>(values)));
    };
    n.transits = longer(n.transits);
    n.corner_transits = longer(n.corner_transits);
    out = builder.make(n);
    out.size = {n.transits, n.pressures, n.slips};
    out.error = builder.error(out.film, n);
    if (out.error[1] <= wanted && out.error[0] <= kLargestOverMean * wanted) break;
  }
  out.held_out = builder.held_out();
  out.evaluations = builder.evaluations();
  if (kept.size() >= kMost) kept.clear();
  return kept[key] = std::make_shared<const ViscoElasticSurface>(std::move(out));
}

/// y(ΔT)/ΔT as 1/(c0 + c1 ΔT), through its values at 25 and 100 K.
template <class F>
void fit_fall(const F& fall, double* c) {
  constexpr double kNear = 25.0, kFar = 100.0;
  const double near = kNear / fall(kNear), far = kFar / fall(kFar);
  c[1] = (far - near) / (kFar - kNear);
  c[0] = near - c[1] * kNear;
}

}  // namespace

double target_surface_error(double tolerance) {
  return std::clamp(5.0 * std::sqrt(tolerance), 1e-3, 1e-2);
}

ViscoElasticFilm direct_visco_elastic_film(const Lubricant& oil, double temperature) {
  demand(oil.model == LubricantModel::ViscoElastic,
         "a visco-elastic film was requested for another type of lubricant");
  ViscoElasticFilm out;
  out.liquid = liquid_of(oil, temperature);
  out.integral = integral;
  out.direct = true;
  out.stress = out.liquid.stress, out.stress_p = out.liquid.stress_p;
  return out;
}

ViscoElasticSurface visco_elastic_surface(const Lubricant& oil, double temperature,
                                          double width_over_pressure, double race_speed,
                                          double wanted) {
  demand(oil.model == LubricantModel::ViscoElastic,
         "a visco-elastic film was requested for another type of lubricant");
  demand(width_over_pressure > 0.0 && race_speed > 0.0,
         "a visco-elastic film needs a rolling contact");
  const double from = std::log(width_over_pressure / (kLargestSpeed * race_speed)),
               to = std::log(width_over_pressure / (kLeastSpeed * race_speed));
  ViscoElasticSurface out = *surface_of(liquid_of(oil, temperature), kBin * std::floor(from / kBin),
                                        kBin * std::ceil(to / kBin), wanted);
  out.wanted = wanted;
  out.speed[0] = kLeastSpeed * race_speed;
  out.speed[1] = kLargestSpeed * race_speed;
  return out;
}

void set_wall_heating(ViscoElasticFilm& film, const Lubricant& oil, double temperature,
                      const std::array<FilmWall, 2>& walls) {
  if (!(walls[0].conductivity > 0.0) && !(walls[1].conductivity > 0.0))
    throw InputError(
        "iTherm = 1 (flash temperature of the surfaces) needs a thermal conductivity, but neither "
        "races nor elements have a value. Choose materials of the table, or set iTherm = 0");
  ViscoElasticFilm::WallHeating& heat = film.heating;
  heat.on = true;
  for (std::size_t i = 0; i < 2; ++i) {
    heat.conductivity[i] = walls[i].conductivity;
    heat.inverse_diffusivity[i] =
        walls[i].conductivity > 0.0 ? 0.5 * walls[i].heat_capacity / walls[i].conductivity : 0.0;
  }
  heat.softening = oil.softening;
  const double log_viscosity = std::log(oil.base_viscosity(temperature));
  fit_fall(
      [&](double rise) {
        return std::max(log_viscosity - std::log(oil.base_viscosity(temperature + rise)), 1e-9);
      },
      heat.inverse);
  const double alpha = oil.base_alpha(temperature);
  fit_fall([&](double rise) { return std::max(alpha - oil.base_alpha(temperature + rise), 1e-25); },
           heat.alpha);
}

double visco_elastic_strip_coefficient(const Lubricant& oil, double temperature, double peak,
                                       double shear_rate, double transit) {
  return integral(liquid_of(oil, temperature), peak, shear_rate, transit);
}

}  // namespace adore::tribology
