#include "base/sine_cosine.hpp"

#include <cmath>

#ifndef ADORE_CLONES  // core/CMakeLists.txt
#define ADORE_CLONES
#endif

namespace adore {
namespace {

constexpr double kLargest = 1e6;
// π/2, most significant part first.
constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34,
                 kThird = 0x1.3198a2e037073p-69;
constexpr double kTwoOverPi = 0.63661977236758134308;
constexpr double kToInteger = 6755399441055744.0;  ///< 1.5 * 2^52: adding it rounds

ADORE_CLONES
bool all_moderate(const double* angle, int n) noexcept {
  int large = 0;
  for (int i = 0; i < n; ++i) large += !(std::abs(angle[i]) < kLargest);
  return large == 0;
}

ADORE_CLONES
void reduced(const double* angle, int n, double* sine, double* cosine) noexcept {
#pragma GCC ivdep  // sines and cosines are not the angles
  for (int i = 0; i < n; ++i) {
    const double k = (angle[i] * kTwoOverPi + kToInteger) - kToInteger;
    const double r = ((angle[i] - k * kFirst) - k * kSecond) - k * kThird;
    // k mod 4 as two signs and one exchange, in numbers: half = k/2 to even.
    const double half = (0.5 * k - 0.25 + kToInteger) - kToInteger;  // floor(k/2)
    const double odd = k - 2.0 * half;                               // 0 or 1
    const double quarter = (0.5 * half - 0.25 + kToInteger) - kToInteger;
    const double turned = half - 2.0 * quarter;  // 0 or 1: half revolutions
    const double z = r * r;
    const double s =
        r + r * z *
                (-1.0 / 6.0 +
                 z * (1.0 / 120.0 +
                      z * (-1.0 / 5040.0 + z * (1.0 / 362880.0 +
                                                z * (-1.0 / 39916800.0 +
                                                     z * (1.0 / 6227020800.0 +
                                                          z * (-1.0 / 1307674368000.0 +
                                                               z * (1.0 / 355687428096000.0))))))));
    const double c =
        1.0 -
        (0.5 * z -
         z * z *
             (1.0 / 24.0 +
              z * (-1.0 / 720.0 +
                   z * (1.0 / 40320.0 + z * (-1.0 / 3628800.0 +
                                             z * (1.0 / 479001600.0 +
                                                  z * (-1.0 / 87178291200.0 +
                                                       z * (1.0 / 20922789888000.0 -
                                                            z * (1.0 / 6402373705728000.0)))))))));
    const double sign = 1.0 - 2.0 * turned;
    const double even = 1.0 - odd;
    sine[i] = sign * (even * s + odd * c);  // one of both: a choice would be a branch with AVX2
    cosine[i] = sign * (even * c - odd * s);
  }
}

}  // namespace

void sines_and_cosines(const double* angle, int n, double* sine, double* cosine) noexcept {
  if (all_moderate(angle, n)) {
    reduced(angle, n, sine, cosine);
    return;
  }
  for (int i = 0; i < n; ++i) {
    sine[i] = std::sin(angle[i]);
    cosine[i] = std::cos(angle[i]);
  }
}

}  // namespace adore
