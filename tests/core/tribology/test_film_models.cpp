#include "base/errors.hpp"
#include "base/simd_inverse_roots.hpp"
#include "base/simd_single.hpp"
#include "tribology/film_law.hpp"
#include "tribology/newton_film.hpp"
#include "tribology/shear_thinning_film.hpp"
#include "tribology/traction_curve.hpp"
#include "tribology/visco_elastic_surface.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

/// The films of all lubricants as laws of traction, and what no state may do to them.
using namespace adore;
using namespace adore::tribology;

namespace {

constexpr double kModulus = 2.26e11, kRadius = 0.0051, kWidthOverPressure = 1.2e-13;
constexpr std::array kMeasured{10, 11, 13, 14, 15, 16, 17, 18, 19, 20};

Lubricant without_limit(int code) {
  Lubricant out = lubricant(code);
  out.limit = {};
  return out;
}

TractionLaw law_of(const Lubricant& oil, double T, double critical, bool line,
                   bool direct = false) {
  bearing::Lubrication lubrication;
  lubrication.code = oil.code;
  lubrication.critical_film = critical;
  lubrication.meniscus = 10.0;
  lubrication.direct_strips = direct;
  RaceFilmInputs surface;
  surface.line = line;
  surface.radius = kRadius;
  surface.modulus = kModulus;
  surface.wall_temperature = T;
  surface.race_speed = 30.0;
  surface.width_over_pressure = kWidthOverPressure;
  return film_law(traction_curve(1, {0.0, 0.12, 0.08, 0.5}), oil, lubrication, surface);
}
TractionLaw law_of(int code, double T, double critical, bool line, bool direct = false) {
  return law_of(lubricant(code), T, critical, line, direct);
}

ContactConditions<double> point(double p0, double u, double slip) {
  const double b = kWidthOverPressure * p0, a = 7.8 * b;
  return {2.0 / 3.0 * 3.14159265358979 * a * b * p0, p0, a, b, u, slip, 1.0 / kRadius};
}
ContactConditions<double> line(double p0, double u, double slip) {
  const double b = kWidthOverPressure * p0;
  return {0.5 * 3.14159265358979 * b * p0, p0, 0.0, b, u, slip, 1.0 / kRadius};
}

/// κ of a film by the formulas themselves.
double direct(const Lubricant& oil, double T, double h, double slip, double p) {
  const double mu = oil.viscosity_under_pressure(p, T), beta = oil.beta_under_pressure(p, T),
               K = oil.conductivity.at(T);
  double stress = 0.0;
  if (oil.model == LubricantModel::ShearThinning)
    stress = shear_thinning_stress(
                 {h, mu, oil.carreau_G * T / oil.carreau_TR, oil.carreau_n, oil.carreau_a, beta, K},
                 slip)
                 .thermal;
  else
    stress = film_shear_stress({h, mu, 0.0, beta, K}, slip, 0.0);
  const double kappa = stress / p;
  return kappa * std::pow(1.0 + std::pow(kappa / oil.limiting_ratio(T), 8.0), -0.125);
}

}  // namespace

TEST_CASE("films of measured viscosity: the law is the formula on a dense grid",
          "[physics][film_law]") {
  // Two Newton steps leave 7e-4 at worst; the fits over pressure 1e-4 of ln μ.
  for (const int code : kMeasured)
    for (const double T : {300.0, 350.0, 420.0}) {
      const Lubricant& oil = lubricant(code);
      const double h = 2e-7;
      double largest = 0.0, squares = 0.0;
      int count = 0;
      const auto compare = [&](const auto& here) {
        // Up to the glass, where the law holds its viscosity and heating and the formula of β
        // drops to 0.
        for (double p = 1e7; p < 4e9 && std::log(oil.viscosity_under_pressure(p, T)) < 26.9;
             p *= 1.37)
          for (double slip = 1e-5; slip < 60.0; slip *= 2.3) {
            const double miss = here(slip, p) / direct(oil, T, h, slip, p) - 1.0;
            largest = std::max(largest, std::abs(miss));
            squares += miss * miss;
            ++count;
          }
      };
      if (code == 10)
        compare(measured_viscosity_film(oil, T).at(ContactConditions<double>{}, h));
      else
        compare(shear_thinning_friction(oil, T).at(ContactConditions<double>{}, h));
      CAPTURE(code, T, largest, std::sqrt(squares / count), count);
      CHECK(count > 20);
      CHECK(largest < 2e-3);
      CHECK(std::sqrt(squares / count) < 5e-4);
    }
}

