#include "base/counted.hpp"
#include "deck/deck.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"
#include "deck/orbit_records.hpp"
#include "deck/quantity.hpp"
#include "deck/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

/// Deck::set, Deck::set_all and Deck::complete.
namespace adore::deck {
namespace {

/// "cageGcPos[2][3]" taken apart.
struct Target {
  std::string_view name;
  std::vector<int> indices;
};

[[noreturn]] void fail(std::string_view variable, std::string_view value, std::string message,
                       std::string remedy) {
  Issue issue;
  issue.variable = variable;
  issue.value = value;
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  throw InputError({issue});
}

Target parse_target(std::string_view text) {
  Target target;
  std::string_view rest = trimmed(text);
  target.name = rest.substr(0, rest.find('['));
  rest.remove_prefix(target.name.size());
  target.name = trimmed(target.name);
  while (!rest.empty()) {
    const std::size_t close = rest.find(']');
    int index = 0;
    const std::string_view number =
        close == std::string_view::npos || rest[0] != '[' ? "" : trimmed(rest.substr(1, close - 1));
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
    if (number.empty() || error != std::errc() || end != number.data() + number.size() ||
        index < 1 || target.indices.size() == 2)
      fail(text, {}, "the index is not valid",
           "write name[1] or name[instance][element], counting from 1");
    target.indices.push_back(index);
    rest.remove_prefix(close + 1);
  }
  return target;
}

[[noreturn]] void fail_unknown(std::string_view name, std::string_view value) {
  if (name == "recID")
    fail(name, value, "every record has a label, so the name recID alone is ambiguous",
         "edit the label in the deck");
  std::string list;
  for (const std::string_view similar : similar_variables(name))
    list += (list.empty() ? "" : ", ") + std::string(similar);
  fail(name, value, "there is no variable with this name",
       list.empty() ? "`adore schema` lists all variables" : fmt::format("did you mean {}?", list));
}

std::string condition_of(std::span<const VariableRef> refs) {
  std::string text;
  for (const VariableRef& ref : refs)
    text += fmt::format("{}record {} (needed when `{}`)", text.empty() ? "" : " or ",
                        ref.record->id, ref.record->condition);
  return text;
}

/// Position of a record among those of the deck.
std::vector<RecordData>::iterator place_of(std::vector<RecordData>& records, const RecordSpec& spec,
                                           int instance) {
  const RecordSpec* first = schema().data();
  const std::ptrdiff_t rank = &spec - first;
  return std::find_if(records.begin(), records.end(), [&](const RecordData& other) {
    const RecordSpec* other_spec = find_record(other.id);
    const std::ptrdiff_t other_rank = other_spec == nullptr ? 0 : other_spec - first;
    return other_rank > rank || (other_rank == rank && other.instance > instance);
  });
}

/// A text, with or without quotes around it.
Value parse_text(std::string_view name, std::string_view text) {
  if (std::any_of(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
      }))
    fail(name, {}, "contains a line break or another control character",
         "keep the text on one line");
  const bool quoted = text.size() >= 2 && (text.front() == '\'' || text.front() == '"') &&
                      text.back() == text.front();
  if (!quoted) return std::string(text);
  const char quote = text.front();
  text = text.substr(1, text.size() - 2);
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    plain += text[i];
    if (text[i] == quote && i + 1 < text.size() && text[i + 1] == quote) ++i;
  }
  return plain;
}

Value parse_value(const VariableSpec& variable, std::string_view name, std::string_view text) {
  if (variable.type == VarType::String) return parse_text(name, text);
  text = trimmed(text);
  long long integer = 0;
  double real = 0.0;
  const NumberProblem problem =
      variable.type == VarType::Integer ? parse_integer(text, integer) : parse_real(text, real);
  if (problem)
    fail(name, text, problem.message,
         fmt::format("{}; {} takes {}", problem.remedy, variable.name,
                     variable.type == VarType::Integer ? "an integer" : "a number"));
  if (variable.type == VarType::Integer) return integer;
  return real;
}

