#include "results/decimal_digits.hpp"

#include <array>
#include <bit>

namespace adore::results {
namespace {

__extension__ using Wide = unsigned __int128;

/// 10^k as mantissa × 2^exponent, mantissa in [2^63, 2^64), off by less than 2^-54 of itself: each
/// of up to 350 steps from 10^0 cuts off less than 2^-63.
struct Power {
  std::uint64_t mantissa = 0;
  int exponent = 0;
};

constexpr int kLowest = -300, kHighest = 320;

constexpr Power normalised(Wide mantissa, int exponent) {
  while (mantissa >> 64U != 0) {
    mantissa >>= 1U;
    ++exponent;
  }
  while ((mantissa >> 63U) == 0) {
    mantissa <<= 1U;
    --exponent;
  }
  return {static_cast<std::uint64_t>(mantissa), exponent};
}

constexpr auto kPowers = [] {
  std::array<Power, kHighest - kLowest + 1> out{};
  out[-kLowest] = normalised(1, 0);
  for (int k = 1; k <= kHighest; ++k) {
    const Power& last = out[k - 1 - kLowest];
    out[k - kLowest] = normalised(Wide{last.mantissa} * 10U, last.exponent);
  }
  for (int k = -1; k >= kLowest; --k) {
    const Power& last = out[k + 1 - kLowest];
    out[k - kLowest] = normalised((Wide{last.mantissa} << 32U) / 10U, last.exponent - 32);
  }
  return out;
}();

constexpr std::array<std::uint32_t, 10> kTens{1,      10,      100,      1000,      10000,
                                              100000, 1000000, 10000000, 100000000, 1000000000};

}  // namespace

bool decimal_digits(double value, int count, DecimalDigits& out) noexcept {
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52U) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>(bits >> 52U);
  const std::uint64_t mantissa = ((bits & kFraction) | (kFraction + 1)) << 11U;
  const int exponent = biased - 1075 - 11;  // value = mantissa × 2^exponent
  // log10 of value from below, by no more than one: 2^(exponent + 63) <= value; 1233/4096 = lg 2.
  int power = ((exponent + 63) * 1233) >> 12;
  const auto most = static_cast<std::size_t>(count);
  for (int attempt = 0; attempt < 3; ++attempt) {
    const int k = count - 1 - power;
    if (k < kLowest || k > kHighest) return false;
    const Power& scale = kPowers[static_cast<std::size_t>(k - kLowest)];
    const Wide product = Wide{mantissa} * scale.mantissa;
    const int down = -(exponent + scale.exponent);  // product / 2^down
    if (down < 66 || down > 127) return false;
    const auto whole = static_cast<std::uint64_t>(product >> static_cast<unsigned>(down));
    if (whole >= kTens[most]) {
      ++power;
      continue;
    }
    if (whole < kTens[most - 1]) {
      --power;
      continue;
    }
    const auto part =  // in units of 2^-32
        static_cast<std::uint64_t>(product >> static_cast<unsigned>(down - 32)) & 0xffffffffU;
    constexpr std::uint64_t kHalf = 0x80000000U, kUnsure = 1U << 12U;
    if (part + kUnsure >= kHalf && part <= kHalf + kUnsure) return false;
    out.digits = static_cast<std::uint32_t>(whole + (part > kHalf ? 1 : 0));
    out.exponent = power;
    if (out.digits == kTens[most]) {
      out.digits = kTens[most - 1];
      ++out.exponent;
    }
    return true;
  }
  return false;
}

}  // namespace adore::results