TEST_CASE("visco-elastic surface: its error is what a hold-out grid of others finds",
          "[physics][film_law]") {
  for (const int code : {8, 12})
    for (const double T : {300.0, 400.0}) {
      const Lubricant& oil = lubricant(code);
      const ViscoElasticSurface surface = visco_elastic_surface(oil, T, kWidthOverPressure, 30.0);
      CAPTURE(code, T, surface.error[0], surface.error[1], surface.evaluations);
      CHECK(surface.error[1] < kSurfaceError);
      double largest = 0.0;
      for (double p = 1.3e8; p < 4e9; p *= 2.1)
        for (const double u : {0.5, 7.0, 41.0})
          for (double slip = 1e-5; slip < 60.0; slip *= 3.1) {
            const double h = 2e-7;
            const double kappa = surface.film.at(point(p, u, slip), h)(slip, p);
            const double exact =
                visco_elastic_strip_coefficient(oil, T, p, slip / h, kWidthOverPressure * p / u);
            largest = std::max(largest, std::abs(kappa / exact - 1.0));
            // The limit: τ0 over the strip.
            CHECK(kappa > 0.0);
            CHECK(kappa < 0.3);
          }
      CAPTURE(largest);
      CHECK(largest < std::max(1.5 * surface.error[0], 0.01));
    }
}

TEST_CASE("visco-elastic surface: finer for a tighter tolerance, made once, integrated beyond it",
          "[physics][film_law]") {
  CHECK(target_surface_error(1e-6) == Approx(kSurfaceError));
  CHECK(target_surface_error(1e-9) == 1e-3);
  CHECK(target_surface_error(1e-2) == 1e-2);
  const Lubricant& oil = lubricant(12);
  constexpr double T = 350.0, h = 2e-7;
  const auto made = [&](double tolerance) {
    return visco_elastic_surface(oil, T, kWidthOverPressure, 30.0, target_surface_error(tolerance));
  };
  const ViscoElasticSurface coarse = made(1e-4), fine = made(1e-7);
  CAPTURE(coarse.error[1], coarse.evaluations, fine.error[1], fine.evaluations);
  CHECK(coarse.error[1] <= coarse.wanted);
  CHECK(fine.error[1] <= fine.wanted);
  CHECK(coarse.wanted > fine.wanted);
  CHECK(coarse.evaluations < fine.evaluations);
  CHECK(made(1e-7).table == fine.table);  // kept by the process

  const ViscoElasticFilm direct = direct_visco_elastic_film(oil, T);
  const auto exact = [&](double p, double u, double slip) {
    return visco_elastic_strip_coefficient(oil, T, p, slip / h, kWidthOverPressure * p / u);
  };
  const auto of = [&](const ViscoElasticFilm& film, double p, double u, double slip) {
    const auto here = film.at(point(p, u, slip), h);
    return here(slip, p);
  };
  // Out of the range of pressure or of speed: the integral itself, where the edge would be held.
  for (const auto& [p, u] : {std::pair{5.5e9, 20.0}, {8e3, 20.0}, {1e9, 1e-4}, {1e9, 1e4}})
    for (const double slip : {1e-4, 0.1, 10.0}) {
      CAPTURE(p, u, slip);
      CHECK(of(coarse.film, p, u, slip) == Approx(exact(p, u, slip)).epsilon(1e-9));
    }
  for (const double slip : {1e-4, 0.1, 10.0}) {
    CHECK(of(direct, 1e9, 20.0, slip) == Approx(exact(1e9, 20.0, slip)).epsilon(1e-9));
    CHECK(of(coarse.film, 1e9, 20.0, slip) ==
          Approx(exact(1e9, 20.0, slip)).epsilon(3.0 * coarse.error[0]));
  }
  // What nobody reads is not integrated: contacts of metal, and open ones.
  auto unread = direct.at(point(1e9, 20.0, 0.1), h);
  unread.wanted(0.0);
  CHECK(unread(0.1, 1e9) == 0.0);
}

