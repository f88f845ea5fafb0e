#include "tribology/film_law.hpp"

#include "base/errors.hpp"
#include "tribology/dry_inlet.hpp"
#include "tribology/pressure_fits.hpp"
#include "tribology/thinning_surface.hpp"
#include "tribology/visco_elastic_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace adore::tribology {
namespace {

constexpr double kLeastBeta = 1e-9;       // 1/K: no heating to speak of
constexpr double kLargestPressure = 6e9;  // Pa, beyond any bearing
constexpr double kFitError = 1e-4;        // of ln μ and ln of the heating

/// ln of c G^m (μ0/E')^s.
double log_constant(const FilmRegression& f, double viscosity, double alpha, double modulus) {
  return std::log(f.coefficient) + f.material * std::log(std::max(alpha * modulus, 1e-30)) +
         f.speed * std::log(viscosity / modulus);
}

constexpr double kAnyPressure = 1e30;  // Pa: fits end where an oil is a glass

/// Largest pressure at which S = heating slip e^(½ α* p) and its square are floats, at 1e5 m/s.
double single_until(const HeatedFilm& film) {
  constexpr double kLogMost = 41.4, kLogSlip = 11.5;  // of 1e18 and of that slip
  const double room = kLogMost - kLogSlip - std::log(film.heating);
  return film.half_alpha > 0.0 ? room / film.half_alpha : kAnyPressure;
}

/// Fits that both films with measured viscosity take.
struct MeasuredFits {
  PressurePolynomial log_viscosity, log_heating;
};
MeasuredFits measured_fits(const Lubricant& oil, double T) {
  const auto log_viscosity = [&](double p) { return std::log(oil.viscosity_under_pressure(p, T)); };
  const double K = oil.conductivity.at(T);
  const auto log_heating = [&](double p) {
    return 0.5 * (std::log(std::max(oil.beta_under_pressure(p, T), kLeastBeta) / (8.0 * K)) +
                  log_viscosity(p));
  };
  // Equilibria make a law for each place of each contact, at few temperatures: the last fits.
  using Key = std::array<double, 5>;
  struct Last {
    Key key{};
    MeasuredFits fits;
  };
  thread_local std::array<Last, 4> last;
  thread_local std::size_t next = 0;
  constexpr double kProbe = 1e9;
  const Key key{T, log_viscosity(0.0), log_viscosity(kProbe), log_heating(0.0),
                log_heating(kProbe)};
  for (const Last& one : last)
    if (one.key == key) return one.fits;
  const double end =
      pressure_at_viscosity(log_viscosity, kLogGlassViscosity - 0.6, kLargestPressure);
  Last& now = last[next++ % last.size()];
  now = {key,
         {fit_over_pressure(log_viscosity, end, kFitError).fit,
          fit_over_pressure(log_heating, end, kFitError).fit}};
  return now.fits;
}

}  // namespace

ContactFilmModel contact_film_model(const Lubricant& oil, const bearing::Lubrication& lubrication,
                                    const RaceFilmInputs& s) {
  const double T = s.wall_temperature, mu = oil.base_viscosity(T), alpha = oil.base_alpha(T);
  ContactFilmModel out;
  out.line = s.line;
  out.log_central = log_constant(s.line ? kLineCentral : kPointCentral, mu, alpha, s.modulus);
  out.log_minimum = log_constant(s.line ? kLineMinimum : kPointMinimum, mu, alpha, s.modulus);
  out.inverse_modulus = 1.0 / s.modulus;
  out.curvature = 1.0 / s.radius;
  constexpr double kLeastShare = 1e-6, kLeastSpeed = 1e-9;  // of the race speed [choice]; m/s
  const double least = std::max(kLeastShare * std::abs(s.race_speed), kLeastSpeed);
  out.least_speed2 = least * least;
  out.log_heating = std::log(std::max(mu * oil.base_beta(T) / oil.conductivity.at(T), 1e-30));
  out.meniscus = std::max(lubrication.meniscus, kDryMeniscus);
  out.log_meniscus = std::log(out.meniscus);
  out.critical = std::max(lubrication.critical_film, kThinnestFilm);
  return out;
}

RollingResistance rolling_resistance(const Lubricant& oil, const bearing::Lubrication& lubrication,
                                     const RaceFilmInputs& s) {
  RollingResistance out;
  out.film = contact_film_model(oil, lubrication, s);
  out.log_speed = std::log(oil.base_viscosity(s.wall_temperature) / s.modulus);
  out.log_material = std::log(std::max(oil.base_alpha(s.wall_temperature) * s.modulus, 1e-30));
  out.modulus = s.modulus;
  out.single = s.single;
  return out;
}

HeatedFilm heated_film(const Lubricant& oil, double T) {
  HeatedFilm out;
  out.viscosity = oil.viscosity_under_pressure(0.0, T);
  out.half_alpha = 0.5 * oil.traction_alpha;
  out.heating = std::sqrt(std::max(oil.beta_under_pressure(0.0, T), kLeastBeta) * out.viscosity /
                          (8.0 * oil.conductivity.at(T)));
  out.limit = TractionLimiter::at(oil.limiting_ratio(T));
  return out;
}

