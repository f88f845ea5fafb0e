#include "studies/draws.hpp"

#include "base/errors.hpp"
#include "base/random_table.hpp"
#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace adore::studies {
namespace {

/// Words of a separate table for each dimension.
RandomTable table_of(std::uint64_t seed, int dimension) {
  const RandomTable seeds(seed);
  return RandomTable(seeds.word(static_cast<std::uint64_t>(dimension)));
}

/// The middle of one of 2^53 equal cells: never 0 or 1.
double unit(std::uint64_t word) {
  return (static_cast<double>(word >> 11) + 0.5) * (1.0 / 9007199254740992.0);
}

/// Primitive polynomial (degree, inner coefficients) and first direction numbers of a dimension:
/// new-joe-kuo-6 [joe2008].
struct Direction {
  int degree;
  unsigned coefficients;
  std::array<unsigned, 7> first;
};
constexpr std::array<Direction, kSobolDimensions - 1> kDirections{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};
constexpr int kBits = 32;

std::array<std::uint32_t, kBits> directions(int dimension) {
  std::array<std::uint32_t, kBits> v{};
  if (dimension == 0) {
    for (int i = 0; i < kBits; ++i) v[static_cast<std::size_t>(i)] = 1U << (kBits - 1 - i);
    return v;
  }
  const Direction& from = kDirections[static_cast<std::size_t>(dimension - 1)];
  const int s = from.degree;
  for (int i = 0; i < kBits; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i < s) {
      v[at] = from.first[at] << (kBits - 1 - i);
      continue;
    }
    const auto before = static_cast<std::size_t>(i - s);
    v[at] = v[before] ^ (v[before] >> s);
    for (int k = 1; k < s; ++k)
      if (((from.coefficients >> (s - 1 - k)) & 1U) != 0)
        v[at] ^= v[static_cast<std::size_t>(i - k)];
  }
  return v;
}

double sobol(const std::array<std::uint32_t, kBits>& v, std::uint64_t n, std::uint32_t shift) {
  std::uint32_t x = shift;
  for (std::size_t i = 0; n != 0 && i < kBits; ++i, n >>= 1)
    if ((n & 1U) != 0) x ^= v[i];
  return (static_cast<double>(x) + 0.5) / 4294967296.0;
}

}  // namespace

std::vector<std::vector<double>> unit_cube_samples(Sampling method, long samples, int dimensions,
                                                   std::uint64_t seed) {
  const auto n = static_cast<std::size_t>(samples);
  const auto d = static_cast<std::size_t>(dimensions);
  if (method == Sampling::Sobol && dimensions > kSobolDimensions)
    throw InputError(fmt::format(
        "sampling.method = sobol: each run needs {} random numbers (a variable with # needs one "
        "for each element), but the Sobol sequence provides at most {}; use the method \"latin\"",
        dimensions, kSobolDimensions));
  std::vector<std::vector<double>> out(n, std::vector<double>(d));
  for (std::size_t k = 0; k < d; ++k) {
    const RandomTable table = table_of(seed, static_cast<int>(k));
    if (method == Sampling::Sobol) {
      const auto v = directions(static_cast<int>(k));
      const auto shift = static_cast<std::uint32_t>(table.word(0) >> 32);
      for (std::size_t i = 0; i < n; ++i) out[i][k] = sobol(v, i, shift);
      continue;
    }
    if (method == Sampling::Random) {
      for (std::size_t i = 0; i < n; ++i) out[i][k] = unit(table.word(i));
      continue;
    }
    // Latin: sample i is in the stratum given by its position in a random order.
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return table.word(2 * a) < table.word(2 * b);
    });
    for (std::size_t stratum = 0; stratum < n; ++stratum) {
      const std::size_t i = order[stratum];
      out[i][k] =
          (static_cast<double>(stratum) + unit(table.word(2 * i + 1))) / static_cast<double>(n);
    }
  }
  return out;
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normal_quantile(double u) {
  constexpr std::array<double, 6> a{-3.969683028665376e+01, 2.209460984245205e+02,
                                    -2.759285104469687e+02, 1.383577518672690e+02,
                                    -3.066479806614716e+01, 2.506628277459239e+00};
  constexpr std::array<double, 5> b{-5.447609879822406e+01, 1.615858368580409e+02,
                                    -1.556989798598866e+02, 6.680131188771972e+01,
                                    -1.328068155288572e+01};
  constexpr std::array<double, 6> c{-7.784894002430293e-03, -3.223964580411365e-01,
                                    -2.400758277161838e+00, -2.549732539343734e+00,
                                    4.374664141464968e+00,  2.938163982698783e+00};
  constexpr std::array<double, 4> d{7.784695709041462e-03, 3.224671290700398e-01,
                                    2.445134137142996e+00, 3.754408661907416e+00};
  constexpr double kTail = 0.02425;
  const auto tail = [&](double q) {
    return (((((c[0] * q + c[1]) * q + c[2]) * q + c[3]) * q + c[4]) * q + c[5]) /
           ((((d[0] * q + d[1]) * q + d[2]) * q + d[3]) * q + 1.0);
  };
  double z = 0.0;
  if (u < kTail) {
    z = tail(std::sqrt(-2.0 * std::log(u)));
  } else if (u > 1.0 - kTail) {
    z = -tail(std::sqrt(-2.0 * std::log1p(-u)));
  } else {
    const double q = u - 0.5, r = q * q;
    z = (((((a[0] * r + a[1]) * r + a[2]) * r + a[3]) * r + a[4]) * r + a[5]) * q /
        (((((b[0] * r + b[1]) * r + b[2]) * r + b[3]) * r + b[4]) * r + 1.0);
  }
  const double e = normal_cdf(z) - u;
  const double step = e * std::sqrt(2.0 * std::numbers::pi) * std::exp(0.5 * z * z);
  return z - step / (1.0 + 0.5 * z * step);
}

bool factorize_correlation(const Eigen::MatrixXd& correlation, Eigen::MatrixXd& factor) {
  constexpr double kZeroVariance = 1e-10;
  const Eigen::Index n = correlation.rows();
  factor = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    double square = correlation(j, j);
    for (Eigen::Index k = 0; k < j; ++k) square -= factor(j, k) * factor(j, k);
    if (square < -kZeroVariance) return false;
    const double root = square > kZeroVariance ? std::sqrt(square) : 0.0;
    factor(j, j) = root;
    for (Eigen::Index i = j + 1; i < n; ++i) {
      double left = correlation(i, j);
      for (Eigen::Index k = 0; k < j; ++k) left -= factor(i, k) * factor(j, k);
      if (root == 0.0) {
        // Row j depends on those before it, so this must too.
        constexpr double kMaxMismatch = 1e-8;
        if (std::abs(left) > kMaxMismatch) return false;
        continue;
      }
      factor(i, j) = left / root;
    }
  }
  return true;
}

}  // namespace adore::studies