// iTherm against the strip with its own temperature, found to the end.
TEST_CASE("visco-elastic film with hot walls: the flash is that of the heat that it leaves",
          "[physics][film_law]") {
  const Lubricant& oil = lubricant(12);
  constexpr double T = 350.0, h = 2e-7, k = 46.0, capacity = 7800.0 * 460.0;
  const FilmWall steel{k, capacity};
  ViscoElasticFilm cold = visco_elastic_surface(oil, T, kWidthOverPressure, 30.0, 1e-3).film,
                   hot = cold, hot_direct = direct_visco_elastic_film(oil, T);
  set_wall_heating(hot, oil, T, {steel, steel});
  set_wall_heating(hot_direct, oil, T, {steel, steel});
  double hottest = 0.0;
  for (const double p : {0.6e9, 1.2e9, 2.0e9})
    for (const double u : {5.0, 20.0, 50.0})
      for (const double slip : {1e-4, 1e-2, 0.3, 1.0, 5.0}) {
        const double b = kWidthOverPressure * p, mean = 0.25 * 3.14159265358979 * p;
        const double peclet = 0.5 * u * b * capacity / k;
        const double conductance =
            2.0 * 0.75 * k * std::sqrt(3.14159265358979 * (1.273 + peclet)) / b;
        double low = 0.0, high = 2000.0, kappa = 0.0;
        for (int i = 0; i < 60; ++i) {
          const double rise = 0.5 * (low + high);
          kappa = visco_elastic_strip_coefficient(oil, T + rise, p, slip / h,
                                                  kWidthOverPressure * p / u);
          (kappa * mean * slip / conductance > rise ? low : high) = rise;
        }
        const auto of = [&](const ViscoElasticFilm& film) {
          const auto here = film.at(point(p, u, slip), h);
          return here(slip, p);
        };
        CAPTURE(p, u, slip, low, kappa, of(cold), of(hot), of(hot_direct));
        CHECK(of(hot) <= of(cold));
        CHECK(of(hot) == Approx(kappa).epsilon(low < 150.0 ? 0.03 : 0.15));
        CHECK(of(hot) == Approx(of(hot_direct)).epsilon(0.03));
        if (slip < 1e-3) CHECK(of(hot) == Approx(of(cold)).epsilon(1e-2));
        hottest = std::max(hottest, low);
      }
  CHECK(hottest > 50.0);  // the correction matters somewhere
  CHECK_THROWS_AS(set_wall_heating(cold, oil, T, {FilmWall{}, FilmWall{}}), InputError);
}

