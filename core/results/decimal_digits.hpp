#pragma once

#include <array>
#include <bit>
#include <cstdint>

/// The first significant decimal digits of a number: what fortran_format.cpp writes, without the
/// detour over a general printer. A stored step has some 430 of them.
namespace adore::results {

/// value = digits × 10^(exponent - count + 1), rounded to the nearest: digits has `count` of them.
struct DecimalDigits {
  std::uint32_t digits = 0;
  int exponent = 0;
};

/// 10^k as mantissa × 2^exponent, mantissa in [2^63, 2^64), off by less than 2^-54 of itself.
struct PowerOfTen {
  std::uint64_t mantissa = 0;
  int exponent = 0;
};
constexpr int kLowestPower = -300, kHighestPower = 320;
extern const std::array<PowerOfTen, kHighestPower - kLowestPower + 1> kPowersOfTen;

constexpr std::array<std::uint32_t, 10> kTens{1,      10,      100,      1000,      10000,
                                              100000, 1000000, 10000000, 100000000, 1000000000};

/// @param value > 0, finite, normal; count 1 to 9
/// @return false where 64 bits do not decide how to round (a tie, or within 2^-20 of one in the
/// last digit): ask a printer that carries all bits. Else the digits are those of such a printer.
[[nodiscard]] inline bool decimal_digits(double value, int count, DecimalDigits& out) noexcept {
  __extension__ using Wide = unsigned __int128;
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52U) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>(bits >> 52U);
  const std::uint64_t mantissa = ((bits & kFraction) | (kFraction + 1)) << 11U;
  const int exponent = biased - 1075 - 11;  // value = mantissa × 2^exponent
  // lg of value, hardly ever one too low: log2(1 + m) >= m, by 0.086 at most; 315652/2^20 = lg 2.
  const std::int64_t log2 = static_cast<std::int64_t>(bits >> 32U) - (std::int64_t{1023} << 20U);
  int power = static_cast<int>((log2 * 315652) >> 40);
  const auto most = static_cast<std::size_t>(count);
  for (int attempt = 0; attempt < 3; ++attempt) {
    const int k = count - 1 - power;
    if (k < kLowestPower || k > kHighestPower) return false;
    const PowerOfTen& scale = kPowersOfTen[static_cast<std::size_t>(k - kLowestPower)];
    const Wide product = Wide{mantissa} * scale.mantissa;
    const int down = -(exponent + scale.exponent);  // product / 2^down
    if (down < 66 || down > 127) return false;
    const auto high = static_cast<std::uint64_t>(product >> 64U);
    const std::uint64_t whole = high >> static_cast<unsigned>(down - 64);
    if (whole >= kTens[most]) {
      ++power;
      continue;
    }
    if (whole < kTens[most - 1]) {
      --power;
      continue;
    }
    // In units of 2^-32; smaller parts do not matter.
    const std::uint64_t part =
        (high << static_cast<unsigned>(128 - down) |
         static_cast<std::uint64_t>(product) >> static_cast<unsigned>(down - 64)) >>
        32U;
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
