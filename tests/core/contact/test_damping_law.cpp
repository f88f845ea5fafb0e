#include "base/constants.hpp"
#include "bearing/contact_losses.hpp"
#include "contact/damping_law.hpp"
#include "contact/film_squeeze.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

/// Energy loss of normal contacts (contact/damping_law.hpp, contact/film_squeeze.hpp).
using adore::kPi;
using namespace adore::contact;
using adore::bearing::material_from_table;
using adore::bearing::Part;

namespace {

constexpr double kRadius = 6.35e-3, kMass = 8.37e-3, kHertz = 1.1e10;  // half inch, steel

DampingLaw<> law_of(double alpha, double eta, double mass) {
  return {1.5 * alpha, eta * std::sqrt(mass), kOnsetOverRadius * kRadius};
}

double point_force(const DampingLaw<>& law, double approach, double rate) {
  if (!(approach > 0.0)) return 0.0;
  const double root = std::sqrt(approach);
  return damped_load(law, kHertz * approach * root, 1.5 * kHertz * root, approach, rate);
}

/// Speed of return over that of impact, of a mass on a point contact: classical Runge-Kutta.
double restitution(const DampingLaw<>& law, double mass, double speed) {
  const double time = 3.0 * std::pow(mass * mass / (kHertz * kHertz * speed), 0.2);
  const double h = time / 40000.0;
  double x = 0.0, v = speed;
  const auto a = [&](double at, double rate) { return -point_force(law, at, rate) / mass; };
  do {
    const double k1 = a(x, v), k2 = a(x + 0.5 * h * v, v + 0.5 * h * k1),
                 k3 = a(x + 0.5 * h * v + 0.25 * h * h * k1, v + 0.5 * h * k2),
                 k4 = a(x + h * v + 0.5 * h * h * k2, v + h * k3);
    x += h * v + h * h / 6.0 * (k1 + k2 + k3);
    v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  } while (x > 0.0);
  return -v / speed;
}

/// Of Hunt and Crossley: d v (1 + e) = ln((1 + d v)/(1 - d e v)).
double impact_restitution(double alpha, double speed) {
  const double v = 1.5 * alpha * speed;
  double low = 0.0, high = std::min(1.0, 1.0 / v);
  for (int k = 0; k < 100; ++k) {
    const double e = 0.5 * (low + high);
    (v * (1.0 + e) > std::log((1.0 + v) / (1.0 - v * e)) ? low : high) = e;
  }
  return 0.5 * (low + high);
}

/// Of Tsuji, Tanaka and Ishida's law with c = β √(m K) δ^(1/4) [Antypov and Elliott 2011].
double material_restitution(double beta) {
  return std::exp(-kPi * beta / std::sqrt(5.0 - beta * beta));
}

/// ∫ from 0 to `end` by Simpson's rule over x = t^4: integrands behave like √t there.
double integral(const std::function<double(double)>& f, double end) {
  constexpr int kCells = 4000;
  const double width = std::pow(end, 0.25) / kCells;
  const auto g = [&](double x) { return x > 0.0 ? 4.0 * x * x * x * f(x * x * x * x) : 0.0; };
  double sum = 0.0;
  for (int k = 0; k < kCells; ++k)
    sum += width / 6.0 * (g(k * width) + 4.0 * g((k + 0.5) * width) + g((k + 1) * width));
  return sum;
}

}  // namespace

TEST_CASE("damped_load(): random states -> never pulls, never gives energy back",
          "[unit][physics][damping]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-10.0, -4.0), speed(-5.0, 5.0), unit(0.0, 1.0);
  int cut = 0;
  for (int k = 0; k < 100000; ++k) {
    const DampingLaw<> law = law_of(2.0 * unit(random), unit(random), kMass);
    const double approach = std::pow(10.0, exponent(random)), rate = speed(random);
    const double elastic = point_force({}, approach, rate), F = point_force(law, approach, rate);
    REQUIRE(F >= 0.0);
    REQUIRE((F - elastic) * rate >= 0.0);
    if (F == 0.0) ++cut;
  }
  CHECK(cut > 100);
  CHECK(point_force(law_of(0.1, 0.1, kMass), 0.0, 3.0) == 0.0);
}

