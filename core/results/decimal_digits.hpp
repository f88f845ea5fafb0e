#pragma once

#include <cstdint>

/// The first significant decimal digits of a number: what fortran_format.cpp writes, without the
/// detour over a general printer. A stored step has some 430 of them.
namespace adore::results {

/// value = digits × 10^(exponent - count + 1), rounded to the nearest: digits has `count` of them.
struct DecimalDigits {
  std::uint32_t digits = 0;
  int exponent = 0;
};

/// @param value > 0, finite, normal; count 1 to 9
/// @return false where 64 bits do not decide how to round (a tie, or within 2^-20 of one in the
/// last digit): ask a printer that carries all bits. Else the digits are those of such a printer.
[[nodiscard]] bool decimal_digits(double value, int count, DecimalDigits& out) noexcept;

}  // namespace adore::results
