#include "calculators/calculator_gate.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "calculators/calculator_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace adore::calculators {
namespace {

using Json = nlohmann::json;

bool equal_in_any_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

/// The value at a path without lists; null when it is not there. "approach_list[]" is the list.
const Json* find_value(const Json& inputs, std::string_view path) {
  const Json* at = &inputs;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    std::string_view key = path.substr(0, end);
    const std::size_t bracket = key.find('[');
    if (!at->is_object()) return nullptr;
    const auto found = at->find(std::string(key.substr(0, bracket)));
    if (found == at->end()) return nullptr;
    at = &*found;
    if (bracket != std::string_view::npos) return at;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return at;
}

/// Schema paths of the values that are given: "Qi[]", "lands[].race".
void collect_given(const Json& value, const std::string& path, std::set<std::string>& out) {
  if (value.is_object()) {
    for (const auto& [key, item] : value.items())
      collect_given(item, path.empty() ? key : path + "." + key, out);
  } else if (value.is_array()) {
    if (value.empty()) out.insert(path + "[]");
    for (const Json& item : value) collect_given(item, path + "[]", out);
  } else if (!value.is_null()) {
    out.insert(path);
  }
}

const SchemaInput* find_input(const std::vector<SchemaInput>& inputs, std::string_view name) {
  const auto found = std::find_if(inputs.begin(), inputs.end(),
                                  [&](const SchemaInput& i) { return i.name == name; });
  return found == inputs.end() ? nullptr : &*found;
}

/// The value that a condition looks at: the one given, or the default.
Json value_or_default(const Json& inputs, const std::vector<SchemaInput>& schema,
                      const std::string& path) {
  if (const Json* given = find_value(inputs, path); given != nullptr && !given->is_null())
    return *given;
  const SchemaInput* input = find_input(schema, path);
  return input == nullptr ? Json() : input->default_value;
}

bool same_value(const Json& a, const Json& b) {
  if (a.is_string() && b.is_string())
    return equal_in_any_case(a.get_ref<const std::string&>(), b.get_ref<const std::string&>());
  return a == b;
}

bool is_one_of(const Json& value, const std::vector<Json>& list) {
  return std::any_of(list.begin(), list.end(), [&](const Json& v) { return same_value(value, v); });
}

bool holds(const Condition& condition, const Json& inputs, const std::vector<SchemaInput>& schema) {
  return std::all_of(condition.begin(), condition.end(), [&](const auto& one) {
    return is_one_of(value_or_default(inputs, schema, one.first), one.second);
  });
}

std::string condition_text(const Condition& condition) {
  std::string out;
  for (const auto& [path, values] : condition) {
    std::string list;
    for (const Json& value : values) list += (list.empty() ? "" : " or ") + dump_json(value);
    out += fmt::format("{}{} is {}", out.empty() ? "" : " and ", path, list);
  }
  return out;
}

bool names_kind(const SchemaKind& kind, std::string_view name) {
  const auto same = [&](const std::string& other) { return equal_in_any_case(other, name); };
  return same(kind.name) || same(kind.runs) ||
         std::any_of(kind.aliases.begin(), kind.aliases.end(), same);
}

class InputCheck {
 public:
  InputCheck(const SchemaFamily& family, const SchemaKind& kind, Json& inputs)
      : family_(family), kind_(kind), inputs_(inputs) {}

  void run() {
    object(inputs_, "", "");
    collect_given(inputs_, "", given_);
    check_required();
    check_groups();
    for (const SchemaInput& input : kind_.inputs) check_together(input);
    if (!issues_.empty()) throw InputError(std::move(issues_));
    for (const SchemaInput& input : kind_.inputs)  // labels may be of any type; adapters see none
      if (input.type == "label") erase(input.name);
  }

 private:
  void object(Json& value, const std::string& path, const std::string& shown) {
    const std::string prefix = path.empty() ? "" : path + ".";
    const std::set<std::string> names = names_below(kind_.inputs, prefix);
    for (auto& [key, item] : value.items()) {
      const std::string place = (shown.empty() ? "" : shown + ".") + key;
      if (names.contains(key)) {
        check(item, prefix + key, place);
      } else if (!names_below(family_.inputs, prefix).contains(key)) {
        report(place, item, "there is no such input", spelling_suggestion(key, names, "inputs"));
      } else if (const SchemaInput* other = find_input(family_.inputs, prefix + key);
                 !(item.is_null() && other != nullptr && other->null_meaning)) {
        report(place, item, fmt::format("not used by {}", kind_.name), "remove it");
      }
    }
  }

  void erase(const std::string& path) {
    std::string pointer = "/" + path;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    const Json::json_pointer place(pointer);
    if (inputs_.contains(place)) inputs_.at(place.parent_pointer()).erase(place.back());
  }