TEST_CASE("damped_load(): onset of contact -> force and slope are continuous",
          "[unit][physics][damping]") {
  const DampingLaw<> law = law_of(0.1, 0.02, kMass);
  for (const double rate : {0.05, 1.0, 3.0}) {
    double before = 1e300;
    for (const double approach : {1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
      const double slope = point_force(law, approach, rate) / approach;
      CHECK(slope < 0.7 * before);
      before = slope;
    }
  }
  // Where the bracket of separation is cut, F is 0 on both sides.
  double low = 1e-12, high = 1e-5;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (point_force(law, middle, -1.0) > 0.0 ? high : low) = middle;
  }
  CHECK(point_force(law, high, -1.0) < 1e-9);
}

TEST_CASE("impact loss: 0.02 to 3 m/s -> the closed form of Hunt and Crossley",
          "[physics][damping]") {
  for (const double alpha : {0.08, 0.3, 2.0})
    for (const double speed : {0.02, 0.05, 0.3, 1.0, 3.0}) {
      INFO(alpha << " s/m, " << speed << " m/s");
      CHECK(restitution(law_of(alpha, 0.0, kMass), kMass, speed) ==
            Approx(impact_restitution(alpha, speed)).epsilon(1e-4));
    }
}

TEST_CASE("material loss: impacts at 0.05 to 3 m/s -> the closed form, the same at every speed",
          "[physics][damping]") {
  for (const double eta : {0.01, 0.05})
    for (const double speed : {0.05, 0.3, 3.0}) {
      INFO(eta << ", " << speed << " m/s");
      CHECK(restitution(law_of(0.0, eta, kMass), kMass, speed) ==
            Approx(material_restitution(std::sqrt(1.5) * eta)).epsilon(3e-3 * eta / 0.01));
    }
}

TEST_CASE(
    "default losses of bearing steel: 0.05 to 3 m/s -> restitution of steel balls as published",
    "[physics][damping]") {
  const auto steel = material_from_table(100, Part::RollingElement);
  const auto losses = adore::bearing::contact_losses(steel, steel);
  const DampingLaw<> law = law_of(losses.impact_loss, losses.loss_factor, 0.5 * kMass);
  // Hardened steel on hardened steel [recalled, medium: Goldsmith 1960; Tabor 1948; Johnson 1985]:
  // low and high ends of what is plotted.
  struct Band {
    double speed, low, high;
  };
  double before = 1.0;
  for (const Band& band : {Band{0.05, 0.95, 1.0}, Band{0.1, 0.94, 0.995}, Band{0.5, 0.89, 0.98},
                           Band{1.0, 0.85, 0.96}, Band{3.0, 0.72, 0.92}}) {
    const double e = restitution(law, kMass, band.speed);
    INFO(band.speed << " m/s: " << e);
    CHECK(e > band.low);
    CHECK(e < band.high);
    CHECK(e < before);
    before = e;
  }
}

TEST_CASE("material loss: a small vibration about any load -> logarithmic decrement of pi eta",
          "[physics][damping]") {
  // A mass between two equal contacts, pressed together.
  const double eta = 0.01;
  const DampingLaw<> law = law_of(0.0, eta, 0.5 * kMass);
  for (const double load : {5.0, 100.0, 5000.0}) {
    const double approach = std::pow(load / kHertz, 2.0 / 3.0);
    const double omega = std::sqrt(3.0 * kHertz * std::sqrt(approach) / kMass);
    const auto a = [&](double x, double v) {
      return (point_force(law, approach - x, -v) - point_force(law, approach + x, v)) / kMass;
    };
    constexpr int kPeriods = 10, kSteps = 2000;
    const double h = 2.0 * kPi / omega / kSteps, start = 1e-4 * approach;
    double x = start, v = 0.0, top = start;
    for (int k = 0; k < kPeriods * kSteps; ++k) {
      const double k1 = a(x, v), k2 = a(x + 0.5 * h * v, v + 0.5 * h * k1),
                   k3 = a(x + 0.5 * h * v + 0.25 * h * h * k1, v + 0.5 * h * k2),
                   k4 = a(x + h * v + 0.5 * h * h * k2, v + h * k3);
      x += h * v + h * h / 6.0 * (k1 + k2 + k3);
      v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      if (k > (kPeriods - 1) * kSteps + kSteps / 2)
        top = k == (kPeriods - 1) * kSteps + kSteps / 2 + 1 ? x : std::max(top, x);
    }
    INFO(load << " N");
    // Below some newtons the onset takes a share, δs/δ.
    CHECK(std::log(start / top) / kPeriods ==
          Approx(kPi * eta).epsilon(0.01 + law.onset / approach));
  }
}

