#pragma once

#include "base/inverse_roots.hpp"
#include "base/simd_math.hpp"

namespace adore {

/// From estimates of 14 bits, as in simd_math.hpp, to about 1 ulp: (1-e)^(-1/4) = 1 + e/4 + 5e²/32
/// + 15e³/128 + 195e⁴/2048 + ... with |e| below 2^-11, and 1/(1-e) = 1 + e + e² + e³ + ... with
/// 2^-14.
template <class Abi>
struct InverseRoots<stdx::simd<double, Abi>> {
  using V = stdx::simd<double, Abi>;
  [[gnu::always_inline]] static V fourth(V x) {
#if defined(__AVX512F__)
    const V r(_mm512_rsqrt14_pd(static_cast<__m512d>(x)));
    const V y = r * V(_mm512_rsqrt14_pd(static_cast<__m512d>(r)));
    const V y2 = y * y, e = 1.0 - (x * y2) * y2;
    return y + (e * y) * (0.25 + e * (0.15625 + e * (0.1171875 + e * 0.09521484375)));
#else
    return SimdMath<V>::root(SimdMath<V>::inverse_sqrt(x));
#endif
  }
  [[gnu::always_inline]] static V first(V x) {
#if defined(__AVX512F__)
    const V y(_mm512_rcp14_pd(static_cast<__m512d>(x)));
    const V e = 1.0 - x * y;
    return y + (e * y) * (1.0 + e * (1.0 + e));
#else
    return 1.0 / x;
#endif
  }
};

}  // namespace adore
