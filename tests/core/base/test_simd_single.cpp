#include "base/simd_tiles.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

/// Functions in single precision, by the vectors that this test is compiled for.
using namespace adore;

namespace {

using V = SimdReal;
using Single = SimdSinglePrecision<V>;
using Math = ScalarMath<Single>;
constexpr std::size_t kLanes = V::size();

/// Largest error over x = first, first * ratio ... up to `last`; relative, or absolute.
template <class Function, class Exact>
double largest_error(double first, double last, const Function& function, const Exact& exact,
                     bool relative = true) {
  double largest = 0.0;
  for (double x = first; x < last; x *= 1.00917) {
    const double rounded = static_cast<float>(x);
    const double is = function(Single(rounded)).v[0], should = exact(rounded);
    largest = std::max(largest, std::abs(is - should) / (relative ? std::abs(should) : 1.0));
  }
  return largest;
}

}  // namespace

TEST_CASE("single precision: functions are right to a few 1e-7 over the range of floats",
          "[unit][simd]") {
  CHECK(largest_error(1e-3, 85.0, Math::exp, [](double x) { return std::exp(x); }) < 4e-7);
  CHECK(largest_error(
            1e-3, 85.0, [](const Single& x) { return Math::exp(0.0 - x); },
            [](double x) { return std::exp(-x); }) < 4e-7);
  CHECK(largest_error(1e-30, 1e30, Math::inverse_sqrt,
                      [](double x) { return 1.0 / std::sqrt(x); }) < 2e-7);
  CHECK(largest_error(1e-30, 1e30, InverseRoots<Single>::first, [](double x) { return 1.0 / x; }) <
        2e-7);
  CHECK(largest_error(1.0, 1e30, InverseRoots<Single>::fourth,
                      [](double x) { return std::pow(x, -0.25); }) < 2e-7);
  // Of the logarithm half the last digit of 69 is 4e-6.
  CHECK(largest_error(
            1e-30, 1e30, Math::log, [](double x) { return std::log(x); }, false) < 1e-5);
  CHECK(largest_error(
            0.5, 2.0, Math::log, [](double x) { return std::log(x); }, false) < 2e-7);
  const auto asinh = [](const Single& S) {
    Single inverse;
    const Single square = S * S, root = Math::sqrt_and_inverse(1.0 + square, inverse);
    return ScalarAsinh<Single>::of(S, square, root, inverse);
  };
  CHECK(largest_error(1e-15, 1e15, asinh, [](double x) { return std::asinh(x); }) < 1e-6);
}

TEST_CASE("single precision: two vectors of doubles → packed and unpacked in order",
          "[unit][simd]") {
  const V a([](auto i) { return 1.0 + static_cast<double>(i); });
  const V b([](auto i) { return -0.5 - static_cast<double>(i); });
  const Single both = SinglePrecisionOf<V>::pack(a, b);
  V first, second;
  SinglePrecisionOf<V>::unpack(both, first, second);
  for (std::size_t i = 0; i < kLanes; ++i) {
    CHECK(first[i] == a[i]);
    CHECK(second[i] == b[i]);
    CHECK(both.v[i] == a[i]);
    CHECK(both.v[i + kLanes] == b[i]);
  }
}

TEST_CASE("single precision: each lane reads the polynomial of its own tile", "[unit][simd]") {
  constexpr int kTiles = 11;
  std::vector<float> tiles(16 * kTiles);
  for (std::size_t k = 0; k < tiles.size(); ++k)
    tiles[k] = static_cast<float>(std::sin(1.7 * static_cast<double>(k)));
  Single place, f, g;
  for (std::size_t l = 0; l < 2 * kLanes; ++l) {
    place.v[l] = static_cast<float>((7 * l + 3) % kTiles);
    f.v[l] = 0.05F * static_cast<float>(l + 1);
    g.v[l] = 1.0F - 0.03F * static_cast<float>(l);
  }
  const Single is = ScalarTiles<Single>::at(tiles.data(), place, f, g);
  const auto polynomial = [&](std::size_t l, int tile) {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        sum += tiles[static_cast<std::size_t>(16 * tile + 4 * i + j)] *
               std::pow(static_cast<double>(f.v[l]), i) * std::pow(static_cast<double>(g.v[l]), j);
    return sum;
  };
  for (std::size_t l = 0; l < 2 * kLanes; ++l)
    CHECK(is.v[l] == Approx(polynomial(l, static_cast<int>(place.v[l]))).margin(2e-6));
  // The mean of four that follow each other.
  Single weight[4];
  for (std::size_t l = 0; l < 2 * kLanes; ++l) {
    place.v[l] = static_cast<float>((5 * l + 2) % (kTiles - 3));
    for (std::size_t j = 0; j < 4; ++j)
      weight[j].v[l] = 0.1F * static_cast<float>(j + 1) - 0.02F * static_cast<float>(l);
  }
  const Single mean = ScalarTiles<Single>::weighted_mean_at(tiles.data(), place, f, g, weight);
  for (std::size_t l = 0; l < 2 * kLanes; ++l) {
    double sum = 0.0;
    for (int j = 0; j < 4; ++j)
      sum += static_cast<double>(weight[j].v[l]) * polynomial(l, static_cast<int>(place.v[l]) + j);
    CHECK(mean.v[l] == Approx(sum).margin(3e-6));
  }
}
