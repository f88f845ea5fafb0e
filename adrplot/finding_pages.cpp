#include "adrplot/finding_pages.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace adore::adrplot {
namespace {

std::string lower(std::string_view text) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return low;
}

/// Word in the titles of panels that show the quantity of a finding: by the beginning of its code,
/// else by its topic.
std::string_view panel_word(const Finding& finding) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kCodes{
      {{"cage.centered", "whirl"},
       {"cage.whirling", "whirl"},
       {"cage.unstable", "whirl"},
       {"cage.through_race", "gap"},
       {"cage.overlap", "gap"},
       {"cage.yielding", "force"},
       {"fit.pocket_clearance", "gap"},
       {"statics.steep_angle", "angle"}}};
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTopics{
      {{"contact", "contact load"},
       {"load", "contact load"},
       {"cage", "force"},
       {"film", "film"},
       {"life", "life"},
       {"heat", "power loss"}}};
  for (const auto& [code, word] : kCodes)
    if (std::string_view(finding.code).starts_with(code)) return word;
  const std::string topic = topic_of(finding);
  for (const auto& [name, word] : kTopics)
    if (topic == name) return word;
  return {};
}

}  // namespace

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
  const std::string low = lower(title);
  for (const auto& [word, topic] : kWords)
    if (low.find(word) != std::string::npos) return topic;
  return {};
}

std::string topic_of(const Finding& finding) {
  const FindingKind* kind = find_finding_kind(finding.code);
  return kind == nullptr ? std::string() : kind->topic;
}

bool panel_concerns(std::string_view title, const Finding& finding) {
  const std::string_view word = panel_word(finding);
  return !word.empty() && lower(title).find(word) != std::string::npos;
}

std::vector<std::pair<std::size_t, std::size_t>> concerned_curves(const desktop::ChartPage& page,
                                                                  const Finding& finding) {
  std::string_view race;
  for (const std::string_view word : {"inner", "outer"})
    if (finding.body.find(word) != std::string::npos) race = word;
  std::vector<std::pair<std::size_t, std::size_t>> all, of_race;
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    const desktop::ChartPanel& panel = page.panels[p];
    if (!panel_concerns(panel.title, finding)) continue;
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      all.emplace_back(p, c);
      if (!race.empty() && lower(panel.curves[c].name).find(race) != std::string::npos)
        of_race.emplace_back(p, c);
    }
  }
  return of_race.empty() ? all : of_race;
}

std::function<bool(const Finding&)> page_concerns(std::string_view title,
                                                  std::string_view subject) {
  return [topic = topic_of_page(title, subject)](const Finding& one) {
    return !topic.empty() && topic_of(one) == topic;
  };
}

}  // namespace adore::adrplot
