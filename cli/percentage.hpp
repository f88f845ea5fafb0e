#pragma once

#include "cli/option_ranges.hpp"

#include <charconv>
#include <string>
#include <string_view>

namespace adore::cli {

/// "1%" and "0.01" mean the same. @throws InputError, also outside the range of the option
inline double parse_percentage(std::string_view option, const std::string& text) {
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const bool percent = end != last && *end == '%' && end + 1 == last;
  if (error != std::errc() || (end != last && !percent))
    throw InputError(
        fmt::format("{}: \"{}\" is not a percentage; give e.g. 1% or 0.01", option, text));
  if (percent) value *= 0.01;
  check_range(option, value);
  return value;
}

}  // namespace adore::cli
