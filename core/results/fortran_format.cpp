#include "results/fortran_format.hpp"

#include "results/decimal_digits.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <system_error>

namespace adore::results::fortran {
namespace {

void append_right(std::string& out, std::string_view text, int width) {
  const auto columns_wide = static_cast<std::size_t>(width);
  if (text.size() > columns_wide) {
    out.append(columns_wide, '*');
  } else {
    out.append(columns_wide - text.size(), ' ');
    out.append(text);
  }
}

std::string_view special_word(double value, int width) {
  if (std::isnan(value)) return "NaN";
  if (value > 0.0) return width >= 8 ? "Infinity" : "Inf";
  return width >= 9 ? "-Infinity" : "-Inf";
}

/// The first `count` significant digits of a value >= 0, and the power of ten of the first one.
void write_digits(double value, int count, char* out, int& exponent) {
  DecimalDigits found;
  if (count >= 1 && count <= 9 && std::isnormal(value) && decimal_digits(value, count, found)) {
    exponent = found.exponent;
    for (int k = count; k-- > 0; found.digits /= 10)
      out[k] = static_cast<char>('0' + found.digits % 10);
    return;
  }
  // "d.ddde±XX"
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::scientific, count - 1)
                       .ptr;
  const std::string_view scientific(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t letter = scientific.find('e');
  exponent = 0;
  std::from_chars(scientific.data() + letter + (scientific[letter + 1] == '+' ? 2 : 1), end,
                  exponent);
  *out++ = scientific[0];
  if (letter > 2) std::copy(scientific.begin() + 2, scientific.begin() + letter, out);
}

/// "E-99" to "E+99".
constexpr int kMaxExponent = 99;
constexpr auto kExponents = [] {
  std::array<std::array<char, 4>, 2 * kMaxExponent + 1> out{};
  for (int k = -kMaxExponent; k <= kMaxExponent; ++k) {
    const int size = k < 0 ? -k : k;
    out[static_cast<std::size_t>(k + kMaxExponent)] = {'E', k < 0 ? '-' : '+',
                                                       static_cast<char>('0' + size / 10),
                                                       static_cast<char>('0' + size % 10)};
  }
  return out;
}();

/// Eight digits of a number below 10^8, the first in the lowest byte: halves, pairs and digits are
/// parted side by side in one word.
constexpr std::uint64_t eight_digits(std::uint32_t number) {
  const std::uint32_t high = number / 10000;
  std::uint64_t word = high | std::uint64_t{number - 10000 * high} << 32U;
  const std::uint64_t hundreds = ((word * 10486) >> 20U) & 0x7f0000007fU;
  word = hundreds | (word - 100 * hundreds) << 16U;
  const std::uint64_t tens = ((word * 103) >> 10U) & 0x000f000f000f000fU;
  return (tens | (word - 10 * tens) << 8U) + 0x3030303030303030U;
}

/// Four digits of a number below 10^4, likewise.
constexpr std::uint32_t four_digits(std::uint32_t number) {
  const std::uint32_t hundreds = number / 100, pairs = hundreds | (number - 100 * hundreds) << 16U,
                      tens = ((pairs * 103) >> 10U) & 0x000f000fU;
  return (tens | (pairs - 10 * tens) << 8U) + 0x30303030U;
}

/// The field of nearly all numbers of a run, wide enough for all cases here: 0, or
/// of a number between 1e-75 and 1e75 whose digits 64 bits decide. The compiler knows all but the
/// value.
template <int width, int digits, Scale scale>
[[gnu::always_inline]] inline bool put_usual(char* field, double value) {
  constexpr int kCount = scale == Scale::One ? digits + 1 : digits;
  constexpr int kLead = width - (2 + digits + 4);  // before "d.", digits, "E+00": blanks and sign
  static_assert(kCount <= 8 && kLead >= 1);
  constexpr std::uint32_t kLowest = 1023 - 250, kSpan = 500;  // of the exponent of 2
  const auto bits = std::bit_cast<std::uint64_t>(value);
  DecimalDigits found;
  if (bits << 1U != 0) {
    if (static_cast<std::uint32_t>(bits >> 52U & 0x7ffU) - kLowest > kSpan ||
        !decimal_digits(std::abs(value), kCount, found))
      return false;
    if (scale == Scale::Zero) ++found.exponent;
  }
  std::memset(field, ' ', kLead);
  if (value < 0.0) field[kLead - 1] = '-';
  // Those of the number are the last ones; the first of `digits` + 1 stands before the point.
  std::uint64_t all = 0;
  if constexpr (digits < 4)
    all = four_digits(found.digits) >> (8 * (3 - digits));
  else
    all = eight_digits(found.digits) >> (8 * (7 - digits));
  char* at = field + kLead;
  at[0] = static_cast<char>(all);
  at[1] = '.';
  const std::uint64_t behind = all >> 8U;
  std::memcpy(at + 2, &behind, digits);
  std::memcpy(at + 2 + digits,
              kExponents[static_cast<std::size_t>(found.exponent + kMaxExponent)].data(), 4);
  return true;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool equal_word(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (lower(text[i]) != word[i]) return false;
  return true;
}

}  // namespace

void append_integer(std::string& out, long long value, int width) {
  std::array<char, 24> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  append_right(out, {buffer.data(), static_cast<std::size_t>(end - buffer.data())}, width);
}

void append_real(std::string& out, double value, int width, int digits, Scale scale) {
  if (!std::isfinite(value)) {
    append_right(out, special_word(value, width), width);
    return;
  }
  // As many significant digits of |value| as the descriptor shows, and the place of the first.
  const int count = scale == Scale::One ? digits + 1 : digits;
  std::array<char, 64> buffer{};
  int exponent = 0;
  write_digits(std::abs(value), count, buffer.data(), exponent);
  const std::string_view figures(buffer.data(), static_cast<std::size_t>(count));

  std::array<char, 80> field{};
  char* at = field.data();
  const auto put = [&at](std::string_view text) { at = std::copy(text.begin(), text.end(), at); };
  if (value < 0.0) *at++ = '-';
  char* const lead = at;
  if (scale == Scale::One) {
    *at++ = figures[0];
    *at++ = '.';
    put(figures.substr(1));
  } else {
    put("0.");
    put(figures);
    if (value != 0.0) ++exponent;
  }
  const int size = std::abs(exponent);
  if (size < 100) *at++ = 'E';
  *at++ = exponent < 0 ? '-' : '+';
  if (size < 10) *at++ = '0';
  at = std::to_chars(at, field.data() + field.size(), size).ptr;
  // Fortran may leave out the zero before the point when the field is one column too narrow.
  if (scale == Scale::Zero && at - field.data() == width + 1) {
    std::copy(lead + 1, at, lead);
    --at;
  }
  append_right(out, {field.data(), static_cast<std::size_t>(at - field.data())}, width);
}

namespace {

void put(char* field, double value, int width, int digits, Scale scale) {
  std::string text;
  append_real(text, value, width, digits, scale);
  std::copy(text.begin(), text.end(), field);
}

}  // namespace

void append_reals(std::string& out, std::span<const double> values, int width, int digits,
                  Scale scale, int per_line, std::string_view between) {
  if (values.empty()) return;
  const std::size_t columns_wide = static_cast<std::size_t>(width), before = out.size(),
                    lines = (values.size() - 1) / static_cast<std::size_t>(per_line);
  out.resize(before + values.size() * columns_wide + lines * between.size());
  char* at = out.data() + before;
  const auto put_all = [&](auto usual) {
    int left = per_line;  // of this line
    for (const double value : values) {
      if (left == 0) {
        at = std::copy(between.begin(), between.end(), at);
        left = per_line;
      }
      --left;
      if (!usual(at, value)) put(at, value, width, digits, scale);
      at += width;
    }
  };
  if (width == 16 && digits == 7 && scale == Scale::One)
    put_all(put_usual<16, 7, Scale::One>);
  else if (width == 10 && digits == 3 && scale == Scale::Zero)
    put_all(put_usual<10, 3, Scale::Zero>);
  else
    put_all([](char*, double) { return false; });
}

void append_text(std::string& out, std::string_view text, int width) {
  const auto columns_wide = static_cast<std::size_t>(width);
  text = text.substr(0, columns_wide);
  out.append(text);
  out.append(columns_wide - text.size(), ' ');
}

std::string_view columns(std::string_view line, int first, int last) {
  const auto begin = static_cast<std::size_t>(first - 1);
  if (begin >= line.size()) return {};
  return line.substr(begin, static_cast<std::size_t>(last - first + 1));
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parse_real(std::string_view field) {
  const std::string_view text = trimmed(field);
  if (text.empty()) return std::nullopt;
  if (text.find_first_not_of('*') == std::string_view::npos)
    return std::numeric_limits<double>::quiet_NaN();

  std::string_view rest = text;
  const bool negative = rest.front() == '-';
  if (rest.front() == '-' || rest.front() == '+') rest.remove_prefix(1);
  const double sign = negative ? -1.0 : 1.0;
  if (equal_word(rest, "nan")) return std::numeric_limits<double>::quiet_NaN();
  if (equal_word(rest, "inf") || equal_word(rest, "infinity"))
    return sign * std::numeric_limits<double>::infinity();

  // Rewritten as mantissa 'e' exponent; a field is at most a line long.
  std::string number;
  std::size_t at = 0;
  int digits = 0;
  bool point = false;
  for (; at < rest.size() && (is_digit(rest[at]) || (rest[at] == '.' && !point)); ++at) {
    if (rest[at] == '.')
      point = true;
    else
      ++digits;
    number += rest[at];
  }
  if (digits == 0) return std::nullopt;
  bool small = false;
  if (at < rest.size()) {
    const char letter = lower(rest[at]);
    if (letter == 'e' || letter == 'd' || letter == 'q') {
      ++at;
    } else if (letter != '+' && letter != '-') {
      return std::nullopt;
    }
    number += 'e';
    if (at < rest.size() && (rest[at] == '+' || rest[at] == '-')) {
      small = rest[at] == '-';
      number += rest[at++];
    }
    if (at == rest.size()) return std::nullopt;
    for (; at < rest.size(); ++at) {
      if (!is_digit(rest[at])) return std::nullopt;
      number += rest[at];
    }
    // from_chars takes no '+' before the exponent's digits in some libraries: always valid without.
    if (const std::size_t plus = number.find('+'); plus != std::string::npos) number.erase(plus, 1);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc::result_out_of_range)
    return sign * (small ? 0.0 : std::numeric_limits<double>::infinity());
  if (error != std::errc() || end != number.data() + number.size()) return std::nullopt;
  return sign * value;
}

std::optional<long long> parse_integer(std::string_view field) {
  std::string_view text = trimmed(field);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace adore::results::fortran
