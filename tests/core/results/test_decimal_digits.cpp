#include "results/decimal_digits.hpp"
#include "results/fortran_format.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

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

TEST_CASE("decimal_digits(): same digits as a printer with all bits", "[unit][results]") {
  std::mt19937_64 random(7);
  Counts any, plain;
  for (int i = 0; i < 200000; ++i) {
    const int count = 1 + i % 9;
    compare(std::bit_cast<double>(random() & 0x7fffffffffffffffU), count, any);
    compare(std::ldexp(static_cast<double>(random() >> 12U), -40), count, any);
    // Ties, whole numbers, powers of ten and their neighbors.
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

TEST_CASE("decimal_digits(): tie → left to a printer with all bits", "[unit][results]") {
  DecimalDigits out;
  CHECK_FALSE(decimal_digits(2.5, 1, out));
  CHECK_FALSE(decimal_digits(0.125, 2, out));
  REQUIRE(decimal_digits(9.9999996, 7, out));
  CHECK(out.digits == 1000000);
  CHECK(out.exponent == 1);
}

TEST_CASE("decimal fields: written together = written one by one", "[unit][results]") {
  namespace ff = adore::results::fortran;
  std::mt19937_64 random(11);
  std::vector<double> values{0.0,
                             -0.0,
                             1e100,
                             -1e-100,
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(),
                             std::nan(""),
                             9.9999995};
  for (int i = 0; i < 3000; ++i) values.push_back(std::bit_cast<double>(random()));
  for (int i = 0; i < 3000; ++i)
    values.push_back(static_cast<double>(random() % 20001U) / 2.0 - 5000.0);
  struct Shape {
    int width, digits, per_line;
    ff::Scale scale;
  };
  for (const Shape& shape : {Shape{16, 7, 8, ff::Scale::One}, Shape{10, 3, 13, ff::Scale::Zero},
                             Shape{14, 5, 7, ff::Scale::One}, Shape{8, 3, 5, ff::Scale::Zero}}) {
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{1}, std::size_t{8}, std::size_t{9}, values.size()}) {
      std::string one_by_one = "x", together = "x";
      for (std::size_t k = 0; k < count; ++k) {
        if (k > 0 && k % static_cast<std::size_t>(shape.per_line) == 0) one_by_one += "\n  ";
        ff::append_real(one_by_one, values[k], shape.width, shape.digits, shape.scale);
      }
      ff::append_reals(together, std::span(values).first(count), shape.width, shape.digits,
                       shape.scale, shape.per_line, "\n  ");
      CHECK(together == one_by_one);
    }
  }
}
