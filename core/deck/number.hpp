#pragma once

#include <string>
#include <string_view>

/// Numbers as Fortran reads and we write them; the locale never matters.
namespace adore::deck {

/// Error of a number, empty if valid. A clause that continues "the value ...".
struct NumberProblem {
  std::string message;  ///< "is not a number"
  std::string remedy;   ///< "write 0.05"
  explicit operator bool() const { return !message.empty(); }
};

/// Optional sign and digits. A decimal point is rejected: 3.0 is not an integer.
NumberProblem parse_integer(std::string_view text, long long& value);

/// Decimal with or without point, exponent letter e, E, d, D or none before a signed exponent
/// (1.5-3). NaN, infinity and values beyond the range of double are rejected; values too small for
/// a double become zero.
NumberProblem parse_real(std::string_view text, double& value);

/// The nearest double with so many decimal digits, 1 to 17.
[[nodiscard]] double rounded_to_digits(double value, int digits);

/// Shortest text that reads back to the same double; always with a decimal point.
std::string format_real(double value);

}  // namespace adore::deck
