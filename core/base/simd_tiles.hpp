#pragma once

#include "base/simd_single.hpp"

#include <cstdint>

/// Look-ups in tables of tiles (single.hpp) by vectors of floats.
namespace adore {

template <class V>
struct ScalarTiles<SimdSinglePrecision<V>> {
  using T = SimdSinglePrecision<V>;
  using F = typename T::F;
  static constexpr int kLanes = static_cast<int>(F::size()), kTile = 16;

  /// Of the polynomial of one tile.
  [[gnu::always_inline]] static T at(const float* tiles, const T& place, const T& f, const T& g) {
#if defined(__AVX2__)
    unsigned first[kLanes];
    tile_offsets(place, first);
    const Raw along = static_cast<Raw>(f.v);
    return horner_in_g(
        sum_tile_group<0>(tiles, first, along), sum_tile_group<1>(tiles, first, along),
        sum_tile_group<2>(tiles, first, along), sum_tile_group<3>(tiles, first, along), g);
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
  /// Of the mean of four tiles that follow each other, with weights.
  [[gnu::always_inline]] static T weighted_mean_at(const float* tiles, const T& place, const T& f,
                                                   const T& g, const T (&weight)[4]) {
#if defined(__AVX512F__)
    unsigned first[kLanes];
    tile_offsets(place, first);
    alignas(sizeof(F)) float share[4][kLanes];
#pragma GCC unroll 4
    for (int j = 0; j < 4; ++j) weight[j].v.copy_to(share[j], stdx::vector_aligned);
    const Raw along = static_cast<Raw>(f.v);
    return horner_in_g(sum_mean_tile_group<0>(tiles, first, share, along),
                       sum_mean_tile_group<1>(tiles, first, share, along),
                       sum_mean_tile_group<2>(tiles, first, share, along),
                       sum_mean_tile_group<3>(tiles, first, share, along), g);
#else
    T sum = weight[0] * at(tiles, place, f, g);
    for (int j = 1; j < 4; ++j) sum = sum + weight[j] * at(tiles + j * kTile, place, f, g);
    return sum;
#endif
  }

#if defined(__AVX2__)
 private:
  // Lanes q, q + 4, ... are taken together: each brings the four numbers of a power of f at once to
  // a quarter (half) of a register, where powers of f are summed; four such groups, turned within
  // the quarters, are the four powers of g of all lanes in their order.
#if defined(__AVX512F__)
  using Raw = __m512;
  /// In eighths of a register: taking lanes out one by one would keep the arithmetic ports busy.
  [[gnu::always_inline]] static void tile_offsets(const T& place, unsigned* first) {
    const __m512i all = _mm512_slli_epi32(_mm512_cvttps_epi32(static_cast<Raw>(place.v)), 4);
    extract_quarter_offsets<0>(all, first);
    extract_quarter_offsets<1>(all, first);
    extract_quarter_offsets<2>(all, first);
    extract_quarter_offsets<3>(all, first);
  }
  template <int kQuarter>
  [[gnu::always_inline]] static void extract_quarter_offsets(__m512i all, unsigned* first) {
    const __m128i quarter = _mm512_extracti32x4_epi32(all, kQuarter);
    const auto low = static_cast<std::uint64_t>(_mm_cvtsi128_si64(quarter)),
               high = static_cast<std::uint64_t>(_mm_extract_epi64(quarter, 1));
    first[4 * kQuarter] = static_cast<unsigned>(low);
    first[4 * kQuarter + 1] = static_cast<unsigned>(low >> 32);
    first[4 * kQuarter + 2] = static_cast<unsigned>(high);
    first[4 * kQuarter + 3] = static_cast<unsigned>(high >> 32);
  }
  /// ((r3 f + r2) f + r1) f + r0 from quarters r0 r1 | r0 r1 of lanes a b, c d, and r2 r3 likewise.
  [[gnu::always_inline]] static Raw horner_in_f(Raw ab, Raw cd, Raw ab2, Raw cd2, Raw f) {
    Raw sum = _mm512_shuffle_f32x4(ab2, cd2, 0xdd);
    sum = _mm512_fmadd_ps(sum, f, _mm512_shuffle_f32x4(ab2, cd2, 0x88));
    sum = _mm512_fmadd_ps(sum, f, _mm512_shuffle_f32x4(ab, cd, 0xdd));
    return _mm512_fmadd_ps(sum, f, _mm512_shuffle_f32x4(ab, cd, 0x88));
  }
  [[gnu::always_inline]] static Raw pair(const float* a, const float* b) {
    const Raw x = _mm512_castps256_ps512(_mm256_loadu_ps(a));
    return _mm512_mask_broadcast_f32x8(x, 0xff00, _mm256_loadu_ps(b));
  }
  template <int kGroup>
  [[gnu::always_inline]] static Raw sum_tile_group(const float* tiles, const unsigned* first,
                                                   Raw f) {
    const float *a = tiles + first[kGroup], *b = tiles + first[kGroup + 4],
                *c = tiles + first[kGroup + 8], *d = tiles + first[kGroup + 12];
    return horner_in_f(pair(a, b), pair(c, d), pair(a + 8, b + 8), pair(c + 8, d + 8),
                       _mm512_permute_ps(f, 0x55 * kGroup));
  }
  /// A whole tile fills a register: the mean of four is taken there.
  [[gnu::always_inline]] static Raw mean(const float* tiles, const float* share) {
    Raw sum = _mm512_set1_ps(share[0]) * _mm512_loadu_ps(tiles);
#pragma GCC unroll 4
    for (int j = 1; j < 4; ++j)
      sum = _mm512_fmadd_ps(_mm512_set1_ps(share[j * kLanes]), _mm512_loadu_ps(tiles + j * kTile),
                            sum);
    return sum;
  }
  template <int kGroup>
  [[gnu::always_inline]] static Raw sum_mean_tile_group(const float* tiles, const unsigned* first,
                                                        const float (&share)[4][kLanes], Raw f) {
    const Raw a = mean(tiles + first[kGroup], share[0] + kGroup),
              b = mean(tiles + first[kGroup + 4], share[0] + kGroup + 4),
              c = mean(tiles + first[kGroup + 8], share[0] + kGroup + 8),
              d = mean(tiles + first[kGroup + 12], share[0] + kGroup + 12);
    return horner_in_f(_mm512_shuffle_f32x4(a, b, 0x44), _mm512_shuffle_f32x4(c, d, 0x44),
                       _mm512_shuffle_f32x4(a, b, 0xee), _mm512_shuffle_f32x4(c, d, 0xee),
                       _mm512_permute_ps(f, 0x55 * kGroup));
  }
  [[gnu::always_inline]] static Raw unpack_low(Raw a, Raw b) { return _mm512_unpacklo_ps(a, b); }
  [[gnu::always_inline]] static Raw unpack_high(Raw a, Raw b) { return _mm512_unpackhi_ps(a, b); }
  template <int kWhich>
  [[gnu::always_inline]] static Raw shuffle_halves(Raw a, Raw b) {
    return _mm512_shuffle_ps(a, b, kWhich);
  }
#else
  using Raw = __m256;
  [[gnu::always_inline]] static void tile_offsets(const T& place, unsigned* first) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(first),
                        _mm256_slli_epi32(_mm256_cvttps_epi32(static_cast<Raw>(place.v)), 4));
  }
  [[gnu::always_inline]] static Raw row(const float* a, const float* b) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(a)), _mm_loadu_ps(b), 1);
  }
  template <int kGroup>
  [[gnu::always_inline]] static Raw sum_tile_group(const float* tiles, const unsigned* first,
                                                   Raw f) {
    const float *a = tiles + first[kGroup], *b = tiles + first[kGroup + 4];
    const Raw at = _mm256_permute_ps(f, 0x55 * kGroup);
    Raw sum = row(a + 12, b + 12);
#pragma GCC unroll 3
    for (int i = 8; i >= 0; i -= 4) sum = _mm256_fmadd_ps(sum, at, row(a + i, b + i));
    return sum;
  }
  [[gnu::always_inline]] static Raw unpack_low(Raw a, Raw b) { return _mm256_unpacklo_ps(a, b); }
  [[gnu::always_inline]] static Raw unpack_high(Raw a, Raw b) { return _mm256_unpackhi_ps(a, b); }
  template <int kWhich>
  [[gnu::always_inline]] static Raw shuffle_halves(Raw a, Raw b) {
    return _mm256_shuffle_ps(a, b, kWhich);
  }
#endif
  /// From the four groups.
  [[gnu::always_inline]] static T horner_in_g(Raw r0, Raw r1, Raw r2, Raw r3, const T& g) {
    const Raw low = unpack_low(r0, r1), low2 = unpack_low(r2, r3), high = unpack_high(r0, r1),
              high2 = unpack_high(r2, r3);
    const F c0(shuffle_halves<0x44>(low, low2)), c1(shuffle_halves<0xee>(low, low2)),
        c2(shuffle_halves<0x44>(high, high2)), c3(shuffle_halves<0xee>(high, high2));
    return T(F(((c3 * g.v + c2) * g.v + c1) * g.v + c0));
  }
#endif
};

}  // namespace adore
