#pragma once

#include "base/simd_inverse_roots.hpp"
#include "base/simd_math.hpp"
#include "base/single.hpp"

/// Two vectors of doubles as one of floats: with it a law of traction takes twice as many points at
/// once (laws/film_law_of.hpp). Functions are right to some 1e-7. The range is that of floats,
/// 1e-37 to 3e38, squares included. Of an estimate of 12 (14) bits one step, as in simd_math.hpp.
namespace adore {

/// @param V the vector of doubles of the kernel, so that each instruction set has a separate type
template <class V>
struct SimdSinglePrecision {
  using F = stdx::rebind_simd_t<float, stdx::resize_simd_t<2 * V::size(), V>>;
  using Mask = typename F::mask_type;
  F v;

  SimdSinglePrecision() = default;
  [[gnu::always_inline]] SimdSinglePrecision(double value)
      : v(static_cast<float>(value)) {}  // NOLINT
  [[gnu::always_inline]] explicit SimdSinglePrecision(const F& from) : v(from) {}

  [[gnu::always_inline]] friend SimdSinglePrecision operator+(const SimdSinglePrecision& a,
                                                              const SimdSinglePrecision& b) {
    return SimdSinglePrecision(F(a.v + b.v));
  }
  [[gnu::always_inline]] friend SimdSinglePrecision operator-(const SimdSinglePrecision& a,
                                                              const SimdSinglePrecision& b) {
    return SimdSinglePrecision(F(a.v - b.v));
  }
  [[gnu::always_inline]] friend SimdSinglePrecision operator*(const SimdSinglePrecision& a,
                                                              const SimdSinglePrecision& b) {
    return SimdSinglePrecision(F(a.v * b.v));
  }
  [[gnu::always_inline]] friend SimdSinglePrecision operator/(const SimdSinglePrecision& a,
                                                              const SimdSinglePrecision& b) {
    return SimdSinglePrecision(F(a.v / b.v));
  }
  [[gnu::always_inline]] friend SimdSinglePrecision operator-(const SimdSinglePrecision& a) {
    return SimdSinglePrecision(F(-a.v));
  }
  [[gnu::always_inline]] friend Mask operator<(const SimdSinglePrecision& a,
                                               const SimdSinglePrecision& b) {
    return a.v < b.v;
  }
  [[gnu::always_inline]] friend Mask operator>(const SimdSinglePrecision& a,
                                               const SimdSinglePrecision& b) {
    return a.v > b.v;
  }
};

template <class V>
struct ScalarMath<SimdSinglePrecision<V>> {
  using T = SimdSinglePrecision<V>;
  using F = typename T::F;
  using Mask = typename T::Mask;
  using Bits = stdx::rebind_simd_t<std::int32_t, F>;

