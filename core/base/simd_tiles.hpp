#pragma once

#include "base/simd_single.hpp"

/// Look-ups in tables of tiles (single.hpp) by vectors of floats.
namespace adore {

template <class V>
struct ScalarTiles<SimdSingle<V>> {
  using T = SimdSingle<V>;
  using F = typename T::F;
  static constexpr int kLanes = static_cast<int>(F::size()), kTile = 16;

  [[gnu::always_inline]] static T at(const float* tiles, const T& place, const T& f, const T& g) {
#if defined(__AVX2__)
    alignas(sizeof(F)) int first[kLanes];
    places(place, first);
    const Raw along = static_cast<Raw>(f.v);
    const Raw r0 = group<0>(tiles, first, along), r1 = group<1>(tiles, first, along),
              r2 = group<2>(tiles, first, along), r3 = group<3>(tiles, first, along);
    const Raw low = unpack_low(r0, r1), low2 = unpack_low(r2, r3), high = unpack_high(r0, r1),
              high2 = unpack_high(r2, r3);
    const F c0(halves<0x44>(low, low2)), c1(halves<0xee>(low, low2)), c2(halves<0x44>(high, high2)),
        c3(halves<0xee>(high, high2));
    return T(F(((c3 * g.v + c2) * g.v + c1) * g.v + c0));
#else
    F out(0.0F);
    for (int l = 0; l < kLanes; ++l) {
      const float* c = tiles + kTile * static_cast<int>(place.v[l]);
      const float x = f.v[l], y = g.v[l];
      float sum = 0.0F;
      for (int i = 3; i >= 0; --i)
        sum = sum * x + (((c[4 * i + 3] * y + c[4 * i + 2]) * y + c[4 * i + 1]) * y + c[4 * i]);
      out[l] = sum;
    }
    return T(out);
#endif
  }

#if defined(__AVX2__)
 private:
  // Lanes q, q + 4, ... are taken together: each brings the four numbers of a power of f at once to
  // a quarter (half) of a register, where powers of f are summed; four such groups, turned within
  // the quarters, are the four powers of g of all lanes in their order.
#if defined(__AVX512F__)
  using Raw = __m512;
  [[gnu::always_inline]] static void places(const T& place, int* first) {
    _mm512_store_si512(first, _mm512_slli_epi32(_mm512_cvttps_epi32(static_cast<Raw>(place.v)), 4));
  }
  [[gnu::always_inline]] static Raw row(const float* a, const float* b, const float* c,
                                        const float* d) {
    Raw x = _mm512_castps128_ps512(_mm_loadu_ps(a));
    x = _mm512_mask_broadcast_f32x4(x, 0x00f0, _mm_loadu_ps(b));
    x = _mm512_mask_broadcast_f32x4(x, 0x0f00, _mm_loadu_ps(c));
    return _mm512_mask_broadcast_f32x4(x, 0xf000, _mm_loadu_ps(d));
  }
  template <int kGroup>
  [[gnu::always_inline]] static Raw group(const float* tiles, const int* first, Raw f) {
    const float *a = tiles + first[kGroup], *b = tiles + first[kGroup + 4],
                *c = tiles + first[kGroup + 8], *d = tiles + first[kGroup + 12];
    const Raw at = _mm512_permute_ps(f, 0x55 * kGroup);
    Raw sum = row(a + 12, b + 12, c + 12, d + 12);
    for (int i = 8; i >= 0; i -= 4) sum = _mm512_fmadd_ps(sum, at, row(a + i, b + i, c + i, d + i));
    return sum;
  }
  [[gnu::always_inline]] static Raw unpack_low(Raw a, Raw b) { return _mm512_unpacklo_ps(a, b); }
  [[gnu::always_inline]] static Raw unpack_high(Raw a, Raw b) { return _mm512_unpackhi_ps(a, b); }
  template <int kWhich>
  [[gnu::always_inline]] static Raw halves(Raw a, Raw b) {
    return _mm512_shuffle_ps(a, b, kWhich);
  }
#else
  using Raw = __m256;
  [[gnu::always_inline]] static void places(const T& place, int* first) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(first),
                       _mm256_slli_epi32(_mm256_cvttps_epi32(static_cast<Raw>(place.v)), 4));
  }
  [[gnu::always_inline]] static Raw row(const float* a, const float* b) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(a)), _mm_loadu_ps(b), 1);
  }
  template <int kGroup>
  [[gnu::always_inline]] static Raw group(const float* tiles, const int* first, Raw f) {
    const float *a = tiles + first[kGroup], *b = tiles + first[kGroup + 4];
    const Raw at = _mm256_permute_ps(f, 0x55 * kGroup);
    Raw sum = row(a + 12, b + 12);
    for (int i = 8; i >= 0; i -= 4) sum = _mm256_fmadd_ps(sum, at, row(a + i, b + i));
    return sum;
  }
  [[gnu::always_inline]] static Raw unpack_low(Raw a, Raw b) { return _mm256_unpacklo_ps(a, b); }
  [[gnu::always_inline]] static Raw unpack_high(Raw a, Raw b) { return _mm256_unpackhi_ps(a, b); }
  template <int kWhich>
  [[gnu::always_inline]] static Raw halves(Raw a, Raw b) {
    return _mm256_shuffle_ps(a, b, kWhich);
  }
#endif
#endif
};

}  // namespace adore
