#include "tribology/shear_thinning_film.hpp"

#include "tribology/newton_film.hpp"

#include <cmath>

namespace adore::tribology {
namespace {

/// ln(1 + x^a) without overflow, from ln x.
double log_one_plus_power(double log_x, double a) {
  const double e = a * log_x;
  return e > 0.0 ? e + std::log1p(std::exp(-e)) : std::log1p(std::exp(e));
}

/// ln y of ((n-1)/a) ln(1 + (y/G)^a) + ln y = ln τ. The left side rises in ln y with a slope
/// between n and 1 and is concave: Newton from the linear start does not pass the root.
double log_newtonian(const ShearThinningFilm& f, double log_stress) {
  const double log_G = std::log(f.modulus);
  double log_y = log_stress;
  constexpr int kSteps = 60;
  for (int i = 0; i < kSteps; ++i) {
    const double power = log_one_plus_power(log_y - log_G, f.a);
    const double miss = (f.n - 1.0) / f.a * power + log_y - log_stress;
    const double share = std::exp(f.a * (log_y - log_G) - power);
    const double step = miss / (1.0 + (f.n - 1.0) * share);
    log_y -= step;
    if (std::abs(step) < 1e-14 * (1.0 + std::abs(log_y))) break;
  }
  return log_y;
}

}  // namespace

ShearThinningStress shear_thinning_stress(const ShearThinningFilm& film, double slip) {
  ShearThinningStress out;
  if (!(slip > 0.0)) return out;
  const double log_y0 = std::log(film.viscosity) + std::log(slip) - std::log(film.thickness);
  const double log_iso = log_y0 + (film.n - 1.0) / film.a *
                                      log_one_plus_power(log_y0 - std::log(film.modulus), film.a);
  out.isothermal = std::exp(log_iso);
  // ln τ - ln N(η*(τ)) rises with τ: bisection below the isothermal stress.
  const auto newtonian = [&](double log_stress) {
    const double effective =
        film.viscosity * std::exp(log_stress - log_newtonian(film, log_stress));
    return NewtonFilm{film.thickness, effective, 0.0, film.beta, film.conductivity};
  };
  double high = log_iso, low = log_iso;
  constexpr int kSteps = 200;
  double width = 1.0;
  for (int i = 0; i < kSteps; ++i, width *= 2.0) {
    low = high - width;
    if (std::exp(low) <= film_shear_stress(newtonian(low), slip, 0.0)) break;
  }
  for (int i = 0; i < kSteps && high - low > 1e-13; ++i) {
    const double middle = 0.5 * (low + high);
    const bool above = std::exp(middle) > film_shear_stress(newtonian(middle), slip, 0.0);
    (above ? high : low) = middle;
  }
  const double log_stress = 0.5 * (low + high);
  out.thermal = film.beta > 0.0 ? std::exp(log_stress) : out.isothermal;
  if (film.beta > 0.0)
    out.hottest = std::log1p(slip * slip * film.beta * newtonian(log_stress).viscosity /
                             (8.0 * film.conductivity)) /
                  film.beta;
  return out;
}

}  // namespace adore::tribology
