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

/// The same for a printed number: counted("0.5", "turn") is "0.5 turns", of "1" "1 turn".
[[nodiscard]] inline std::string counted(std::string_view printed, std::string_view one,
                                         std::string_view many = {}) {
  if (printed == "1") return fmt::format("1 {}", one);
  return many.empty() ? fmt::format("{} {}s", printed, one) : fmt::format("{} {}", printed, many);
}
[[nodiscard]] inline std::string counted(const std::string& printed, std::string_view one,
                                         std::string_view many = {}) {
  return counted(std::string_view(printed), one, many);
}

}  // namespace adore
