#include "deck/element_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace adore::deck {

std::string body_name(const Deck& deck, long long number) {
  const long long elements = deck.integer("nRe"), segments = std::max(deck.integer("nCseg"), 0LL);
  if (number < 1 || number > elements + segments + 2) return {};
  if (number <= elements) return fmt::format("rolling element {}", number);
  if (number == elements + segments + 1) return "outer race";
  if (number == elements + segments + 2) return "inner race";
  return segments == 1 ? "cage" : fmt::format("cage segment {}", number - elements);
}

std::string array_element_name(const VariableSpec& variable, std::size_t element) {
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  constexpr std::array<std::string_view, 3> kTurns = {"about x", "about y'", "about z''"};
  if (variable.length == "3" && element < 3)
    return std::string(variable.unit.si == "deg" ? kTurns[element] : kAxes[element]);
  if (variable.length == "nGL") return fmt::format("land {}", element + 1);
  if (variable.length == "nCseg") return fmt::format("segment {}", element + 1);
  return fmt::format("{}", element + 1);
}

}  // namespace adore::deck