  void check(Json& value, const std::string& path, const std::string& shown) {
    if (value.is_object() && !names_below(kind_.inputs, path + ".").empty())
      return object(value, path, shown);
    if (value.is_array() && known(path + "[]")) {
      if (value.empty()) report(shown, value, "the list is empty", "give at least one value");
      for (std::size_t i = 0; i < value.size(); ++i)
        check(value[i], path + "[]", fmt::format("{}[{}]", shown, i));
      return;
    }
    const SchemaInput* input = kind_.find(path);
    if (input == nullptr) {
      const auto below = names_below(kind_.inputs, path + ".");
      return report(shown, value, "wrong type",
                    known(path + "[]")
                        ? std::string("give a list")
                        : fmt::format("give an object with {}", fmt::join(below, ", ")));
    }
    if (!value.is_null() && !holds(input->only_if, inputs_, kind_.inputs) && decided(*input))
      return report(shown, value, fmt::format("only used when {}", condition_text(input->only_if)),
                    "remove it");
    if (const std::string problem = accept(*input, value); !problem.empty())
      report(shown, value, problem, remedy(*input, value));
  }

  /// Empty when the value is right. Codes are rewritten as the schema has them.
  static std::string accept(const SchemaInput& input, Json& value) {
    const bool number_type = input.type == "number" || input.type == "whole number";
    if (value.is_null()) return input.null_meaning ? "" : "null is not a value";
    if (input.type == "label") return value.is_structured() ? "wrong type" : "";
    if (value.is_string()) {
      if (input.type == "name") return "";
      for (const std::string& code : input.codes)
        if (equal_in_any_case(code, value.get_ref<const std::string&>())) {
          value = code;
          return "";
        }
      return number_type           ? "not a number"
             : input.codes.empty() ? "wrong type"
                                   : "not one of the codes";
    }
    if (value.is_boolean()) return input.type == "true or false" ? "" : "wrong type";
    if (!value.is_number() || (!number_type && input.type != "name")) return "wrong type";
    const double number = value.get<double>();
    if (!std::isfinite(number)) return "not a finite number";
    if (input.type != "number" && number != std::round(number)) return "not a whole number";
    if (!input.values.empty())
      return std::find(input.values.begin(), input.values.end(), number) == input.values.end()
                 ? "out of range"
                 : "";
    return input.range.contains(number) ? "" : "out of range";
  }

  static std::string remedy(const SchemaInput& input, const Json& value) {
    if (value.is_string() && input.type == "code")
      return spelling_suggestion(value.get<std::string>(), {input.codes.begin(), input.codes.end()},
                                 "codes");
    return "give " + input.value_text();
  }

  /// Whether the codes in the condition of an input are codes at all; they are reported otherwise.
  [[nodiscard]] bool decided(const SchemaInput& input) const {
    return std::all_of(input.only_if.begin(), input.only_if.end(), [&](const auto& one) {
      const SchemaInput* code = kind_.find(one.first);
      Json value = value_or_default(inputs_, kind_.inputs, one.first);
      return code != nullptr && accept(*code, value).empty();
    });
  }

  [[nodiscard]] bool is_given(const std::string& path) const {
    if (given_.contains(path)) return true;
    const Json* value = find_value(inputs_, path);
    const SchemaInput* input = kind_.find(path);
    return value != nullptr && value->is_null() && input != nullptr && input->null_meaning;
  }

  void missing(const std::string& path, const std::string& why = {}) {
    const Json* value = find_value(inputs_, path);
    if (value != nullptr && !value->is_structured()) return;  // given, and reported if wrong
    const SchemaInput& input = *kind_.find(path);
    report(path, Json(), "missing" + why,
           fmt::format("give {}{}", input.value_text(),
                       input.meaning.empty() ? "" : ": " + input.meaning));
  }

  void check_required() {
    for (const std::string& path : kind_.required)
      if (!is_given(path) && holds(kind_.find(path)->only_if, inputs_, kind_.inputs)) missing(path);
    // Items of a list of objects have all of their inputs but those with a default.
    for (const SchemaInput& input : kind_.inputs) {
      const std::size_t at = input.name.find("[].");
      if (at == std::string::npos || !input.default_value.is_null()) continue;
      const Json* list = find_value(inputs_, input.name.substr(0, at + 2));
      const std::string rest = input.name.substr(at + 3);
      if (list == nullptr || !list->is_array()) continue;
      for (std::size_t i = 0; i < list->size(); ++i)
        if (find_value(list->at(i), rest) == nullptr)
          report(fmt::format("{}[{}].{}", input.name.substr(0, at), i, rest), Json(), "missing",
                 "give " + input.value_text());
    }
  }

