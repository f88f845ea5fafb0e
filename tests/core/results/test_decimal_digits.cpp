#include "results/decimal_digits.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <random>
#include <string>

using adore::results::decimal_digits;
using adore::results::DecimalDigits;

namespace {

struct Counts {
  long asked = 0, undecided = 0;
};

/// The same digits as the library's printer, which carries all bits.
void compare(double value, int count, Counts& counts) {
  if (!(value > 0.0) || !std::isnormal(value)) return;
  ++counts.asked;
  DecimalDigits found;
  if (!decimal_digits(value, count, found)) {
    ++counts.undecided;
    return;
  }
  std::array<char, 64> buffer{};
  char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                  std::chars_format::scientific, count - 1)
                        .ptr;
  const std::string text(buffer.data(), end);
  const auto e = text.find('e');
  std::string digits = text.substr(0, e);
  if (count > 1) digits.erase(1, 1);
  if (std::stoul(digits) != found.digits || std::stoi(text.substr(e + 1)) != found.exponent)
    FAIL(text << " for " << found.digits << ", exponent " << found.exponent);
}

}  // namespace

TEST_CASE("decimal digits are those of a printer that carries all bits", "[unit][results]") {
  std::mt19937_64 random(7);
  Counts any, plain;
  for (int i = 0; i < 200000; ++i) {
    const int count = 1 + i % 9;
    compare(std::bit_cast<double>(random() & 0x7fffffffffffffffU), count, any);
    compare(std::ldexp(static_cast<double>(random() >> 12U), -40), count, any);
    // Ties, whole numbers, powers of ten and their neighbours.
    const double whole = static_cast<double>(random() % 2000001U);
    compare(0.5 * whole, count, plain);
    const double ten = std::pow(10.0, static_cast<int>(random() % 300U) - 150);
    compare(ten, count, plain);
    compare(std::nextafter(ten, 0.0), count, plain);
    compare(whole * ten, count, plain);
  }
  CHECK(any.asked > 300000);
  CHECK(any.undecided < any.asked / 10);  // those beyond the table of powers
  CHECK(plain.undecided < plain.asked / 5);
}

TEST_CASE("a tie is left to who carries all bits", "[unit][results]") {
  DecimalDigits out;
  CHECK_FALSE(decimal_digits(2.5, 1, out));
  CHECK_FALSE(decimal_digits(0.125, 2, out));
  REQUIRE(decimal_digits(9.9999996, 7, out));
  CHECK(out.digits == 1000000);
  CHECK(out.exponent == 1);
}
