#include "base/errors.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/race_errors.hpp"
#include "contact/wavy_groove_model.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <utility>

using namespace adore;
using namespace adore::contact;
using bearing::RaceErrors;

namespace {

RaceErrors waves(double order) {
  RaceErrors e;
  e.roundness = RaceErrors::Roundness::Sinusoidal;
  e.variation = {2e-6, order, 0.4};
  e.land_offset = {3e-5, 3.0, -1.0};
  e.taper = {1e-4, 2.0, 2.0};
  e.curvature_factor = {0.004, 5.0, 0.7};
  return e;
}

bearing::BallGeometry balls() {
  bearing::BallGeometry b;
  b.count = 12;
  b.diameter = 0.0127;
  b.pitch_diameter = 0.06;
  b.contact_angle = 0.4;
  b.groove_factor = {0.523, 0.52};
  return b;
}

}  // namespace

TEST_CASE("race errors: by cosine and sine of the azimuth they are those of its angle",
          "[unit][imperfections]") {
  constexpr double R = 0.036;
  RaceErrors oval = waves(0.0);
  oval.roundness = RaceErrors::Roundness::Elliptical;
  oval.variation = {5e-6, -3e-6, 0.6};
  for (const RaceErrors& errors : {waves(0.0), waves(1.0), waves(-7.0), waves(64.0), oval}) {
    const RaceErrorModel form = make_race_error_model(errors, R);
    for (const double psi : {-2.0, 0.0, 0.3, 2.2, 5.9}) {
      const LocalRaceError angle = race_error_at(errors, R, psi);
      const LocalRaceError direction =
          race_error_at(form, AzimuthDirection<double>{std::cos(psi), std::sin(psi)});
      INFO(errors.variation[1] << " waves at " << psi);
      // 64 waves: as many rounding errors of the cosine.
      CHECK(direction.radius == Approx(angle.radius).margin(1e-19));
      CHECK(direction.radius_slope == Approx(angle.radius_slope).margin(1e-17));
      CHECK(direction.land_offset == Approx(angle.land_offset).margin(1e-19));
      CHECK(direction.taper == Approx(angle.taper).margin(1e-18));
      CHECK(direction.curvature_factor == Approx(angle.curvature_factor).margin(1e-17));
      const double h = 1e-5;
      const LocalRaceError next = race_error_at(errors, R, psi + h);
      const LocalRaceError before = race_error_at(errors, R, psi - h);
      CHECK(direction.land_offset_slope ==
            Approx((next.land_offset - before.land_offset) / (2 * h)).margin(1e-13));
      CHECK(direction.taper_slope == Approx((next.taper - before.taper) / (2 * h)).margin(1e-13));
      CHECK(direction.curvature_factor_slope ==
            Approx((next.curvature_factor - before.curvature_factor) / (2 * h)).margin(1e-10));
    }
  }
}

TEST_CASE("wavy groove: Hertz's constants follow the curvature factor", "[unit][imperfections]") {
  constexpr double angle = 0.35;
  const auto constants = [&](double change) {
    bearing::BallGeometry here = balls();
    here.groove_factor[1] += change;
    return hertz_constants(race_curvature(here, 1, angle), 2e11);
  };
  const HertzConstants nominal = constants(0.0);
  // f - 1/2 = 0.02 changes by a fifth, and by three fifths.
  for (const auto& [amplitude, error] : {std::pair{0.004, 1e-8}, {0.012, 3e-5}}) {
    RaceErrors errors;
    errors.curvature_factor = {amplitude, 1.0, 0.0};
    const WavyGroove groove = make_wavy_groove(balls(), 1, errors, angle);
    const auto at = [&](double psi) {
      return wavy_groove_contact(groove, groove.ratios,
                                 AzimuthDirection<double>{std::cos(psi), std::sin(psi)}, 1e-4, 2e-4,
                                 2.5e-4);
    };
    for (int i = 0; i <= 40; ++i) {
      const double psi = -std::numbers::pi + i * 0.05 * std::numbers::pi;
      const HertzConstants here = constants(amplitude * std::sin(psi));
      const double size = std::cbrt(here.K / nominal.K);
      CHECK(at(psi).stiffness == Approx(here.K / nominal.K).epsilon(error));
      CHECK(at(psi).major == Approx(here.a_hat / nominal.a_hat * size).epsilon(error));
      CHECK(at(psi).minor == Approx(here.b_hat / nominal.b_hat * size).epsilon(error));
    }
    CHECK(at(0.0).stiffness == Approx(1.0).epsilon(1e-15));
  }
}

TEST_CASE("wavy groove: the force is minus the gradient of one potential",
          "[unit][imperfections][jacobian]") {
  const GrooveGeometry g = groove_geometry(balls());
  for (int race = 0; race < 2; ++race) {
    const auto j = static_cast<std::size_t>(race);
    const WavyGroove groove = make_wavy_groove(balls(), race, waves(9.0), 0.4);
    struct At {
      double energy, load, n_k, n_e, push;
    };
    constexpr double K = 1e10;
    const auto contact_at = [&](double xi, double R, double psi) {
      const WavyGrooveContact<double> at = wavy_groove_contact(
          groove, groove.ratios, AzimuthDirection<double>{std::cos(psi), std::sin(psi)}, xi,
          R - g.centre_radius[j], g.offset[j]);
      const double load = hertz_load(K * at.stiffness, at.touch.approach);
      return At{point_contact_energy(load, at.touch.approach), load, at.touch.n_k, at.touch.n_e,
                wavy_tangential_force(at, load, 0.0, at.touch.approach, R)};
    };
    const double sign = race == 0 ? 1.0 : -1.0, depth = g.offset[j] + 3e-5;
    const double xi = sign * depth * std::sin(0.45);
    const double R = g.centre_radius[j] + sign * depth * std::cos(0.45);
    for (const double psi : {0.0, 1.3, 4.0}) {
      const At here = contact_at(xi, R, psi);
      REQUIRE(here.load > 0.0);
      constexpr double h = 1e-9, turn = 1e-7;
      const double along =
          (contact_at(xi + h, R, psi).energy - contact_at(xi - h, R, psi).energy) / (2 * h);
      const double outward =
          (contact_at(xi, R + h, psi).energy - contact_at(xi, R - h, psi).energy) / (2 * h);
      const double around =
          (contact_at(xi, R, psi + turn).energy - contact_at(xi, R, psi - turn).energy) /
          (2 * turn * R);
      CHECK(here.load * here.n_k == Approx(along).margin(1e-6 * here.load));
      CHECK(here.load * here.n_e == Approx(outward).margin(1e-6 * here.load));
      CHECK(here.push == Approx(-around).margin(1e-6 * here.load));
      CHECK(std::abs(here.push) > 1e-5 * here.load);
    }
  }
}

TEST_CASE("wavy groove: a wave that does not close is refused in motion", "[unit][imperfections]") {
  CHECK_THROWS_WITH(make_wavy_groove(balls(), 0, waves(2.5), 0.4), Catch::Contains("whole number"));
}