MeasuredViscosityFilm measured_viscosity_film(const Lubricant& oil, double T) {
  const MeasuredFits fits = measured_fits(oil, T);
  MeasuredViscosityFilm out;
  out.log_viscosity = fits.log_viscosity;
  out.log_heating = fits.log_heating;
  out.limit = TractionLimiter::at(oil.limiting_ratio(T));
  return out;
}

ShearThinningFriction shear_thinning_friction(const Lubricant& oil, double T) {
  demand(oil.carreau_a == 2.0, "the exponent a of the shear-thinning law must be 2");
  const MeasuredFits fits = measured_fits(oil, T);
  return {fits.log_viscosity, fits.log_heating, oil.carreau_G * T / oil.carreau_TR,
          0.5 * (oil.carreau_n - 1.0), TractionLimiter::at(oil.limiting_ratio(T))};
}

TractionLaw film_law(const bearing::TractionCurve& metal, const Lubricant& oil,
                     const bearing::Lubrication& lubrication, const RaceFilmInputs& s) {
  const ContactFilmModel film = contact_film_model(oil, lubrication, s);
  switch (oil.model) {
    case LubricantModel::NewtonianThermal: {
      HeatedFilm fluid = heated_film(oil, s.wall_temperature);
      if (s.single) fluid.single_until = single_until(fluid);
      return {metal, film, fluid};
    }
    case LubricantModel::NewtonianGeneral: {
      MeasuredViscosityFilm fluid = measured_viscosity_film(oil, s.wall_temperature);
      if (s.single) fluid.single_until = kAnyPressure;
      return {metal, film, fluid};
    }
    case LubricantModel::ShearThinning: {
      ShearThinningFriction fluid = shear_thinning_friction(oil, s.wall_temperature);
      if (lubrication.direct_strips) return {metal, film, fluid};
      const ThinningSurface surface =
          thinning_surface(fluid.half_power, target_thinning_error(lubrication.tolerance));
      surface.give(fluid);
      if (s.single) fluid.single_until = kAnyPressure;
      return {metal, film, fluid, surface.table};
    }
    case LubricantModel::ViscoElastic:
      break;
  }
  constexpr double kLeastRaceSpeed = 0.1;  // m/s, for the range of a bearing at rest
  const double T = s.wall_temperature, speed = std::max(s.race_speed, kLeastRaceSpeed);
  ViscoElasticSurface surface;
  if (lubrication.direct_strips) {
    surface.film = direct_visco_elastic_film(oil, T);
  } else {
    surface = visco_elastic_surface(oil, T, s.width_over_pressure, speed,
                                    target_surface_error(lubrication.tolerance));
  }
  if (s.single && !lubrication.direct_strips && !lubrication.hot_walls)
    surface.film.single_until = kSurfacePressure[1];
  if (lubrication.hot_walls) set_wall_heating(surface.film, oil, T, s.walls);
  return {metal, film, surface.film, surface.table};
}

std::string describe_film_evaluation(const Lubricant& oil, const bearing::Lubrication& lubrication,
                                     const RaceFilmInputs& s) {
  const std::string floats = s.single ? "the film is computed in single precision with a relative "
                                        "error of traction of 3e-5 (run option filmPrecision)"
                                      : "";
  if (oil.model == LubricantModel::ShearThinning) {
    if (lubrication.direct_strips) return "the shear stress is computed at each integration point";
    const ThinningSurface at =
        thinning_surface(0.5 * (oil.carreau_n - 1.0), target_thinning_error(lubrication.tolerance));
    return floats + (floats.empty() ? "" : "; ") +
           fmt::format(
               "the shear stress is interpolated in a table of {} x {} values (shear rate and "
               "heating). The error is {:.2g} % at most and {:.2g} % rms at {} check points. The "
               "tolerance of the run allows {:.2g} % at most{}",
               at.size[0], at.size[1], 100.0 * at.error[0], 100.0 * at.error[1], at.held_out,
               100.0 * at.wanted,
               at.error[0] > at.wanted ? ". The finest table exceeds the allowed error" : "");
  }
  if (oil.model != LubricantModel::ViscoElastic) return floats;
  if (lubrication.direct_strips) return "the shear stress is integrated along each strip";
  constexpr double kLeastRaceSpeed = 0.1;
  const ViscoElasticSurface at = visco_elastic_surface(
      oil, s.wall_temperature, s.width_over_pressure, std::max(s.race_speed, kLeastRaceSpeed),
      target_surface_error(lubrication.tolerance));
  return (floats.empty() || lubrication.hot_walls ? std::string() : floats + "; ") +
         fmt::format(
             "the shear stress along each strip is interpolated in a table of {} x {} x {} values "
             "(pressure to {:g} GPa, slip, transit speed from {:.3g} to {:.3g} m/s) and integrated "
             "directly outside the table. The error is {:.2g} % rms and {:.2g} % at most at {} "
             "check points. The tolerance of the run allows {:.2g} % rms and {:.2g} % at most{}",
             at.size[1], at.size[2], at.size[0], 1e-9 * kSurfacePressure[1], at.speed[0],
             at.speed[1], 100.0 * at.error[1], 100.0 * at.error[0], at.held_out, 100.0 * at.wanted,
             100.0 * kLargestOverMean * at.wanted,
             at.error[1] > at.wanted || at.error[0] > kLargestOverMean * at.wanted
                 ? ". The finest table exceeds the allowed error"
                 : "");
}

}  // namespace adore::tribology
