#include "base/sine_cosine.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

/// Difference from the standard library in units of the last place of 1 (values below 1: of
/// theirs).
double worst_error(const std::vector<double>& angles) {
  const auto n = angles.size();
  std::vector<double> sine(n), cosine(n);
  adore::sines_and_cosines(angles.data(), static_cast<int>(n), sine.data(), cosine.data());
  double worst = 0.0;
  const auto take = [&](double ours, double theirs) {
    const double ulp = std::nextafter(std::abs(theirs), std::numeric_limits<double>::infinity()) -
                       std::abs(theirs);
    worst = std::max(worst, std::abs(ours - theirs) / ulp);
  };
  for (std::size_t i = 0; i < n; ++i) {
    take(sine[i], std::sin(angles[i]));
    take(cosine[i], std::cos(angles[i]));
  }
  return worst;
}

}  // namespace

TEST_CASE("sine_cosine(): within two units in the last place of the standard library", "[unit]") {
  std::mt19937_64 dice(7);
  for (const double range : {1e-3, 1.0, 10.0, 1e4, 0.999e6}) {
    std::uniform_real_distribution<double> angle(-range, range);
    std::vector<double> angles(20000);
    for (double& one : angles) one = angle(dice);
    INFO(range);
    CHECK(worst_error(angles) <= 2.0);
  }
}

TEST_CASE("sine_cosine(): multiples of 90° and their neighbors", "[unit]") {
  std::vector<double> angles;
  for (int k = -40; k <= 40; ++k) {
    const double quarter = k * 0.5 * std::numbers::pi;
    for (const double beside : {0.0, 1e-15, -1e-15, 1e-8, -1e-8, 1e-3, -1e-3, 0.785, -0.785})
      angles.push_back(quarter + beside);
  }
  for (const double far : {5e5, -6.2e5}) angles.push_back(std::rint(far) * 0.5 * std::numbers::pi);
  CHECK(worst_error(angles) <= 2.0);
}

TEST_CASE("sine_cosine(): huge angles → values of the standard library", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double angles[4] = {1.0, 3e9, nan, -2.0};
  double sine[4], cosine[4];
  adore::sines_and_cosines(angles, 4, sine, cosine);
  CHECK(sine[0] == std::sin(1.0));
  CHECK(cosine[1] == std::cos(3e9));
  CHECK(std::isnan(sine[2]));
  CHECK(cosine[3] == std::cos(-2.0));
}
