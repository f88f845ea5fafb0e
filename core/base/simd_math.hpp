#pragma once

#include "base/scalar_lanes.hpp"
#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"

#include <bit>
#include <cstdint>
#include <experimental/simd>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

/// Vector arithmetic of kernels: the widest vector of doubles that the including translation unit
/// is compiled for. Each instruction set has a separate vector type, hence a separate version of
/// every template over it; all other functions have internal linkage.
namespace adore {

namespace stdx = std::experimental;

namespace {
using SimdReal = stdx::native_simd<double>;
}

/// ScalarMath of a vector of doubles.
template <class V>
struct SimdMath {
  using Mask = typename V::mask_type;
  using Bits = stdx::rebind_simd_t<std::int64_t, V>;

  /// 1/sqrt(x) to about 1 ulp for 1e-30 <= x <= 1e30. From an estimate y of 12 (14) bits with the
  /// residual e = 1 - x y²: 1/sqrt(x) = y (1-e)^(-1/2) = y (1 + e/2 + 3e²/8 + 5e³/16 + 35e⁴/128 +
  /// ...); the first neglected term is below 2^-53 (of 14 bits: one less). A hardware square root
  /// and division cost three to eight times as much.
  [[gnu::always_inline]] static V inverse_sqrt(V x) {
#if defined(__AVX512F__)
    const V y(_mm512_rsqrt14_pd(static_cast<__m512d>(x)));
#elif defined(__AVX2__)
    const V y(_mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(static_cast<__m256d>(x)))));
#else
    return 1.0 / stdx::sqrt(x);
#endif
#if defined(__AVX2__)
    const V e = 1.0 - (x * y) * y;
#if defined(__AVX512F__)
    const V series = 0.5 + e * (0.375 + e * 0.3125);
#else
    const V series = 0.5 + e * (0.375 + e * (0.3125 + e * 0.2734375));
#endif
    return y + (e * y) * series;
#endif
  }

  /// exp(x) to about 1e-15 relative for |x| <= 708, clamped outside. x = k ln2 + r, |r| <= ln2/2,
  /// Taylor polynomial of degree 13 (remainder 4e-18); 2^k by adding k to the exponent bits.
  [[gnu::always_inline]] static V exp(V x) {
    constexpr double kShift = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
    x = stdx::min(stdx::max(x, V(-708.0)), V(708.0));
    const V shifted = x * 1.4426950408889634 + kShift;
    const V k = shifted - kShift;
    const V r = (x - k * 0.693145751953125) - k * 1.42860682030941723212e-6;  // ln2 in two parts
    V p = 1.0 / 6227020800.0;
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r + 1.0;
    p = p * r + 1.0;
    const Bits exponent = std::bit_cast<Bits>(shifted) << 52;  // the low bits of `shifted` hold k
    return std::bit_cast<V>(std::bit_cast<Bits>(p) + exponent);
  }

  /// ln(x) to about 1e-15 absolute for normal x > 0. x = 2^k m, m between √½ and √2: 2 atanh(z), z
  /// = (m-1)/(m+1), |z| <= 0.172, its series to z^19 (remainder 2e-17).
  [[gnu::always_inline]] static V log(V x) {
    const Bits bits = std::bit_cast<Bits>(x);
    const Bits k = (bits - 0x3fe6a09e667f3bcdLL) >> 52;  // of √½: rounds to the nearer power of 2
    const V m = std::bit_cast<V>(bits - (k << 52));
    const V over = inverse_sqrt(m + 1.0);
    const V z = (m - 1.0) * (over * over), z2 = z * z;
    V p = 1.0 / 19.0;
    p = p * z2 + 1.0 / 17.0;
    p = p * z2 + 1.0 / 15.0;
    p = p * z2 + 1.0 / 13.0;
    p = p * z2 + 1.0 / 11.0;
    p = p * z2 + 1.0 / 9.0;
    p = p * z2 + 1.0 / 7.0;
    p = p * z2 + 1.0 / 5.0;
    p = p * z2 + 1.0 / 3.0;
    p = p * z2 + 1.0;
    return stdx::static_simd_cast<V>(k) * 0.6931471805599453 + 2.0 * z * p;
  }

  [[gnu::always_inline]] static V sqrt(V x) { return stdx::sqrt(x); }
  [[gnu::always_inline]] static V root(V x) { return x * inverse_sqrt(stdx::max(x, V(1e-30))); }
  [[gnu::always_inline]] static V sqrt_and_inverse(V x, V& inverse) {
    inverse = inverse_sqrt(x);
    return x * inverse;
  }
  [[gnu::always_inline]] static V over(V a, V, V inverse) { return a * inverse; }
  [[gnu::always_inline]] static V min(V a, V b) { return stdx::min(a, b); }
  [[gnu::always_inline]] static V max(V a, V b) { return stdx::max(a, b); }
  [[gnu::always_inline]] static V pick(const Mask& condition, V a, V b) {
    stdx::where(condition, b) = a;
    return b;
  }
  [[gnu::always_inline]] static bool any(const Mask& condition) { return stdx::any_of(condition); }
  [[gnu::always_inline]] static V abs(V x) { return stdx::abs(x); }
  [[gnu::always_inline]] static V copysign(V size, V sign) { return stdx::copysign(size, sign); }

  /// x^(1/9) to a few ulp, 0 for x < 1e-300. The bits of a double are nearly its logarithm: a ninth
  /// of them is right to 7 %; three steps of Halley's cubic iteration on y⁹ = x follow (error e ->
  /// 7 e³).
  [[gnu::always_inline]] static V ninth_root(V x) {
    constexpr double kBias = 4607182418800017408.0;  // bits of 1.0, and 2^52 a binary order
    const V safe = stdx::max(x, V(1e-300));
    const V log2_bits = stdx::static_simd_cast<V>(std::bit_cast<Bits>(safe)) - kBias;
    const Bits guess = stdx::static_simd_cast<Bits>(log2_bits / 9.0 + kBias);
    V y = std::bit_cast<V>(guess);
    for (int step = 0; step < 3; ++step) {
      const V y2 = y * y, y4 = y2 * y2, y9 = y4 * y4 * y;
      y = y * (4.0 * y9 + 5.0 * safe) / (5.0 * y9 + 4.0 * safe);
    }
    return pick(x < 1e-300, V(0.0), y);
  }
};

