#include "assembly/set_life.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>

using namespace adore::assembly;

TEST_CASE("life_of_set(): product rule of survival", "[unit][assembly][life]") {
  const std::array<double, 2> same{1000.0, 1000.0};
  // Two equal ball rows: 2^(-9/10) = 0.5359 of the life of one row.
  CHECK(*life_of_set(same, kBallSlope) == Approx(1000.0 * std::pow(2.0, -0.9)));
  CHECK(*life_of_set(same, kRollerSlope) == Approx(1000.0 * std::pow(2.0, -8.0 / 9.0)));
  // ln(1/S) of the rows adds up at the life of the set.
  const std::array<double, 3> other{1e3, 5e3, 2e8};
  const double life = *life_of_set(other, kBallSlope);
  double sum = 0.0;
  for (const double row : other) sum += std::pow(life / row, kBallSlope);
  CHECK(sum == Approx(1.0));
}

TEST_CASE("life_of_set(): infinite and missing lives", "[unit][assembly][life]") {
  const double infinite = std::numeric_limits<double>::infinity();
  const std::array<double, 2> one{500.0, infinite}, all{infinite, infinite},
      missing{500.0, std::nan("")}, zero{0.0, 1.0};
  CHECK(*life_of_set(one, kBallSlope) == Approx(500.0));
  CHECK(std::isinf(*life_of_set(all, kBallSlope)));
  CHECK_FALSE(life_of_set(missing, kBallSlope));
  CHECK_FALSE(life_of_set(zero, kBallSlope));
  CHECK_FALSE(life_of_set({}, kBallSlope));
}
