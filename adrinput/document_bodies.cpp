#include "adrinput/document.hpp"
#include "adrinput/typed.hpp"
#include "deck/element_names.hpp"
#include "deck/lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

/// Which bodies are monitored when their count changes.
///
/// kPltElemInd numbers them through: elements 1 to nRe, nCseg cage segments, outer race, inner
/// race. With another nRe or nCseg the same number is another body, so numbers follow the bodies.
namespace adore::adrinput {
namespace {

constexpr std::string_view kRecord = "3.4";

struct Counts {
  long long elements, segments;
  explicit Counts(const deck::Deck& deck)
      : elements(deck.integer("nRe")), segments(std::max(deck.integer("nCseg"), 0LL)) {}
  [[nodiscard]] bool operator==(const Counts&) const = default;
};

/// A part of the numbers that is of one kind, and how many of it there are before and after.
struct Kind {
  long long first_before, before, first_after, after;
};

/// The last number of the kind that nobody has yet; 0: there is none.
long long free_number(const Kind& kind, const std::vector<long long>& taken) {
  for (long long place = kind.after; place >= 1; --place) {
    const long long number = kind.first_after + place - 1;
    if (std::find(taken.begin(), taken.end(), number) == taken.end()) return number;
  }
  return 0;
}

}  // namespace

/// An element or segment that is no more gives its place to the last one that is not monitored;
/// what has no heir is left out, and a note says so.
void Document::follow_bodies(const deck::Deck& before) {
  const Counts old(before), now(state_.deck);
  deck::RecordData* record = record_at(state_.deck, std::string(kRecord), 1);
  if (old == now || old.elements < 1 || now.elements < 1 || record == nullptr) return;
  const std::size_t count = deck::find_variable("kNumPltElem")[0].position;
  const std::size_t bodies = deck::find_variable("kPltElemInd")[0].position;
  std::vector<long long> monitored;
  for (const deck::Value& value : record->values[bodies]) {
    const auto* number = std::get_if<long long>(&value);
    if (number == nullptr || deck::body_name(before, *number).empty() ||
        (!monitored.empty() && *number <= monitored.back()))
      return;  // wrong before: an error tells it
    monitored.push_back(*number);
  }
  if (state_.followed != monitored) state_.monitored_with.clear();  // chosen anew since
  state_.monitored_with[{old.elements, old.segments}] = monitored;
  const auto known = state_.monitored_with.find({now.elements, now.segments});
  const bool back = known != state_.monitored_with.end();
  if (back) monitored = known->second;
  const Kind kinds[] = {
      {1, old.elements, 1, now.elements},
      {old.elements + 1, old.segments, now.elements + 1, now.segments},
      {old.elements + old.segments + 1, 1, now.elements + now.segments + 1, 1},
      {old.elements + old.segments + 2, 1, now.elements + now.segments + 2, 1},
  };
  std::vector<long long> after;
  std::vector<std::pair<const Kind*, long long>> homeless;  // after those that stay as they are
  if (back) after = monitored;
  for (const long long number : back ? std::vector<long long>{} : monitored)
    for (const Kind& kind : kinds) {
      const long long place = number - kind.first_before + 1;
      if (place < 1 || place > kind.before) continue;
      if (place <= kind.after)
        after.push_back(kind.first_after + place - 1);
      else
        homeless.emplace_back(&kind, number);
    }
  for (const auto& [kind, number] : homeless) {
    if (const long long heir = free_number(*kind, after); heir > 0) {
      after.push_back(heir);
      continue;
    }
    Issue issue;
    issue.severity = Severity::Note;
    issue.record = kRecord;
    issue.variable = "kPltElemInd";
    issue.message =
        fmt::format("the {} is gone and is no longer monitored", deck::body_name(before, number));
    issue.remedy = "choose another body, or undo the change";
    change_issues_.push_back(std::move(issue));
  }
  std::sort(after.begin(), after.end());
  state_.followed = after;
  record->values[count] = {static_cast<long long>(after.size())};
  record->values[bodies].assign(after.begin(), after.end());
  settle();
}

}  // namespace adore::adrinput
