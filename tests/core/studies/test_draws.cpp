#include "studies/draws.hpp"
#include "studies/study.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace adore::studies;

TEST_CASE("normal scores: inverse of the normal distribution to the last digits",
          "[unit][studies]") {
  for (const double z : {-8.0, -3.0, -1.96, -0.5, 0.0, 0.1, 1.0, 2.5, 6.0}) {
    const double share = normal_cdf(z);
    // Above zero the share itself has lost digits: 1 - u is what it still holds.
    const double lost = z > 0.0 ? 4e-16 / (1.0 - share) : 0.0;
    CHECK(normal_quantile(share) == Approx(z).margin(1e-13 + lost));
  }
  CHECK(normal_quantile(0.975) == Approx(1.959963984540054).epsilon(1e-14));
  CHECK(normal_quantile(0.5) == Approx(0.0).margin(1e-15));
}

TEST_CASE("Latin samples: one point in each stratum of every dimension", "[unit][studies]") {
  constexpr long n = 200;
  const auto samples = unit_cube_samples(Sampling::Latin, n, 5, 7);
  for (std::size_t k = 0; k < 5; ++k) {
    std::set<long> strata;
    for (const auto& sample : samples) strata.insert(static_cast<long>(sample[k] * n));
    CHECK(strata.size() == n);
  }
  CHECK(samples == unit_cube_samples(Sampling::Latin, n, 5, 7));
  CHECK(samples != unit_cube_samples(Sampling::Latin, n, 5, 8));
}

TEST_CASE("Sobol points: every dyadic interval of every dimension has equally many",
          "[unit][studies]") {
  constexpr long n = 256;
  const auto samples = unit_cube_samples(Sampling::Sobol, n, kSobolDimensions, 3);
  for (std::size_t k = 0; k < kSobolDimensions; ++k) {
    std::set<long> cells;
    for (const auto& sample : samples) cells.insert(static_cast<long>(sample[k] * n));
    INFO("dimension " << k);
    CHECK(cells.size() == n);
  }
  // The first two dimensions are a (0, 8, 2)-net: one point in each of 16 x 16 squares.
  std::set<std::pair<long, long>> squares;
  for (const auto& sample : samples)
    squares.insert({static_cast<long>(sample[0] * 16), static_cast<long>(sample[1] * 16)});
  CHECK(squares.size() == 256);
  // No two dimensions are the same sequence.
  for (std::size_t a = 0; a < kSobolDimensions; ++a)
    for (std::size_t b = a + 1; b < kSobolDimensions; ++b) {
      double sum = 0.0;
      for (const auto& sample : samples) sum += (sample[a] - 0.5) * (sample[b] - 0.5);
      CHECK(std::abs(12.0 * sum / n) < 0.3);
    }
  CHECK_THROWS_WITH(unit_cube_samples(Sampling::Sobol, n, kSobolDimensions + 1, 3),
                    Catch::Contains("use the method \"latin\""));
}

TEST_CASE("Sobol points: smooth product → integrated far better than by random points",
          "[unit][studies]") {
  // ∫ Π (1 + (x_k - 1/2)) = 1 in eight dimensions.
  const auto error = [](Sampling method) {
    const auto samples = unit_cube_samples(method, 4096, 8, 1);
    double mean = 0.0;
    for (const auto& sample : samples) {
      double product = 1.0;
      for (const double x : sample) product *= 0.5 + x;
      mean += product / 4096.0;
    }
    return std::abs(mean - 1.0);
  };
  // Standard error of independent points: √((13/12)^8 - 1) / 64 = 0.0148; a fifth of it.
  CHECK(error(Sampling::Sobol) < 0.003);
  CHECK(error(Sampling::Random) > error(Sampling::Sobol));
}

TEST_CASE("correlation: impossible matrix → error, singular one → accepted", "[unit][studies]") {
  Eigen::MatrixXd c = Eigen::MatrixXd::Identity(3, 3), factor;
  c(0, 1) = c(1, 0) = 0.6;
  c(1, 2) = c(2, 1) = -0.3;
  REQUIRE(factorize_correlation(c, factor));
  CHECK((factor * factor.transpose() - c).cwiseAbs().maxCoeff() < 1e-14);
  c(0, 1) = c(1, 0) = 1.0;
  c(1, 2) = c(2, 1) = c(0, 2) = c(2, 0) = 0.5;
  REQUIRE(factorize_correlation(c, factor));
  CHECK((factor * factor.transpose() - c).cwiseAbs().maxCoeff() < 1e-12);
  c(1, 2) = c(2, 1) = -0.5;
  CHECK_FALSE(factorize_correlation(c, factor));
}