template <class Abi>
struct ScalarLog<stdx::simd<double, Abi>> {
  using V = stdx::simd<double, Abi>;
  [[gnu::always_inline]] static V log(V x) { return SimdMath<V>::log(x); }
};

template <class Abi>
struct ScalarLanes<stdx::simd<double, Abi>> {
  using V = stdx::simd<double, Abi>;
  static constexpr int kCount = static_cast<int>(V::size());
  [[gnu::always_inline]] static double get(const V& x, int lane) {
    return x[static_cast<std::size_t>(lane)];
  }
  [[gnu::always_inline]] static V from(const double* values) {
    return V(values, stdx::element_aligned);
  }
  [[gnu::always_inline]] static void put(const V& x, double* values) {
    x.copy_to(values, stdx::element_aligned);
  }
  [[gnu::always_inline]] static V floor(V x) { return stdx::floor(x); }
  [[gnu::always_inline]] static V gather(const double* table, V place) {
#if defined(__AVX512F__)
    return V(_mm512_i32gather_pd(_mm512_cvttpd_epi32(static_cast<__m512d>(place)), table, 8));
#else
    // AVX2's own gather is no faster than four loads, and GCC 12 takes what it starts from for a
    // value that is used.
    return V([&](auto lane) { return table[static_cast<int>(static_cast<double>(place[lane]))]; });
#endif
  }
  /// One lane after the other takes its four lines, four neighbors at once: a gather of eight
  /// lanes takes as long as eight such loads, or twice as long, and brings a quarter (decision
  /// 328).
  [[gnu::always_inline]] static V patch(const double* table, int line, const V& place,
                                        const V* along, const V* across) {
    using Four = double __attribute__((vector_size(4 * sizeof(double))));
    double first[kCount], weight[4][kCount];
    put(place, first);
    for (int i = 0; i < 4; ++i) put(along[i], weight[i]);
    Four of_lane[kCount];
    for (int l = 0; l < kCount; ++l) {
      const double* from_here = table + static_cast<int>(first[l]);
      Four one;
      __builtin_memcpy(&one, from_here, sizeof one);
      of_lane[l] = weight[0][l] * one;
      for (int i = 1; i < 4; ++i) {
        __builtin_memcpy(&one, from_here + i * line, sizeof one);
        of_lane[l] += weight[i][l] * one;
      }
    }
#if defined(__AVX512F__)
    const auto both = [&](int l) __attribute__((always_inline)) {
      return _mm512_insertf64x4(_mm512_castpd256_pd512((__m256d)of_lane[l]),
                                (__m256d)of_lane[l + 4], 1);
    };
    const __m512d a = both(0), b = both(1), c = both(2), d = both(3);  // lanes l and l + 4
    const __m512d ab = _mm512_unpacklo_pd(a, b), ab1 = _mm512_unpackhi_pd(a, b),
                  cd = _mm512_unpacklo_pd(c, d), cd1 = _mm512_unpackhi_pd(c, d);
    const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                  high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    return across[0] * V(_mm512_permutex2var_pd(ab, low, cd)) +
           across[1] * V(_mm512_permutex2var_pd(ab1, low, cd1)) +
           across[2] * V(_mm512_permutex2var_pd(ab, high, cd)) +
           across[3] * V(_mm512_permutex2var_pd(ab1, high, cd1));
#else
    double sum[4][kCount];
    for (int l = 0; l < kCount; ++l)
      for (int j = 0; j < 4; ++j) sum[j][l] = of_lane[l][j];
    return across[0] * from(sum[0]) + across[1] * from(sum[1]) + across[2] * from(sum[2]) +
           across[3] * from(sum[3]);
#endif
  }
};

template <class Abi>
struct ScalarMath<stdx::simd<double, Abi>> : SimdMath<stdx::simd<double, Abi>> {};

}  // namespace adore
