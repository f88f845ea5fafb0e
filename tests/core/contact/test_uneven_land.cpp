#include "base/constants.hpp"
#include "contact/uneven_land.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

/// Guide lands whose radius varies around, in motion.
using namespace adore;
using namespace adore::contact;

namespace {

constexpr double kModulus = 1.1e11;

UnevenLand::Shape circle(bool outer, double half_angle = kPi) {
  UnevenLand::Shape s;
  s.side = outer ? 1.0 : -1.0;
  s.clearance = 1e-4;
  s.cage = {LandProfile::Kind::Circle, 0.025, 0.0, 0.0, 0.0};
  s.race = {LandProfile::Kind::Circle, 0.025 + s.side * s.clearance, 0.0, 0.0, 0.0};
  s.stiffness = 3.0 * kPi / 16.0 * kModulus * 0.003;
  s.half_angle = half_angle;
  return s;
}

UnevenLand::Shape waves(bool outer, double half_angle = kPi) {
  UnevenLand::Shape s = circle(outer, half_angle);
  s.cage.kind = LandProfile::Kind::Wave;
  s.cage.variation_1 = 2e-5;
  s.cage.variation_2 = 5.0;
  s.cage.phase = 0.4;
  s.race.kind = LandProfile::Kind::Ellipse;
  s.race.variation_1 = 1.5e-5;
  s.race.variation_2 = -1e-5;
  return s;
}

struct Sum {
  double y = 0.0, z = 0.0, turning = 0.0, energy = 0.0;
};

Sum sum_at(const UnevenLand& land, const UnevenLand::Place& at) {
  Sum sum;
  land.visit(at, [&](const ContactSpotSection& piece) {
    sum.y += piece.force[0];
    sum.z += piece.force[1];
    sum.turning += piece.turning;
    sum.energy += piece.energy;
  });
  return sum;
}

}  // namespace

TEST_CASE("an uneven land without errors is the circle's closed form", "[unit][land]") {
  for (const bool outer : {true, false}) {
    const UnevenLand land(circle(outer));
    const LandLaw law{kModulus, 1e-4};
    for (const double e : {0.99e-4, 1.0001e-4, 1.02e-4, 1.5e-4, 4e-4}) {
      const double direction = 2.3;
      const Sum sum =
          sum_at(land, {{-e * std::sin(direction), e * std::cos(direction)}, 0.7, 0.2, 0.0});
      INFO("outer " << outer << ", e " << e);
      CHECK(std::hypot(sum.y, sum.z) ==
            Approx(0.003 * land_load_per_length(law, e)).epsilon(1e-7).margin(1e-12));
      CHECK(sum.energy ==
            Approx(0.003 * land_energy_per_length(law, e)).epsilon(1e-7).margin(1e-18));
      CHECK(std::abs(sum.turning) <= 1e-9 * sum.energy);
      if (e > 1.01e-4) CHECK(-sum.y * std::sin(direction) + sum.z * std::cos(direction) < 0.0);
    }
  }
}

TEST_CASE("force and turning of an uneven land are minus the gradient of its energy",
          "[unit][land][jacobian]") {
  for (const bool outer : {true, false})
    for (const double half_angle : {kPi, 1.0}) {
      const UnevenLand land(waves(outer, half_angle));
      int pressed = 0;
      for (int n = 0; n < 40; ++n) {
        const double direction = 0.37 * n;
        const UnevenLand::Place at{{-1.05e-4 * std::sin(direction), 1.05e-4 * std::cos(direction)},
                                   0.9 * n,
                                   0.23 * n,
                                   0.5};
        const Sum sum = sum_at(land, at);
        if (!(sum.energy > 0.0)) continue;
        ++pressed;
        constexpr double h = 1e-10, turn = 1e-6;
        const auto slope = [&](auto&& change, double step) {
          UnevenLand::Place plus = at, minus = at;
          change(plus, step);
          change(minus, -step);
          return (sum_at(land, plus).energy - sum_at(land, minus).energy) / (2.0 * step);
        };
        const double size = std::hypot(sum.y, sum.z);
        INFO("outer " << outer << ", half angle " << half_angle << ", number " << n);
        CHECK(-slope([](auto& p, double s) { p.e[0] += s; }, h) ==
              Approx(sum.y).margin(2e-5 * size));
        CHECK(-slope([](auto& p, double s) { p.e[1] += s; }, h) ==
              Approx(sum.z).margin(2e-5 * size));
        CHECK(-slope([](auto& p, double s) { p.phi += s; }, turn) ==
              Approx(sum.turning).margin(2e-5 * size * 1e-4));
      }
      CHECK(pressed > 8);
    }
}

TEST_CASE("nothing changes when race, cage and eccentricity turn together", "[unit][land]") {
  const UnevenLand land(waves(true));
  const auto at = [](double turn) {
    return UnevenLand::Place{
        {-1.1e-4 * std::sin(0.3 + turn), 1.1e-4 * std::cos(0.3 + turn)}, 1.2 + turn, turn, 0.0};
  };
  const Sum before = sum_at(land, at(0.0));
  REQUIRE(before.energy > 0.0);
  CHECK(std::abs(before.turning) > 1e-3 * std::hypot(before.y, before.z) * 1e-4);
  for (const double turn : {0.5, 2.0, 9.0}) {
    const Sum after = sum_at(land, at(turn));
    CHECK(after.energy == Approx(before.energy).epsilon(1e-9));
    CHECK(after.turning == Approx(before.turning).epsilon(1e-7));
  }
}

TEST_CASE("the least gap of an uneven land is where it touches first", "[unit][land]") {
  for (const double half_angle : {kPi, 0.8}) {
    UnevenLand::Shape shape = waves(true, half_angle);
    const UnevenLand open(shape);
    for (int n = 0; n < 12; ++n) {
      const UnevenLand::Place at{
          {2e-5 * std::cos(n), 3e-5 * std::sin(2.0 * n)}, 0.6 * n, 0.1 * n, 0.0};
      const auto least = open.minimum_gap(at);
      // With so much less clearance it just touches, with a little more it does not.
      for (const double more : {-1e-9, 1e-9}) {
        shape = waves(true, half_angle);
        shape.clearance -= least.gap - more;
        INFO("half angle " << half_angle << ", number " << n << ", gap " << least.gap);
        CHECK((sum_at(UnevenLand(shape), at).energy > 0.0) == (more < 0.0));
      }
      CHECK(std::abs(least.s) <= half_angle);
      if (open.is_out_of_reach(at.e[0] * at.e[0] + at.e[1] * at.e[1])) CHECK(least.gap > 0.0);
    }
  }
}
