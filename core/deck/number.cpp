#include "deck/number.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace adore::deck {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// The parts of a Fortran real: [sign] digits [. digits] [exponent].
struct RealParts {
  bool valid = false;
  std::string mantissa;  ///< without sign, at least one digit
  bool negative = false;
  std::string exponent;  ///< sign and digits, or empty
};

RealParts split_real(std::string_view text) {
  RealParts parts;
  std::size_t at = 0;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) parts.negative = text[at++] == '-';
  const std::size_t start = at;
  std::size_t digits = 0;
  bool point = false;
  for (; at < text.size() && (is_digit(text[at]) || (text[at] == '.' && !point)); ++at) {
    if (text[at] == '.')
      point = true;
    else
      ++digits;
  }
  if (digits == 0) return parts;
  parts.mantissa = text.substr(start, at - start);
  if (at < text.size()) {
    const char letter = text[at];
    const bool has_letter = letter == 'e' || letter == 'E' || letter == 'd' || letter == 'D';
    if (has_letter) ++at;
    const bool has_sign = at < text.size() && (text[at] == '+' || text[at] == '-');
    if (!has_letter && !has_sign) return parts;
    if (has_sign && text[at] == '-') parts.exponent = "-";
    if (has_sign) ++at;
    const std::size_t exponent_start = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    if (at == exponent_start || at != text.size()) return parts;
    parts.exponent += text.substr(exponent_start);
  }
  parts.valid = true;
  return parts;
}

/// Is a number outside the range of double too small (true) or too large?
bool is_tiny(const RealParts& parts) {
  if (!parts.exponent.empty()) {
    const std::string_view digits =
        std::string_view(parts.exponent).substr(parts.exponent[0] == '-' ? 1 : 0);
    const std::size_t significant =
        digits.size() - std::min(digits.find_first_not_of('0'), digits.size());
    if (significant > 6)
      return parts.exponent[0] == '-';  // no mantissa in a deck is a million digits long
  }
  int exponent = 0;
  if (!parts.exponent.empty())
    std::from_chars(parts.exponent.data(), parts.exponent.data() + parts.exponent.size(), exponent);
  const std::size_t point = std::min(parts.mantissa.find('.'), parts.mantissa.size());
  const std::size_t first = parts.mantissa.find_first_of("123456789");
  const auto leading = static_cast<long long>(point) - static_cast<long long>(first);
  return leading + exponent < 0;
}

}  // namespace

NumberProblem parse_integer(std::string_view text, long long& value) {
  const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool two_signs = text.starts_with("+-");
  const bool complete = end == digits.data() + digits.size() && !two_signs;
  if (error == std::errc() && complete) return {};
  if (error == std::errc::result_out_of_range && complete)
    return {"is too large for an integer", "give a value between -2147483647 and 2147483647"};
  double real = 0.0;
  if (!parse_real(text, real)) {
    const bool whole = real == std::floor(real) && std::abs(real) < 1e15;
    return {"must be an integer, without a decimal point or exponent",
            whole ? fmt::format("write {}", static_cast<long long>(real)) : "give an integer"};
  }
  return {"is not an integer", "give an integer"};
}

NumberProblem parse_real(std::string_view text, double& value) {
  const std::string word =
      lowered(text.substr(text.starts_with('+') || text.starts_with('-') ? 1 : 0));
  if (word.starts_with("nan") || word.starts_with("inf"))
    return {"is not a finite number", "give a finite number"};
  const RealParts parts = split_real(text);
  if (!parts.valid) return {"is not a number", "give a number such as 0.05, 5.0e-2 or 5.0d-2"};
  const std::string clean = (parts.negative ? "-" : "") + parts.mantissa +
                            (parts.exponent.empty() ? "" : "e" + parts.exponent);
  const auto [end, error] = std::from_chars(clean.data(), clean.data() + clean.size(), value);
  if (error == std::errc::result_out_of_range) {
    if (!is_tiny(parts)) return {"is too large for a number", "give a value below 1.0e+308"};
    value = parts.negative ? -0.0 : 0.0;
    return {};
  }
  demand(error == std::errc() && end == clean.data() + clean.size(),
         "a checked real number must parse");
  if (!std::isfinite(value)) return {"is too large for a number", "give a value below 1.0e+308"};
  return {};
}

double rounded_to_digits(double value, int digits) {
  std::array<char, 48> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::scientific, digits - 1);
  double out = value;
  std::from_chars(text.data(), written.ptr, out);
  return out;
}

std::string format_real(double value) {
  if (!std::isfinite(value))
    return fmt::format("{}", value);  // cannot be read back; only in messages
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  demand(error == std::errc(), "64 characters hold every double");
  std::string text(buffer.data(), end);
  if (text.find('.') == std::string::npos) {
    const std::size_t exponent = text.find('e');
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  }
  return text;
}

}  // namespace adore::deck
