#include "deck/monitored_bodies.hpp"

#include "deck/element_names.hpp"
#include "deck/lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::deck {
namespace {

constexpr std::string_view kRecord = "3.4", kBodies = "kPltElemInd", kCount = "kNumPltElem";

struct Counts {
  long long elements, segments;
  explicit Counts(const Deck& deck)
      : elements(deck.integer("nRe")), segments(std::max(deck.integer("nCseg"), 0LL)) {}
  [[nodiscard]] bool operator==(const Counts&) const = default;
};

/// A range of the numbers of one type of body, and its size before and after.
struct Kind {
  long long first_before, before, first_after, after;
};

/// The last number of the kind that nobody has yet; 0: there is none.
long long free_number(const Kind& kind, const std::vector<Value>& taken) {
  for (long long place = kind.after; place >= 1; --place) {
    const long long number = kind.first_after + place - 1;
    if (std::find(taken.begin(), taken.end(), Value(number)) == taken.end()) return number;
  }
  return 0;
}

RecordData* record_of(Deck& deck) {
  const auto found = std::find_if(deck.records.begin(), deck.records.end(),
                                  [](const RecordData& data) { return data.id == kRecord; });
  const std::size_t bodies = find_variable(kBodies)[0].position;
  return found == deck.records.end() || found->values.size() <= bodies ? nullptr : &*found;
}

Issue note(std::string message, std::string remedy) {
  Issue issue;
  issue.severity = Severity::Note;
  issue.record = kRecord;
  issue.variable = kBodies;
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  return issue;
}

/// Increasing numbers, as the deck requires.
bool in_order(const std::vector<Value>& values) {
  long long last = 0;
  for (const Value& value : values) {
    const auto* number = std::get_if<long long>(&value);
    if (number == nullptr || *number <= last) return false;
    last = *number;
  }
  return true;
}

void write(RecordData& record, std::vector<Value> bodies) {
  record.values[find_variable(kCount)[0].position] = {static_cast<long long>(bodies.size())};
  record.values[find_variable(kBodies)[0].position] = std::move(bodies);
  const std::size_t position = find_variable(kBodies)[0].position;
  std::erase_if(record.defaulted, [&](const RecordData::Element& at) {
    return at.variable == position && at.element >= record.values[position].size();
  });
}

}  // namespace

bool have_same_body_numbers(const Deck& a, const Deck& b) {
  const Counts of_a(a), of_b(b);
  return of_a == of_b || of_a.elements < 1 || of_b.elements < 1;
}

std::vector<long long> monitored_bodies(const Deck& deck) {
  std::vector<long long> out;
  const RecordData* record = find_record_data(deck, kRecord);
  const std::size_t bodies = find_variable(kBodies)[0].position;
  if (record == nullptr || record->values.size() <= bodies) return {};
  for (const Value& value : record->values[bodies]) {
    const auto* number = std::get_if<long long>(&value);
    if (number == nullptr) return {};
    out.push_back(*number);
  }
  return out;
}

void set_monitored_bodies(Deck& deck, const std::vector<long long>& bodies) {
  if (RecordData* record = record_of(deck)) write(*record, {bodies.begin(), bodies.end()});
}

std::vector<Issue> renumber_monitored_bodies(Deck& deck, const Deck& before) {
  RecordData* record = record_of(deck);
  if (record == nullptr || have_same_body_numbers(deck, before)) return {};
  const Counts old(before), now(deck);
  const std::vector<Value> given = record->values[find_variable(kBodies)[0].position];
  const Kind kinds[] = {
      {1, old.elements, 1, now.elements},
      {old.elements + 1, old.segments, now.elements + 1, now.segments},
      {old.elements + old.segments + 1, 1, now.elements + now.segments + 1, 1},
      {old.elements + old.segments + 2, 1, now.elements + now.segments + 2, 1},
  };
  std::vector<Issue> notes;
  std::vector<Value> after;
  std::vector<std::pair<const Kind*, long long>> homeless;  // after those that stay as they are
  for (const Value& value : given) {
    const auto* number = std::get_if<long long>(&value);
    const Kind* of = nullptr;
    for (const Kind& kind : kinds)
      if (number != nullptr && *number >= kind.first_before &&
          *number < kind.first_before + kind.before)
        of = &kind;
    if (of == nullptr) {
      after.push_back(value);  // wrong before: reported as an error, unless it is now valid
      if (const std::string name = number == nullptr ? "" : body_name(deck, *number); !name.empty())
        notes.push_back(
            note(fmt::format(
                     "{} was not a body number before the change; it is now the number of the {}",
                     *number, name),
                 "check whether this is the intended body"));
      continue;
    }
    const long long place = *number - of->first_before + 1;
    if (place <= of->after)
      after.emplace_back(of->first_after + place - 1);
    else
      homeless.emplace_back(of, *number);
  }
  for (const auto& [kind, number] : homeless) {
    if (const long long heir = free_number(*kind, after); heir > 0)
      after.emplace_back(heir);
    else
      notes.push_back(note(fmt::format("the {} no longer exists and is no longer monitored",
                                       body_name(before, number)),
                           "choose another body, or undo the change"));
  }
  if (in_order(given)) std::sort(after.begin(), after.end());
  write(*record, std::move(after));
  return notes;
}

std::vector<Issue> set_all_and_renumber(Deck& deck,
                                        std::span<const std::pair<std::string, std::string>> sets) {
  const Deck before = deck;
  deck.set_all(sets);
  const bool named = std::any_of(sets.begin(), sets.end(), [](const auto& set) {
    return std::string_view(set.first).starts_with(kBodies);
  });
  const std::vector<long long> given = monitored_bodies(deck);
  if (named || have_same_body_numbers(deck, before)) return {};
  std::vector<Issue> notes = renumber_monitored_bodies(deck, before);
  const std::vector<long long> now = monitored_bodies(deck);
  if (now == given) return notes;
  std::vector<std::string> names;
  for (const long long number : now) names.push_back(fmt::format("{}", number));
  notes.insert(
      notes.begin(),
      note(fmt::format(
               "with nRe = {} and nCseg = {}, the same bodies are monitored under new numbers: {}",
               deck.integer("nRe"), deck.integer("nCseg"), fmt::join(names, ", ")),
           "to choose other bodies, set kPltElemInd too"));
  return notes;
}

}  // namespace adore::deck