  /// 1/√x
  [[gnu::always_inline]] static T inverse_sqrt(const T& x) {
#if defined(__AVX512F__)
    const F y(_mm512_rsqrt14_ps(static_cast<__m512>(x.v)));
    const F e = 1.0F - (x.v * y) * y;
    return T(F(y + (e * y) * 0.5F));
#elif defined(__AVX2__)
    const F y(_mm256_rsqrt_ps(static_cast<__m256>(x.v)));
    const F e = 1.0F - (x.v * y) * y;
    return T(F(y + (e * y) * (0.5F + 0.375F * e)));
#else
    return T(F(1.0F / stdx::sqrt(x.v)));
#endif
  }
  [[gnu::always_inline]] static T sqrt_and_inverse(const T& x, T& inverse) {
    inverse = inverse_sqrt(x);
    return x * inverse;
  }
  /// |x| <= 87, clamped outside; as SimdMath::exp, with a polynomial of degree 6.
  [[gnu::always_inline]] static T exp(const T& from) {
    constexpr float kShift = 12582912.0F;  // 1.5 * 2^23
    const F x = stdx::min(stdx::max(from.v, F(-87.0F)), F(87.0F));
    const F shifted = x * 1.44269504F + kShift;
    const F k = shifted - kShift;
    const F r = (x - k * 0.693359375F) - k * -2.12194440e-4F;
    F p(1.0F / 720.0F);
    p = p * r + 1.0F / 120.0F;
    p = p * r + 1.0F / 24.0F;
    p = p * r + 1.0F / 6.0F;
    p = p * r + 0.5F;
    p = p * r + 1.0F;
    p = p * r + 1.0F;
    return T(std::bit_cast<F>(Bits(std::bit_cast<Bits>(p) + (std::bit_cast<Bits>(shifted) << 23))));
  }
  /// x = 2^k m: k, and z = (m-1)/(m+1), |z| <= 0.172.
  [[gnu::always_inline]] static F log_parts(const F& x, F& k) {
    const Bits bits = std::bit_cast<Bits>(x);
    const Bits exponent = (bits - 0x3f3504f3) >> 23;
    const F m = std::bit_cast<F>(Bits(bits - (exponent << 23)));
    k = stdx::static_simd_cast<F>(exponent);
    return (m - 1.0F) * InverseRoots<T>::first(T(F(m + 1.0F))).v;
  }
  /// atanh(z)/z, |z| <= 0.25.
  [[gnu::always_inline]] static F atanh_over_argument(const F& z) {
    const F z2 = z * z;
    F p(1.0F / 9.0F);
    p = p * z2 + 1.0F / 7.0F;
    p = p * z2 + 1.0F / 5.0F;
    p = p * z2 + 1.0F / 3.0F;
    return p * z2 + 1.0F;
  }
  /// 1e-7 absolute, and the rounding of the result.
  [[gnu::always_inline]] static T log(const T& x) {
    F k;
    const F z = log_parts(x.v, k);
    return T(F(k * 0.693147181F + 2.0F * z * atanh_over_argument(z)));
  }
  [[gnu::always_inline]] static T abs(const T& x) { return T(F(stdx::abs(x.v))); }
  [[gnu::always_inline]] static T min(const T& a, const T& b) { return T(F(stdx::min(a.v, b.v))); }
  [[gnu::always_inline]] static T max(const T& a, const T& b) { return T(F(stdx::max(a.v, b.v))); }
  [[gnu::always_inline]] static T pick(const Mask& condition, const T& a, const T& b) {
    F out = b.v;
    stdx::where(condition, out) = a.v;
    return T(out);
  }
  [[gnu::always_inline]] static bool any(const Mask& condition) { return stdx::any_of(condition); }
};
template <class V>
struct ScalarLog<SimdSinglePrecision<V>> {
  [[gnu::always_inline]] static SimdSinglePrecision<V> log(const SimdSinglePrecision<V>& x) {
    return ScalarMath<SimdSinglePrecision<V>>::log(x);
  }
};

template <class V>
struct InverseRoots<SimdSinglePrecision<V>> {
  using T = SimdSinglePrecision<V>;
  using F = typename T::F;
  [[gnu::always_inline]] static T first(const T& x) {
#if defined(__AVX512F__)
    const F y(_mm512_rcp14_ps(static_cast<__m512>(x.v)));
    return T(F(y + y * (1.0F - x.v * y)));
#elif defined(__AVX2__)
    const F y(_mm256_rcp_ps(static_cast<__m256>(x.v)));
    return T(F(y + y * (1.0F - x.v * y)));
#else
    return T(F(1.0F / x.v));
#endif
  }
  [[gnu::always_inline]] static T fourth(const T& x) {
#if defined(__AVX512F__)
    const F r(_mm512_rsqrt14_ps(static_cast<__m512>(x.v)));
    const F y = r * F(_mm512_rsqrt14_ps(static_cast<__m512>(r)));
    const F y2 = y * y, e = 1.0F - (x.v * y2) * y2;
    return T(F(y + (e * y) * (0.25F + e * 0.15625F)));
#elif defined(__AVX2__)
    const F r(_mm256_rsqrt_ps(static_cast<__m256>(x.v)));
    const F y = r * F(_mm256_rsqrt_ps(static_cast<__m256>(r)));
    const F y2 = y * y, e = 1.0F - (x.v * y2) * y2;
    return T(F(y + (e * y) * (0.25F + e * 0.15625F)));
#else
    return T(F(1.0F / stdx::sqrt(stdx::sqrt(x.v))));
#endif
  }
};

/// ln(S + √(1 + S²)); below S = 0.25, where that loses digits, atanh(S/√(1 + S²)) by the same
/// series.
template <class V>
struct ScalarAsinh<SimdSinglePrecision<V>> {
  using T = SimdSinglePrecision<V>;
  using F = typename T::F;
  [[gnu::always_inline]] static T of(const T& S, const T&, const T& root, const T& inverse) {
    F k;
    F z = 2.0F * ScalarMath<T>::log_parts(S.v + root.v, k);  // twice z
    F at = 0.5F * z;
    const auto small = S.v < 0.25F;
    const F q = S.v * inverse.v;
    stdx::where(small, z) = q;
    stdx::where(small, at) = q;
    stdx::where(small, k) = 0.0F;
    return T(F(k * 0.693147181F + z * ScalarMath<T>::atanh_over_argument(at)));
  }
};

template <class V>
struct ScalarLanes<SimdSinglePrecision<V>> {
  using T = SimdSinglePrecision<V>;
  [[gnu::always_inline]] static T floor(const T& x) { return T(typename T::F(stdx::floor(x.v))); }
};

template <class V>
struct IsSinglePrecision<SimdSinglePrecision<V>> : std::true_type {};

template <class Abi>
struct SinglePrecisionOf<stdx::simd<double, Abi>> {
  using V = stdx::simd<double, Abi>;
  using Type = SimdSinglePrecision<V>;
  using F = typename Type::F;
  [[gnu::always_inline]] static Type pack(const V& a, const V& b) {
#if defined(__AVX512F__)
    return Type(
        F(_mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(static_cast<__m512d>(a))),
                             _mm512_cvtpd_ps(static_cast<__m512d>(b)), 1)));
#elif defined(__AVX2__)
    return Type(F(_mm256_set_m128(_mm256_cvtpd_ps(static_cast<__m256d>(b)),
                                  _mm256_cvtpd_ps(static_cast<__m256d>(a)))));
#else
    return Type(stdx::static_simd_cast<F>(stdx::concat(a, b)));
#endif
  }
  [[gnu::always_inline]] static Type both(const V& a) { return pack(a, a); }
  [[gnu::always_inline]] static void unpack(const Type& x, V& a, V& b) {
#if defined(__AVX512F__)
    const auto f = static_cast<__m512>(x.v);
    a = V(_mm512_cvtps_pd(_mm512_castps512_ps256(f)));
    b = V(_mm512_cvtps_pd(_mm512_extractf32x8_ps(f, 1)));
#elif defined(__AVX2__)
    const auto f = static_cast<__m256>(x.v);
    a = V(_mm256_cvtps_pd(_mm256_castps256_ps128(f)));
    b = V(_mm256_cvtps_pd(_mm256_extractf128_ps(f, 1)));
#else
    for (std::size_t i = 0; i < V::size(); ++i) {
      a[i] = x.v[i];
      b[i] = x.v[i + V::size()];
    }
#endif
  }
};

}  // namespace adore