/// A value of an extension record: also with a unit ("55.3 kN"); without any text it is not given.
Value parse_extension(const VariableSpec& variable, std::string_view name, std::string_view text,
                      UnitSystem system) {
  if (trimmed(text).empty()) return std::monostate();
  double real = 0.0;
  if (variable.type != VarType::Real || !parse_real(trimmed(text), real))
    return parse_value(variable, name, text);
  if (const NumberProblem problem = parse_quantity(trimmed(text), variable.unit, system, real))
    fail(name, text, problem.message, problem.remedy);
  return real;
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

bool is_at(const RecordData& data, std::string_view id, int instance) {
  return data.instance == instance && data.id == id;
}

/// The start of a cage, in one piece (record 9.6) or in segments (9.6.k), has the same variables: a
/// record that was not given takes over the values of the other, so that a
/// cage at its epicyclic speed keeps it when it is cut.
/// @param replaced records that the deck is about to lose
void take_over_cage_start(const Deck& deck, const std::vector<RecordData>& replaced,
                          RecordData& data) {
  constexpr std::string_view kWhole = "9.6", kSegment = "9.6.k";
  if (data.id != kWhole && data.id != kSegment) return;
  const RecordData* from = nullptr;
  for (const std::string_view id : {kSegment, kWhole})
    for (const std::vector<RecordData>* records : {&deck.records, &replaced, &deck.shelf})
      for (const RecordData& other : *records)
        if (from == nullptr && other.instance == 1 && other.id == id && other.values.size() > 1)
          from = &other;
  if (from == nullptr) return;
  data.values = from->values;
  data.values[0].clear();  // the label
  for (std::size_t v = 1; v < data.values.size(); ++v)
    for (std::size_t k = 0; k < data.values[v].size(); ++k) data.defaulted.push_back({v, k});
}

/// The record as it was given before, taken off the shelf; without values when it never was.
/// @param replaced as of take_over_cage_start
RecordData from_shelf(Deck& deck, std::string_view id, int instance,
                      const std::vector<RecordData>& replaced = {}) {
  RecordData data;
  const auto known = std::find_if(deck.shelf.begin(), deck.shelf.end(),
                                  [&](const RecordData& r) { return is_at(r, id, instance); });
  if (known != deck.shelf.end()) {
    data = std::move(*known);
    deck.shelf.erase(known);
  }
  data.id = id;
  data.instance = instance;
  if (data.values.empty()) take_over_cage_start(deck, replaced, data);
  return data;
}

/// The record that holds the variable, among those that the present options ask for; it is added
/// with defaults when the deck lacks it. A record that a changed option left over holds nothing.
const VariableRef* find_or_add(Deck& deck, std::span<const VariableRef> refs, int instance) {
  for (const VariableRef& ref : refs) {
    if (!evaluate(ref.record->condition, condition_scope(deck)) ||
        instance > repeat_count(deck, *ref.record))
      continue;
    if (deck.has_record(ref.record->id, instance)) return &ref;
    RecordData data = from_shelf(deck, ref.record->id, instance);
    const auto placed =
        deck.records.insert(place_of(deck.records, *ref.record, instance), std::move(data));
    fill_with_defaults(deck, static_cast<std::size_t>(placed - deck.records.begin()));
    return &ref;
  }
  return nullptr;
}

/// One element, or a whole array, of one instance of a record.
struct Place {
  const VariableRef* ref = nullptr;
  int instance = 1;
  std::optional<std::size_t> element;  ///< from 0; empty for a whole array
};

/// Finds what `target` means in this deck; `name` and `value` are for messages only.
Place locate(Deck& deck, const Target& target, std::string_view name, std::string_view value) {
  const std::span<const VariableRef> refs = find_variable(target.name);
  if (refs.empty()) fail_unknown(target.name, value);
  Place place;
  const bool repeated = std::any_of(refs.begin(), refs.end(), [&](const VariableRef& candidate) {
    return !candidate.record->repeat.empty() &&
           evaluate(candidate.record->condition, condition_scope(deck));
  });
  if (repeated && !target.indices.empty()) place.instance = target.indices[0];
  place.ref = find_or_add(deck, refs, place.instance);
  if (place.ref == nullptr && place.instance > 1 && find_or_add(deck, refs, 1) != nullptr)
    fail(name, value,
         fmt::format("the deck does not have instance {} of this record", place.instance),
         "give a smaller instance number, or increase the number of instances");
  if (place.ref == nullptr)
    fail(name, value, "the deck does not have the record of this variable",
         fmt::format("the variable is on {}; also set the options so that this condition is met",
                     condition_of(refs)));

  const RecordSpec& record = *place.ref->record;
  const int count = record.repeat.empty() ? 1 : repeat_count(deck, record);
  if (count > 1 && target.indices.empty())
    fail(name, value, fmt::format("the deck has {} instances of this variable", count),
         fmt::format("choose one instance, such as {}[1]", target.name));
  const std::size_t used = record.repeat.empty() || target.indices.empty() ? 0 : 1;
  const bool is_array = place.ref->spec().length != "1";
  if (target.indices.size() > used) {
    const int length = is_array ? array_length(deck, place.ref->spec()) : 0;
    if (target.indices[used] > length)
      fail(name, value,
           is_array ? "this variable has " + counted(length, "element")
                    : "this variable is a single value",
           is_array ? "give a smaller index, or first increase the number of elements"
                    : "omit the index");
    place.element = static_cast<std::size_t>(target.indices[used]) - 1;
  } else if (!is_array) {
    place.element = 0;
  }
  return place;
}

/// Does a variable of the orbit act from the shelf (deck/orbit_records.hpp)?
bool is_orbit_at_rest(const Deck& deck, std::string_view name) {
  return deck.has("mode") && *find_value(deck, "mode") == Value(-1LL) && is_orbit_variable(name);
}

/// One of several sets.
struct Pending {
  const std::pair<std::string, std::string>* text = nullptr;
  Target target;
  bool done = false;
};

/// The sets as targets. @throws InputError with every name that cannot be understood, and every
/// pair that gives one target two values.
std::vector<Pending> parse_all(std::span<const std::pair<std::string, std::string>> sets) {
  std::vector<Pending> out;
  std::vector<Issue> issues;
  for (const auto& text : sets) try {
      Pending pending{&text, parse_target(text.first)};
      if (find_variable(pending.target.name).empty())
        fail_unknown(pending.target.name, text.second);
      const auto same = std::find_if(out.begin(), out.end(), [&](const Pending& other) {
        return other.target.name == pending.target.name &&
               other.target.indices == pending.target.indices;
      });
      if (same == out.end())
        out.push_back(std::move(pending));
      else if (trimmed(same->text->second) != trimmed(text.second))
        fail(text.first, text.second,
             fmt::format("is set twice, to {} and to {}", same->text->second, text.second),
             "set the variable once");
    } catch (const InputError& error) {
      issues.insert(issues.end(), error.issues().begin(), error.issues().end());
    }
  if (!issues.empty()) throw InputError(std::move(issues));
  // Of one variable the whole array comes before an element of it.
  std::stable_sort(out.begin(), out.end(), [](const Pending& a, const Pending& b) {
    return a.target.indices.size() < b.target.indices.size();
  });
  return out;
}

}  // namespace

