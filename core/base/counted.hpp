#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace adore {

/// "1 page", "3 pages"; of other plurals the second word is given: counted(2, "spectrum",
/// "spectra").
template <class Number>
[[nodiscard]] std::string counted(Number number, std::string_view one, std::string_view many = {}) {
  if (number == Number{1}) return fmt::format("{} {}", number, one);
  return many.empty() ? fmt::format("{} {}s", number, one) : fmt::format("{} {}", number, many);
}

}  // namespace adore
