#include "listing/cell_text.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using adore::listing::append_cell;

namespace {

std::string cell(double value, std::size_t width) {
  std::string out = "x";
  append_cell(out, value, width);
  return out.substr(1);
}

}  // namespace

TEST_CASE("cell_text: same text as a general printer", "[unit][listing]") {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> exponent(-320.0, 308.0), near_one(-8.0, 8.0),
      mantissa(-10.0, 10.0);
  for (int k = 0; k < 200'000; ++k) {
    const double power = k % 2 == 0 ? exponent(random) : near_one(random);
    const double value = mantissa(random) * std::pow(10.0, power);
    const std::string right = fmt::format("{:>12.5g}", value + 0.0);
    if (cell(value, 12) != right) CHECK(cell(value, 12) == right);
  }
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             10.0,
                             12345.0,
                             99999.5,
                             123456.0,
                             100000.0,
                             0.0001,
                             0.00012345,
                             1e-5,
                             0.5,
                             1e100,
                             -1e-100,
                             1e10,
                             99999.4999,
                             2.5e-310,
                             std::numeric_limits<double>::infinity(),
                             -2.00005})
    CHECK(cell(value, 12) == fmt::format("{:>12.5g}", value + 0.0));
  CHECK(cell(std::nan(""), 12) == "           -");
  CHECK(cell(-1.2345e-100, 4) == "-1.2345e-100");
}