void Deck::set_all(std::span<const std::pair<std::string, std::string>> sets) {
  std::vector<Pending> pending = parse_all(sets);
  Deck changed = *this;
  std::vector<Issue> issues;
  const auto apply = [&](Pending& item) {
    item.done = true;
    try {
      changed.set(item.text->first, item.text->second);
    } catch (const InputError& error) {
      issues.insert(issues.end(), error.issues().begin(), error.issues().end());
    }
  };
  // In deck order, so that options that control the presence or length of a record have their
  // values before the record.
  for (const RecordSpec& record : schema())
    for (const VariableSpec& variable : record.variables)
      for (Pending& item : pending) {
        if (item.done || item.target.name != variable.name) continue;
        changed.complete();
        if (changed.has_record(record.id) || is_orbit_at_rest(changed, variable.name)) apply(item);
      }
  for (Pending& item : pending)
    if (!item.done) apply(item);  // no record has it: set() reports the reason
  if (!issues.empty()) throw InputError(std::move(issues));
  changed.complete();
  records = std::move(changed.records);
  shelf = std::move(changed.shelf);
}

void Deck::set(std::string_view name, std::string_view value) {
  Deck changed = *this;  // so that a mistake leaves this deck as it is
  const Target target = parse_target(name);
  if (is_orbit_at_rest(changed, target.name)) {  // as in motion, then back
    changed.set("mode", "0");
    changed.complete();
    changed.set(name, value);
    changed.set("mode", "-1");
    changed.complete();
    *this = std::move(changed);
    return;
  }
  const Place place = locate(changed, target, name, value);
  const VariableSpec& spec = place.ref->spec();

  const auto record =
      std::find_if(changed.records.begin(), changed.records.end(), [&](const RecordData& data) {
        return data.id == place.ref->record->id && data.instance == place.instance;
      });
  fill_with_defaults(changed, static_cast<std::size_t>(record - changed.records.begin()));
  std::vector<Value>& elements = record->values[place.ref->position];
  std::erase_if(record->defaulted, [&](const RecordData::Element& at) {
    return at.variable == place.ref->position && (!place.element || at.element == *place.element);
  });
  const auto parsed = [&](std::string_view text) {
    return is_extension(place.ref->record->id) ? parse_extension(spec, name, text, units())
                                               : parse_value(spec, name, text);
  };
  if (place.element) {
    elements.at(*place.element) = parsed(value);
  } else if (is_extension(place.ref->record->id) && value.find(',') == std::string_view::npos) {
    for (Value& element : elements) element = parsed(value);  // one value for all
  } else {
    const std::vector<std::string_view> parts = split_at_commas(value);
    if (elements.empty())
      fail(name, value, "this variable has no elements in this deck",
           fmt::format("first increase {}, which is the number of elements", spec.length));
    if (parts.size() != elements.size())
      fail(name, value, "this variable has " + counted(elements.size(), "element"),
           fmt::format("give {} separated by commas, or set one element, such as {}[1]",
                       counted(elements.size(), "value"), target.name));
    for (std::size_t i = 0; i < parts.size(); ++i) elements[i] = parsed(parts[i]);
  }
  records = std::move(changed.records);
  shelf = std::move(changed.shelf);
}

void Deck::complete() {
  std::vector<RecordData> old = std::move(records);
  records.clear();
  for (const RecordSpec& spec : schema()) {
    if (spec.id == "12" || !evaluate(spec.condition, condition_scope(*this))) continue;
    if (is_extension(spec.id)) {  // only as given
      const auto given = std::find_if(
          old.begin(), old.end(), [&](const RecordData& data) { return is_at(data, spec.id, 1); });
      if (given == old.end()) continue;
      records.push_back(std::move(*given));
      old.erase(given);
      continue;
    }
    const int count = repeat_count(*this, spec);
    for (int instance = 1; instance <= count; ++instance) {
      const auto known = std::find_if(old.begin(), old.end(), [&](const RecordData& data) {
        return is_at(data, spec.id, instance);
      });
      if (known != old.end()) {
        records.push_back(std::move(*known));
        old.erase(known);
      } else {
        records.push_back(from_shelf(*this, spec.id, instance, old));
      }
      fill_with_defaults(*this, records.size() - 1);
    }
  }
  for (RecordData& dropped : old) {
    std::erase_if(
        shelf, [&](const RecordData& data) { return is_at(data, dropped.id, dropped.instance); });
    shelf.push_back(std::move(dropped));
  }
}

}  // namespace adore::deck
