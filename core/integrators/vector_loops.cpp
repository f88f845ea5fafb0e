#include "integrators/step_tools.hpp"

#include <algorithm>
#include <cmath>

#ifndef ADORE_CLONES  // core/CMakeLists.txt
#define ADORE_CLONES
#endif

/// The loops over whole states that every step makes, by instruction set.
namespace adore::integrators {

namespace {

/// `kWidth` values from place i on: several sums that do not wait for each other.
template <int kWidth>
[[gnu::always_inline]] inline void combine_block(double* out, const double* base,
                                                 const double* factor, const double* const* used,
                                                 int terms, int i) noexcept {
  double sum[kWidth] = {};
  for (int j = 0; j < terms; ++j) {
    const double* v = used[j] + i;
    for (int k = 0; k < kWidth; ++k) sum[k] += factor[j] * v[k];
  }
  if (base) {
    for (int k = 0; k < kWidth; ++k) out[i + k] = base[i + k] + sum[k];
  } else {
    for (int k = 0; k < kWidth; ++k) out[i + k] = sum[k];
  }
}

}  // namespace

ADORE_CLONES
void combine(double* out, const double* base, double h, const double* weights,
             const double* const* vectors, int count, int n_padded) noexcept {
  const double* used[16];
  double factor[16];
  int terms = 0;
  for (int j = 0; j < count; ++j) {
    if (weights[j] != 0.0) {
      used[terms] = vectors[j];
      factor[terms++] = h * weights[j];
    }
  }
  int i = 0;
  for (; i + 4 * kBlock <= n_padded; i += 4 * kBlock)
    combine_block<4 * kBlock>(out, base, factor, used, terms, i);
  for (; i < n_padded; i += kBlock) combine_block<kBlock>(out, base, factor, used, terms, i);
}

ADORE_CLONES
void add_quadrature_error_estimate(double* error, double h, const double* weights,
                                   const double* const* rates, int stages, int n_padded) noexcept {
  constexpr double kRounding = 1e-8;
  constexpr double kRough = 0.05;
  for (int i = 0; i < n_padded; i += kBlock) {
    double sum[kBlock] = {};
    double terms[kBlock] = {};
    const double* first = rates[0] + i;
    for (int s = 1; s < stages; ++s) {
      const double weight = weights[s];
      if (weight == 0.0) continue;
      const double* rate = rates[s] + i;
      for (int k = 0; k < kBlock; ++k) {
        const double term = weight * (rate[k] - first[k]);
        sum[k] += term;
        terms[k] += std::abs(term);
      }
    }
    for (int k = 0; k < kBlock; ++k) {
      const double opinion = h * std::abs(sum[k]);
      const double pair = std::abs(error[i + k]);
      const bool blind = (pair < kRounding * opinion) | (std::abs(sum[k]) > kRough * terms[k]);
      error[i + k] = (opinion > pair) & blind ? opinion : error[i + k];
    }
  }
}

ADORE_CLONES
double weighted_maximum(const double* values, const double* weights, int n) noexcept {
  double worst[kBlock] = {};
  int i = 0;
  for (; i + kBlock <= n; i += kBlock) {
    for (int k = 0; k < kBlock; ++k) {
      const double e = std::abs(values[i + k]) * weights[i + k];
      worst[k] = e > worst[k] ? e : worst[k];
    }
  }
  for (; i < n; ++i) worst[0] = std::max(worst[0], std::abs(values[i]) * weights[i]);
  return *std::max_element(worst, worst + kBlock);
}

ADORE_CLONES
bool all_finite(const double* values, int n) noexcept {
  double sum[kBlock] = {};  // 0 * x is 0 for every finite x and NaN otherwise
  int i = 0;
  for (; i + kBlock <= n; i += kBlock) {
    for (int k = 0; k < kBlock; ++k) sum[k] += 0.0 * values[i + k];
  }
  for (; i < n; ++i) sum[0] += 0.0 * values[i];
  return std::all_of(sum, sum + kBlock, [](double s) { return s == 0.0; });
}

}  // namespace adore::integrators