  void check_groups() {
    for (const auto& group : kind_.one_of) {
      std::vector<std::string> found;
      for (const std::string& path : group)
        if (given_.contains(path)) found.push_back(path);
      if (found.size() == 1) continue;
      if (found.empty())
        report(group.front(), Json(), "missing",
               fmt::format("give one of {}", fmt::join(group, ", ")));
      else
        report(found.back(), *find_value(inputs_, found.back()),
               fmt::format("cannot be given together with {}", found.front()),
               "remove one of them");
    }
  }

  void check_together(const SchemaInput& input) {
    if (!given_.contains(input.name)) return;
    for (const std::string& other : input.needs)
      if (!given_.contains(other))
        missing(other, fmt::format(" (required together with {})", input.name));
    if (input.length.is_null() || !input.name.ends_with("[]")) return;
    const Json* list = find_value(inputs_, input.name);
    if (list == nullptr || !list->is_array()) return;
    check_length(input, *list, input.name.substr(0, input.name.size() - 2));
  }

  void check_length(const SchemaInput& input, const Json& list, const std::string& shown) {
    if (const std::size_t at = input.name.find("[]."); at != std::string::npos) {
      const std::string rest = input.name.substr(at + 3);
      for (std::size_t i = 0; i < list.size(); ++i)
        if (const Json* inner = find_value(list[i], rest); inner != nullptr && inner->is_array())
          compare_length(input, *inner,
                         fmt::format("{}[{}].{}", input.name.substr(0, at), i, rest));
      return;
    }
    compare_length(input, list, shown);
  }

  void compare_length(const SchemaInput& input, const Json& list, const std::string& shown) {
    double wanted = 0.0;
    std::string of;
    if (input.length.is_number()) {
      wanted = input.length.get<double>();
    } else {
      const std::string other = input.length.get<std::string>();
      const Json* value = find_value(inputs_, other);
      if (value == nullptr) return;
      if (value->is_array())
        wanted = static_cast<double>(value->size());
      else if (value->is_number())
        wanted = value->get<double>();
      else
        return;
      of = " (" + other + ")";
    }
    if (static_cast<double>(list.size()) == wanted) return;
    Issue issue;
    issue.variable = shown;
    issue.message = "the list has " + counted(list.size(), "value");
    issue.remedy = fmt::format("give {}{}", wanted, of);
    issues_.push_back(std::move(issue));
  }

  [[nodiscard]] bool known(const std::string& path) const {
    return std::any_of(kind_.inputs.begin(), kind_.inputs.end(),
                       [&](const SchemaInput& i) { return i.name.starts_with(path); });
  }

  /// Keys that may follow a path that ends with a point.
  static std::set<std::string> names_below(const std::vector<SchemaInput>& inputs,
                                           const std::string& prefix) {
    std::set<std::string> out;
    for (const SchemaInput& input : inputs)
      if (input.name.starts_with(prefix))
        out.insert(input.name.substr(
            prefix.size(), input.name.find_first_of(".[", prefix.size()) - prefix.size()));
    return out;
  }

  void report(std::string path, const Json& value, std::string message, std::string remedy) {
    Issue issue;
    issue.variable = std::move(path);
    if (!value.is_null() && !value.is_structured()) issue.value = dump_json(value);
    issue.message = std::move(message);
    issue.remedy = std::move(remedy);
    issues_.push_back(std::move(issue));
  }