TEST_CASE("film squeeze: circle and line -> Reynolds' equation integrated outside the contact",
          "[physics][damping]") {
  const double E = 1.13e11, R = 5e-3, eta = 0.02;
  for (const double film : {1e-7, 3e-7}) {
    // Circle: exact Hertz gap, and 1 - (2/π) asin(a/r) of the flat punch.
    const double a = 1.5e-4, k = 2.0 * E * a, p0 = 2.0 * E * a / (kPi * R);
    const auto gap = [&](double s) {
      const double x = 1.0 + s / a;
      return a * a / R *
             (0.5 * x * x - 1.0 +
              ((2.0 - x * x) * std::asin(1.0 / x) + std::sqrt(x * x - 1.0)) / kPi);
    };
    const auto flow = [&](double s) {  // outward, by radius
      return integral(
                 [&](double t) { return (1.0 - 2.0 / kPi * std::asin(a / (a + t))) * (a + t); },
                 s) /
             (a + s);
    };
    // q once on a grid of x = s^(1/4), for speed.
    constexpr int kGrid = 2000;
    const double end = 5.0 * a, width = std::pow(end, 0.25) / kGrid;
    double rim = 0.0, q = flow(std::pow(width, 4.0)) * (a + std::pow(width, 4.0));
    for (int i = 1; i < kGrid; ++i) {
      const auto place = [&](double j) { return std::pow(j * width, 4.0); };
      const double s0 = place(i), s1 = place(i + 1), middle = 0.5 * (s0 + s1);
      const auto closing = [&](double t) {
        return (1.0 - 2.0 / kPi * std::asin(a / (a + t))) * (a + t);
      };
      const double q1 = q + (s1 - s0) / 6.0 * (closing(s0) + 4.0 * closing(middle) + closing(s1));
      const auto rise = [&](double s, double Q) {
        return 12.0 * eta * Q / (a + s) / std::pow(film + std::max(gap(s), 0.0), 3.0);
      };
      rim += 0.5 * (s1 - s0) * (rise(s0, q) + rise(s1, q1));
      q = q1;
    }
    const double whole = kPi * a * a * rim;  // oil all around: twice what enters at the inlet
    const double ours = 2.0 * squeeze_damping({false, k, E, p0, a, film, eta});
    INFO("circle, film " << film << " m: " << ours << " for " << whole);
    CHECK(ours == Approx(whole).epsilon(film < 2e-7 ? 0.10 : 0.20));
  }
  for (const double film : {1e-7, 3e-7}) {
    const double b = 1.5e-4, L = 1e-2, p0 = E * b / (2.0 * R);
    const double load = 0.5 * kPi * p0 * b * L, k = 2e9;
    REQUIRE(load > 0.0);
    const double widening = 2.0 * R * k / (kPi * E * b * L);  // db/dδ
    constexpr int kGrid = 2000;
    const double end = 5.0 * b, width = std::pow(end, 0.25) / kGrid;
    double rim = 0.0, q = 0.0;
    const auto closing = [&](double s) { return b / R * widening * std::acosh(1.0 + s / b); };
    const auto gap = [&](double s) {
      const double x = 1.0 + s / b;
      return b * b / (2.0 * R) * (x * std::sqrt(x * x - 1.0) - std::acosh(x));
    };
    for (int i = 0; i < kGrid; ++i) {
      const double s0 = std::pow(i * width, 4.0), s1 = std::pow((i + 1) * width, 4.0);
      const double q1 =
          q + (s1 - s0) / 6.0 * (closing(s0) + 4.0 * closing(0.5 * (s0 + s1)) + closing(s1));
      const auto rise = [&](double s, double Q) {
        return 12.0 * eta * Q / std::pow(film + std::max(gap(s), 0.0), 3.0);
      };
      rim += 0.5 * (s1 - s0) * (rise(s0, q) + rise(s1, q1));
      q = q1;
    }
    const double inlet = b * L * rim;  // falling to the outlet: half the area 2 b L
    const double ours = squeeze_damping({true, k, E, p0, b, film, eta});
    INFO("line, film " << film << " m: " << ours << " for " << inlet);
    CHECK(ours == Approx(inlet).epsilon(0.20));
  }
  // Floor, and the power of the film.
  const SqueezedFilm f{false, 3e7, E, 1e9, 1e-4, 4e-7, 0.01};
  SqueezedFilm thinner = f, none = f, floor = f;
  thinner.film = 2e-7;
  none.film = 0.0;
  floor.film = kLeastSqueezedFilm;
  CHECK(squeeze_damping(thinner) == Approx(std::pow(2.0, 4.0 / 3.0) * squeeze_damping(f)));
  CHECK(squeeze_damping(none) == squeeze_damping(floor));
}