TEST_CASE("all lubricants: no state makes a film or a traction that is no number",
          "[physics][film_law][slow]") {
  int checked = 0;
  for (const int code : lubricant_codes())
    for (const double T : {223.15, 300.0, 400.0})  // -50 C
      for (const bool lines : {false, true}) {
        const TractionLaw law = law_of(code, T, 1e-8, lines);
        const Lubricant& oil = lubricant(code);
        const double limit = oil.limiting_ratio(T);
        REQUIRE(limit > 0.0);
        const bool strip = oil.model == LubricantModel::ViscoElastic;
        // The limit of kTrac 8 and 12 is τ00 + τ0p p: over a strip, of mean pressure π p0/4, τ00
        // adds its share. Their law is read from a surface, whose largest error is below
        // 1 % (its own test; measured here: 0.8 %).
        const double own_stress = strip ? oil.stress * limit / oil.stress_p : 0.0;
        const double rounding = strip ? 0.01 : 1e-12;
        CHECK(law.is_slip_regularized());
        law.visit([&](const auto& own) {
          for (const double p0 : {1.0, 1e7, 1e9, 4e9, 6e9})
            for (const double u : {0.0, 1e-9, -20.0, 20.0, 1e3})
              for (const double slip : {0.0, 1e-12, 1e-5, 1e-2, 1.0, 40.0, 1e3}) {
                const ContactConditions<double> at = lines ? line(p0, u, slip) : point(p0, u, slip);
                const double s = std::sqrt(slip * slip + law.regularization_slip_squared());
                const double kappa = [&] {
                  const auto here = own.at(at);
                  if constexpr (kHasFilm<std::decay_t<decltype(own)>>)
                    return lines ? here.strip(p0)(s) : here(s, p0);
                  else
                    return here(s, p0);
                }();
                const LocalFilm<double> film = law.film(at);
                ++checked;
                if (!std::isfinite(kappa) || kappa < 0.0 || !std::isfinite(film.thickness) ||
                    film.thickness < 0.0 || !(film.share >= 0.0 && film.share <= 1.0)) {
                  CAPTURE(code, T, lines, p0, u, slip, kappa, film.thickness, film.share);
                  FAIL_CHECK("not a traction");
                }
                const double bound = limit + own_stress / (0.25 * 3.14159265358979 * p0);
                if (kappa > std::max(bound, 0.12) * (1.0 + rounding)) {
                  CAPTURE(code, T, lines, p0, u, slip, kappa);
                  FAIL_CHECK("beyond the limit of the law");
                }
              }
        });
      }
  CHECK(checked == 19 * 3 * 2 * 5 * 5 * 7);
}

TEST_CASE("limiting stress: single precision → the law to 3e-7, for every limit",
          "[physics][film_law]") {
  using Doubles = stdx::native_simd<double>;
  using Singles = SinglePrecisionOf<Doubles>::Type;
  // The least limit: of a user's lubricant with the largest softening of the run options.
  bearing::UserLubricant given;
  given.limit_ratio = 1e-3;
  given.limit_softening = 0.1;
  const double least = user_lubricant(given).limiting_ratio(450.0);
  CHECK(least > 0.0);
  for (const double limit : {least, 1e-3, 0.01, 0.05, 0.2}) {
    const TractionLimiter law = TractionLimiter::at(limit);
    double largest = 0.0, largest_single = 0.0;
    for (double raw = 1e-4 * limit; raw < 1e6; raw *= 1.01) {
      const double kappa = static_cast<float>(raw);
      const double exact = kappa * std::exp(-0.125 * std::log1p(std::pow(kappa / limit, 8.0)));
      const double by_doubles = law.of(Doubles(kappa))[0];
      const double by_singles = law.of(Singles(Singles::F(static_cast<float>(raw)))).v[0];
      REQUIRE(std::isfinite(by_doubles));
      REQUIRE(std::isfinite(by_singles));
      largest = std::max(largest, std::abs(by_doubles / exact - 1.0));
      largest_single = std::max(largest_single, std::abs(by_singles / exact - 1.0));
    }
    CAPTURE(limit, largest, largest_single);
    CHECK(largest < 1e-14);
    CHECK(largest_single < 3e-7);
  }
}

TEST_CASE("all lubricants: the mean over a strip is that of its points", "[physics][film_law]") {
  // A dense midpoint rule against the six points of the law.
  const auto largest_error = [](const Lubricant& oil) {
    double largest = 0.0;
    int checked = 0;
    const TractionLaw law = law_of(oil, 360.0, 0.0, true);
    law.visit([&](const auto& own) {
      if constexpr (kHasFilm<std::decay_t<decltype(own)>>) {
        if constexpr (!is_strip_law<std::decay_t<decltype(own)>>()) {
          for (const double p0 : {0.8e9, 1.5e9}) {
            const auto here = own.at(line(p0, 20.0, 0.1));
            for (const double slip : {0.01, 0.3, 3.0}) {
              double sum = 0.0;
              constexpr int kCells = 2000;
              for (int i = 0; i < kCells; ++i) {
                const double x = 2.0 * (i + 0.5) / kCells - 1.0, shape = std::sqrt(1.0 - x * x);
                sum += shape * here(slip, p0 * shape);
              }
              const double mean = sum * (2.0 / kCells) / (0.5 * 3.14159265358979);
              const double error = std::abs(here.strip(p0)(slip) / mean - 1.0);
              largest = std::max(largest, error);
              ++checked;
            }
          }
        }
      }
    });
    CHECK(checked == 6);
    return largest;
  };
  for (const int code : {1, 3, 10, 11}) {  // κ varies smoothly along the strip
    CAPTURE(code);
    CHECK(largest_error(without_limit(code)) < 0.01);
  }
  // At 1.5 GPa the limit is reached inside the strip of kTrac 1 and 18: 1.4 % and 1.7 %.
  for (const int code : {1, 3, 10, 11, 18}) {
    CAPTURE(code);
    CHECK(largest_error(lubricant(code)) < (code == 1 || code == 18 ? 0.03 : 0.01));
  }
}

