#include "agore/warned_bodies.hpp"

#include "desktop/findings_bar.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace adore::agore {

WarnedBodies warned_bodies(std::span<const Finding> findings) {
  WarnedBodies out;
  for (const Finding& one : findings) {
    if (one.severity == Severity::Note || one.body.empty()) continue;
    const int element = desktop::parse_element_number(one.body);
    const auto names = [&one](const char* word) {
      return one.body.find(word) != std::string::npos;
    };
    if (names("cage"))
      out.cage = true;
    else if (element > 0)
      out.elements.insert(element);
    else
      for (const auto& [race, word] : {std::pair{0U, "outer race"}, {1U, "inner race"}})
        out.races[race] = out.races[race] || names(word);
  }
  return out;
}

std::string WarnedBodies::names(bool balls) const {
  std::vector<std::string> all;
  const char* one = balls ? "ball" : "roller";
  if (elements.size() > 3)
    all.push_back(fmt::format("{} {}s", elements.size(), one));
  else if (!elements.empty())
    all.push_back(
        fmt::format("{}{} {}", one, elements.size() > 1 ? "s" : "", fmt::join(elements, ", ")));
  if (cage) all.emplace_back("cage");
  if (races[0]) all.emplace_back("outer race");
  if (races[1]) all.emplace_back("inner race");
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace adore::agore
