#include "adrplot/finding_pages.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace adore::adrplot {

std::string topic_of_page(std::string_view title, std::string_view subject) {
  if (subject.starts_with("cage")) return "cage";  // all pages of its file
  constexpr std::array<std::pair<const char*, const char*>, 18> kWords{{{"cage", "cage"},
                                                                        {"whirl", "cage"},
                                                                        {"orbit", "cage"},
                                                                        {"pocket", "cage"},
                                                                        {"guide land", "cage"},
                                                                        {"film", "film"},
                                                                        {"lambda", "film"},
                                                                        {"life", "life"},
                                                                        {"heat", "heat"},
                                                                        {"power", "heat"},
                                                                        {"temperature", "heat"},
                                                                        {"energy", "energy"},
                                                                        {"contact", "contact"},
                                                                        {"pressure", "contact"},
                                                                        {"load", "contact"},
                                                                        {"slip", "contact"},
                                                                        {"race", "contact"},
                                                                        {"spin", "contact"}}};
  std::string low(title);
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [word, topic] : kWords)
    if (low.find(word) != std::string::npos) return topic;
  return {};
}

std::string topic_of(const Finding& finding) {
  const FindingKind* kind = find_finding_kind(finding.code);
  return kind == nullptr ? std::string() : kind->topic;
}

std::function<bool(const Finding&)> page_concerns(std::string_view title,
                                                  std::string_view subject) {
  return [topic = topic_of_page(title, subject)](const Finding& one) {
    return !topic.empty() && topic_of(one) == topic;
  };
}

}  // namespace adore::adrplot
