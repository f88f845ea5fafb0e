#pragma once

#include "desktop/axis_scale.hpp"

#include <cctype>
#include <string>
#include <string_view>

/// Numbers of a list, all with the same count of digits.
namespace adore::desktop {

/// pretty_quantity() with trailing zeros: "272.0 N" next to "312.2 N". 0 and powers of ten are
/// unchanged.
[[nodiscard]] inline std::string zero_padded_quantity(double value, std::string_view unit,
                                                      int digits) {
  std::string text = pretty_quantity(value, unit, digits);
  std::size_t end = 0;
  int counted = 0;
  bool point = false, leading = true;
  for (; end < text.size(); ++end) {
    const char c = text[end];
    if (c == '.') {
      point = true;
    } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      leading = leading && c == '0';
      counted += leading ? 0 : 1;
    } else if (counted > 0 || c == ' ' || c == 'e') {
      break;
    }
  }
  const bool number_ends = end == text.size() || text[end] == ' ';
  if (counted == 0 || counted >= digits || !number_ends) return text;
  std::string zeros(static_cast<std::size_t>(digits - counted), '0');
  return text.insert(end, point ? zeros : "." + zeros);
}

}  // namespace adore::desktop
