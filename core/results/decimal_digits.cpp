#include "results/decimal_digits.hpp"

namespace adore::results {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr PowerOfTen normalised(Wide mantissa, int exponent) {
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

/// Each of up to 350 steps from 10^0 cuts off less than 2^-63.
constexpr auto kMade = [] {
  std::array<PowerOfTen, kHighestPower - kLowestPower + 1> out{};
  out[-kLowestPower] = normalised(1, 0);
  for (int k = 1; k <= kHighestPower; ++k) {
    const PowerOfTen& last = out[k - 1 - kLowestPower];
    out[k - kLowestPower] = normalised(Wide{last.mantissa} * 10U, last.exponent);
  }
  for (int k = -1; k >= kLowestPower; --k) {
    const PowerOfTen& last = out[k + 1 - kLowestPower];
    out[k - kLowestPower] = normalised((Wide{last.mantissa} << 32U) / 10U, last.exponent - 32);
  }
  return out;
}();

}  // namespace

constexpr std::array<PowerOfTen, kHighestPower - kLowestPower + 1> kPowersOfTen = kMade;

}  // namespace adore::results
