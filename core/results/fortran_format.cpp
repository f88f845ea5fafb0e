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

/// "00" to "99".
constexpr auto kPairs = [] {
  std::array<char, 200> out{};
  for (int k = 0; k < 100; ++k) {
    out[static_cast<std::size_t>(2 * k)] = static_cast<char>('0' + k / 10);
    out[static_cast<std::size_t>(2 * k + 1)] = static_cast<char>('0' + k % 10);
  }
  return out;
}();

void put_pair(char* at, std::uint32_t pair) {
  std::memcpy(at, kPairs.data() + std::size_t{2} * pair, 2);
}

/// The field of nearly all numbers of a run, written into its place among `width` blanks: 0, or
/// normal with up to nine digits that 64 bits decide, an exponent of two digits, and columns
/// enough. Of constant `digits` and `scale` it takes a third of the instructions.
[[gnu::always_inline]] inline bool put_usual(char* field, double value, int width, int digits,
                                             Scale scale) {
  const int count = scale == Scale::One ? digits + 1 : digits;
  const double size = std::abs(value);
  DecimalDigits found;
  // sign, "0." or "d.", digits, "E+00"
  const int length = (value < 0.0 ? 1 : 0) + 2 + digits + 4;
  if (count < 1 || count > 9 || length > width) return false;
  if (size != 0.0 && (!std::isnormal(size) || !decimal_digits(size, count, found))) return false;
  const int exponent = found.exponent + (scale == Scale::Zero && size != 0.0 ? 1 : 0);
  if (exponent < -99 || exponent > 99) return false;

  char* at = field + (width - length);
  if (value < 0.0) *at++ = '-';
  // From the last digit to the first.
  char* place = at + 2 + digits;
  std::uint32_t rest = found.digits;
  int left = digits;
  for (; left >= 2; left -= 2, rest /= 100) put_pair(place -= 2, rest % 100);
  if (left > 0) {
    *--place = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  at[0] = static_cast<char>('0' + rest);  // 0 when all digits stand behind the point
  at[1] = '.';
  at += 2 + digits;
  at[0] = 'E';
  at[1] = exponent < 0 ? '-' : '+';
  put_pair(at + 2, static_cast<std::uint32_t>(std::abs(exponent)));
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
  const std::size_t before = out.size();
  out.append(static_cast<std::size_t>(width), ' ');
  if (put_usual(out.data() + before, value, width, digits, scale)) return;
  out.resize(before);
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

void append_reals(std::string& out, std::span<const double> values, int width, int digits,
                  Scale scale, int per_line, std::string_view between) {
  if (values.empty()) return;
  const std::size_t columns_wide = static_cast<std::size_t>(width), before = out.size(),
                    lines = (values.size() - 1) / static_cast<std::size_t>(per_line);
  out.resize(before + values.size() * columns_wide + lines * between.size(), ' ');
  char* at = out.data() + before;
  std::string unusual;
  const auto put_all = [&](auto put) {
    int left = per_line;  // of this line
    for (const double value : values) {
      if (left == 0) {
        at = std::copy(between.begin(), between.end(), at);
        left = per_line;
      }
      --left;
      if (!put(at, value)) {
        unusual.clear();
        append_real(unusual, value, width, digits, scale);
        std::copy(unusual.begin(), unusual.end(), at);
      }
      at += width;
    }
  };
  if (digits == 7 && scale == Scale::One)
    put_all([&](char* to, double v) { return put_usual(to, v, width, 7, Scale::One); });
  else if (digits == 3 && scale == Scale::Zero)
    put_all([&](char* to, double v) { return put_usual(to, v, width, 3, Scale::Zero); });
  else
    put_all([&](char* to, double v) { return put_usual(to, v, width, digits, scale); });
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