TEST_CASE("all lubricants: the film grows with speed", "[physics][film_law]") {
  for (const int code : lubricant_codes())
    for (const bool lines : {false, true}) {
      if (lubricant(code).model == LubricantModel::ViscoElastic) continue;  // film as of the others
      const TractionLaw law = law_of(code, 350.0, 0.0, lines);
      double last = 0.0;
      for (double u = 1e-3; u < 3.0; u *= 1.5) {  // inlet heating plays no part yet
        const double film = law.film(lines ? line(1e9, u, 0.0) : point(1e9, u, 0.0)).thickness;
        CAPTURE(code, lines, u, film);
        CHECK(film > last);
        last = film;
      }
    }
}

TEST_CASE("all lubricants: traction falls with temperature at one film, and where it does not",
          "[physics][film_law]") {
  // theory/tribology.md 5. Below the thermal peak, S = 1, a hotter oil at one film never shears
  // more. Beyond it tau goes as K/beta, and rises as far as beta of measured viscosities falls.
  // With the film of its own temperature the slopes of viscosity at pressure and of the film
  // decide far below the peak; far beyond it viscosity hardly counts, and a thinner film is left.
  constexpr double kWarmer = 5.0, kFilm = 3e-7;
  int falls = 0, falls_below = 0, beyond_peak = 0, rises = 0;
  for (const int code : lubricant_codes())
    for (const double T : {330.0, 360.0, 390.0}) {
      const Lubricant& oil = lubricant(code);
      const bool strip = oil.model == LubricantModel::ViscoElastic;
      const TractionLaw cool = law_of(code, T, 0.0, false, true),
                        warm = law_of(code, T + kWarmer, 0.0, false, true);
      const auto film_at = [](const TractionLaw& law) {  // flooded, too slow to heat its inlet
        return law.film(point(1e9, 0.05, 0.0)).thickness;
      };
      const double h = film_at(cool), thinner = film_at(warm);
      CHECK(thinner < h);
      const auto kappa = [](const TractionLaw& law, double thickness, double slip, double p) {
        return law.visit([&](const auto& own) {
          if constexpr (kHasFilm<std::decay_t<decltype(own)>>)
            return own.fluid.at(point(p, 20.0, slip), thickness)(slip, p);
          else
            return -1.0;
        });
      };
      const auto heating = [&](double p, double at) {  // K/beta
        return oil.conductivity.at(at) / oil.beta_under_pressure(p, at);
      };
      for (const double p : {0.5e9, 1e9, 2e9})
        for (const double slip : {1e-5, 1e-2, 0.3, 3.0, 30.0}) {
          const double now = kappa(cool, kFilm, slip, p), hot = kappa(warm, kFilm, slip, p);
          const double S =
              strip ? 0.0
                    : slip * std::sqrt(oil.viscosity_under_pressure(p, T) / (8.0 * heating(p, T)));
          CAPTURE(code, T, p, slip, S);
          CHECK(now > 0.0);
          if (!strip && !(oil.beta_under_pressure(p, T) > 1e-6)) continue;  // a glass
          if (S < 1.0) {  // glass and limiting stress: the same, to the fit of the viscosity
            CHECK(hot <= now * (1.0 + 1e-5));
            ++falls;
          } else {
            CHECK(hot <
                  now * std::max(1.0, heating(p, T + kWarmer) / heating(p, T)) * (1.0 + 1e-5));
            ++beyond_peak;
            rises += hot > now ? 1 : 0;
          }
        }
      constexpr double kPressure = 0.5e9, kLittle = 1e-9, kMuch = 300.0;
      CAPTURE(code, T);
      const double below =
          std::log(kappa(warm, thinner, kLittle, kPressure) / kappa(cool, h, kLittle, kPressure));
      if (strip) {
        CHECK(below < 0.0);
      } else {
        const double slopes = std::log(oil.viscosity_under_pressure(kPressure, T + kWarmer) /
                                       oil.viscosity_under_pressure(kPressure, T)) -
                              std::log(thinner / h);
        CHECK(below == Approx(slopes).margin(1e-3));
      }
      falls_below += below < 0.0 ? 1 : 0;
      if (oil.model == LubricantModel::NewtonianThermal &&
          kappa(warm, thinner, kMuch, kPressure) < 0.4 * oil.limiting_ratio(T)) {
        const double beyond =
            kappa(warm, thinner, kMuch, kPressure) / kappa(cool, h, kMuch, kPressure);
        CHECK(beyond > 1.0);
        CHECK(beyond < h / thinner);
      }
    }
  CAPTURE(falls, beyond_peak, rises, falls_below);
  CHECK(falls > 400);
  CHECK(beyond_peak > 100);
  CHECK(rises > 50);         // the exception is met
  CHECK(falls_below >= 56);  // of 57: kTrac 1 at 330 K has a traction flatter than its inlet
}

