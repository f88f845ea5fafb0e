#include "listing/cell_text.hpp"

#include "results/decimal_digits.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>

namespace adore::listing {
namespace {

constexpr int kDigits = 5;

/// Writes a number > 0 whose digits are known. @return the end
char* write(char* at, const results::DecimalDigits& number) {
  std::array<char, kDigits> digit;
  std::uint32_t rest = number.digits;
  for (int k = kDigits; k-- > 0; rest /= 10)
    digit[static_cast<std::size_t>(k)] = static_cast<char>('0' + rest % 10);
  int count = kDigits;  // without trailing zeros
  while (count > 1 && digit[static_cast<std::size_t>(count - 1)] == '0') --count;
  const auto put = [&](int from, int to) {
    for (int k = from; k < to; ++k) *at++ = k < count ? digit[static_cast<std::size_t>(k)] : '0';
  };
  const int exponent = number.exponent;
  if (exponent < -4 || exponent >= kDigits) {
    put(0, 1);
    if (count > 1) *at++ = '.';
    put(1, count);
    *at++ = 'e';
    *at++ = exponent < 0 ? '-' : '+';
    const int size = std::abs(exponent);
    if (size >= 100) *at++ = static_cast<char>('0' + size / 100);
    *at++ = static_cast<char>('0' + size / 10 % 10);
    *at++ = static_cast<char>('0' + size % 10);
  } else if (exponent < 0) {
    *at++ = '0';
    *at++ = '.';
    for (int k = -1; k > exponent; --k) *at++ = '0';
    put(0, count);
  } else {
    put(0, exponent + 1);
    if (count > exponent + 1) *at++ = '.';
    put(exponent + 1, count);
  }
  return at;
}

}  // namespace

void append_cell(std::string& line, double value, std::size_t width) {
  std::array<char, 32> text;
  char* end = text.data();
  results::DecimalDigits digits;
  const double size = std::abs(value);
  if (std::isnan(value)) {
    *end++ = '-';
  } else if (value == 0.0) {
    *end++ = '0';
  } else if (std::isnormal(value) && results::decimal_digits(size, kDigits, digits)) {
    if (value < 0.0) *end++ = '-';
    end = write(end, digits);
  } else {
    fmt::format_to(std::back_inserter(line), "{:>{}.5g}", value, width);
    return;
  }
  const auto length = static_cast<std::size_t>(end - text.data());
  if (length < width) line.append(width - length, ' ');
  line.append(text.data(), length);
}

}  // namespace adore::listing
