#pragma once

#include "base/scalar_log.hpp"
#include "base/scalar_math.hpp"

#include <type_traits>

/// Single precision for what ScalarMath<T> calculates with: of vectors in base/simd_single.hpp, of
/// numbers none. Seen by the race kernels.
namespace adore {

/// Type: of twice as many numbers, with pack(a, b), both(a) and unpack(x, a, b); void: there is
/// none.
template <class T>
struct SinglePrecisionOf {
  using Type = void;
};
template <class T>
inline constexpr bool kHasSingle = !std::is_void_v<typename SinglePrecisionOf<T>::Type>;

/// Is T of single precision?
template <class T>
struct IsSinglePrecision : std::false_type {};

/// at(tiles, place, f, g): Σ c[4 i + j] f^i g^j, i, j = 0 ... 3, of the 16 floats c of tile
/// `place`.
template <class T>
struct ScalarTiles;

/// asinh(S), S >= 0, from S², √(1 + S²) and its inverse.
template <class T>
struct ScalarAsinh {
  [[gnu::always_inline]] static T of(const T& S, const T& S2, const T& root, const T&) {
    // Its series below 1e-3, which the logarithm would round away.
    const T series = S * (1.0 - S2 * (1.0 / 6.0 - S2 * 0.075));
    return ScalarMath<T>::pick(S < 1e-3, series, ScalarLog<T>::log(S + root));
  }
};

}  // namespace adore