  const SchemaFamily& family_;
  const SchemaKind& kind_;
  Json& inputs_;
  std::set<std::string> given_;
  std::vector<Issue> issues_;
};

/// The number of inputs that this kind does not take or lacks; codes of another kind outweigh all.
std::size_t misfits(const SchemaKind& kind, const SchemaFamily& family, const Json& inputs,
                    const std::set<std::string>& given) {
  constexpr std::size_t kOtherCode = 10'000;
  std::size_t out = 0;
  for (const auto& [path, codes] : kind.when) {
    const Json value = value_or_default(inputs, family.inputs, path);
    if (!is_one_of(value, codes)) out += kOtherCode;
  }
  for (const std::string& path : given)
    if (kind.find(path) == nullptr) ++out;
  for (const std::string& path : kind.required)
    if (!given.contains(path) && !kind.find(path)->null_meaning &&
        holds(kind.find(path)->only_if, inputs, kind.inputs))
      ++out;
  for (const auto& group : kind.one_of)
    if (std::none_of(group.begin(), group.end(), [&](const auto& p) { return given.contains(p); }))
      ++out;
  return out;
}

const SchemaKind& select_kind(const SchemaFamily& family,
                              const std::vector<const SchemaKind*>& kinds, const Json& inputs) {
  std::set<std::string> given;
  collect_given(inputs, "", given);
  const SchemaKind* best = kinds.front();
  std::size_t least = misfits(*best, family, inputs, given);
  for (const SchemaKind* kind : kinds)
    if (const std::size_t now = misfits(*kind, family, inputs, given); now < least) {
      least = now;
      best = kind;
    }
  return *best;
}

/// A code that selects the kind but is none of its family is reported before anything else.
void check_selecting_codes(const std::vector<const SchemaKind*>& kinds, const SchemaFamily& family,
                           const Json& inputs) {
  std::map<std::string, std::set<std::string>> codes;
  for (const SchemaKind* kind : kinds)
    for (const auto& [path, values] : kind->when)
      for (const Json& value : values) codes[path].insert(value.get<std::string>());
  for (const auto& [path, allowed] : codes) {
    const Json* value = find_value(inputs, path);
    if (value == nullptr || !value->is_string()) continue;
    const std::string& text = value->get_ref<const std::string&>();
    const SchemaInput* input = find_input(family.inputs, path);
    const auto same = [&](const std::string& code) { return equal_in_any_case(code, text); };
    if (std::any_of(allowed.begin(), allowed.end(), same) ||
        (input != nullptr && std::any_of(input->codes.begin(), input->codes.end(), same)))
      continue;
    Issue issue;
    issue.variable = path;
    issue.value = dump_json(*value);
    issue.message = "not one of the codes";
    issue.remedy = spelling_suggestion(text, allowed, "codes");
    throw InputError(std::vector<Issue>{issue});
  }
}

/// Takes the kind of calculation out of the case: next to "inputs", or among them where "kind" is
/// not an input.
std::string take_kind(Json& the_case, const std::vector<const SchemaKind*>& kinds,
                      const SchemaFamily& family) {
  Json& inputs = the_case.at("inputs");
  const auto own = inputs.find("kind");
  if (const auto kind = the_case.find("kind"); kind != the_case.end()) {
    if (!kind->is_string())
      throw InputError(
          fmt::format("\"kind\" = {}: must be a string; give the name of a kind of calculation",
                      dump_json(*kind)));
    if (own != inputs.end() && *own == *kind && find_input(family.inputs, "kind") == nullptr)
      inputs.erase("kind");
    return kind->get<std::string>();
  }
  if (own == inputs.end() || !own->is_string()) return {};
  const std::string name = *own;
  const bool names_one = std::any_of(
      kinds.begin(), kinds.end(), [&](const SchemaKind* kind) { return names_kind(*kind, name); });
  if (find_input(family.inputs, "kind") != nullptr && !names_one) return {};
  inputs.erase("kind");
  return name;
}

void check_value(const SchemaFamily& family, std::string_view calculator, const Json& value,
                 const std::string& path) {
  if (value.is_object()) {
    for (const auto& [key, item] : value.items())
      check_value(family, calculator, item, path.empty() ? key : path + "." + key);
  } else if (value.is_array()) {
    for (const Json& item : value) check_value(family, calculator, item, path + "[]");
  } else if (value.is_number()) {
    const double number = value.get<double>();
    const auto row = std::find_if(family.results.begin(), family.results.end(),
                                  [&](const SchemaResult& r) { return r.name == path; });
    const bool sound =
        std::isfinite(number) && (row == family.results.end() || row->range.contains(number));
    if (!sound)
      throw InputError(
          fmt::format("calculator {}: these inputs give {} = {:.4g}, which is physically "
                      "impossible; `adore calc {} --describe` lists the range of each input",
                      calculator, path, number, calculator));
  }
}

}  // namespace

Json check_inputs(std::string_view family, std::string_view adapter_kind, Json the_case) {
  const SchemaFamily* schema = family_schema(family);
  if (schema == nullptr) return the_case;
  std::vector<const SchemaKind*> kinds = calculation_kinds(*schema, adapter_kind);
  if (kinds.empty()) return the_case;
  const std::string name = take_kind(the_case, kinds, *schema);
  if (!name.empty()) {
    std::set<std::string> names;
    for (const SchemaKind* kind : kinds) names.insert(kind->name);
    std::erase_if(kinds, [&](const SchemaKind* kind) { return !names_kind(*kind, name); });
    if (kinds.empty())
      throw InputError(fmt::format("kind \"{}\": there is no such kind of calculation; {}", name,
                                   spelling_suggestion(name, names, "kinds")));
  }
  Json& inputs = the_case.at("inputs");
  check_selecting_codes(kinds, *schema, inputs);
  const SchemaKind& kind = select_kind(*schema, kinds, inputs);
  InputCheck(*schema, kind, inputs).run();
  the_case["kind"] = kind.runs;
  return the_case;
}

void check_results(std::string_view family, std::string_view calculator, const Json& results) {
  if (results.is_object() && results.contains("error"))
    throw InputError(fmt::format("calculator {}: these inputs have no solution: {}", calculator,
                                 results.value("message", dump_json(results.at("error")))));
  if (const SchemaFamily* schema = family_schema(family); schema != nullptr)
    check_value(*schema, calculator, results, "");
}

}  // namespace adore::calculators