TEST_CASE("a skidding ball recovers when its load rises", "[physics][film_law]") {
  // An orbiting mass between a race that slips over it by s and a drag: m ds/dt = drag - κ(s) Q.
  for (const int code : {3, 4, 8, 10, 11, 18}) {
    const TractionLaw law = law_of(code, 350.0, 1e-8, false);
    constexpr double kMass = 0.01, kDrag = 0.4, kStep = 1e-6;
    constexpr double kRadiusOfLoad = 4e8;
    double slip = 0.0, light = 0.0;
    for (const double p0 : {kRadiusOfLoad, 3.0 * kRadiusOfLoad}) {
      const int steps = 60000;
      for (int i = 0; i < steps; ++i) {
        const ContactConditions<double> at = point(p0, 20.0, slip);
        const double s = std::sqrt(slip * slip + law.regularization_slip_squared());
        const double kappa = law.visit([&](const auto& own) { return own.at(at)(s, 0.75 * p0); });
        slip = std::max(0.0, slip + kStep / kMass * (kDrag - kappa * at.load * slip / s));
      }
      CAPTURE(code, p0, slip);
      CHECK(std::isfinite(slip));
      if (p0 == kRadiusOfLoad) {
        light = slip;
        CHECK(light > 0.0);
      } else {
        CHECK(slip < 0.5 * light);
      }
    }
  }
}

TEST_CASE("a starved contact heats more than a flooded one", "[physics][film_law]") {
  for (const int code : {1, 3, 4, 10, 11}) {
    const auto heat = [&](double meniscus) {
      bearing::Lubrication lubrication;
      lubrication.code = code;
      lubrication.critical_film = 1e-9;
      lubrication.meniscus = meniscus;
      RaceFilmInputs surface;
      surface.radius = kRadius;
      surface.modulus = kModulus;
      surface.wall_temperature = 350.0;
      surface.race_speed = 30.0;
      const TractionLaw law = film_law(traction_curve(1, {0.0, 0.12, 0.08, 0.5}), lubricant(code),
                                       lubrication, surface);
      const double slip = 0.1, p0 = 1e9;
      const ContactConditions<double> at = point(p0, 20.0, slip);
      CHECK(law.film(at).thickness > 0.0);
      return law.visit([&](const auto& own) { return own.at(at)(slip, 0.75 * p0); }) * at.load *
             slip;
    };
    CAPTURE(code, heat(10.0), heat(0.1));
    CHECK(heat(0.1) > 1.05 * heat(10.0));
    CHECK(heat(0.03) > heat(0.1));
  }
}
