#include "runs/option_file.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/spelling.hpp"
#include "deck/check.hpp"
#include "deck/lookup.hpp"
#include "setup/option_choices.hpp"
#include "setup/run_control.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

namespace adore::runs {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

const RunOptionInfo* find_option(std::string_view name) {
  const auto& all = run_options();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const RunOptionInfo& o) { return o.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// As a run reads it; nothing for a list or an object.
std::optional<std::string> text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return std::string(1, value.get<bool>() ? '1' : '0');
  if (value.is_number()) return dump_json(value);
  return std::nullopt;
}

bool is_variable(std::string_view name) {
  const auto refs = deck::find_variable(name);
  return !refs.empty() && deck::is_extension(refs.front().record->id);
}

/// Of a variable: also a list.
std::optional<std::string> variable_text(const Json& value) {
  if (!value.is_array()) return value.is_boolean() ? std::nullopt : text_of(value);
  std::string out;
  for (const Json& element : value) {
    const std::optional<std::string> text = variable_text(element);
    if (!text || element.is_array()) return std::nullopt;
    out += (&element == &value.front() ? "" : ",") + *text;
  }
  return out;
}

constexpr const char* kVersion = "version";

/// A number where the text is one as JSON writes it, so that the file reads naturally.
Json json_of(const std::string& text) {
  const Json parsed = Json::parse(text, nullptr, false);
  return parsed.is_number() && dump_json(parsed) == text ? parsed : Json(text);
}

}  // namespace

const std::vector<RunOptionInfo>& run_options() {
  static const std::vector<RunOptionInfo> list = [] {
    std::vector<RunOptionInfo> out;
    for (setup::OptionInfo& option : setup::run_option_list())
      out.push_back(
          {option.name, option.default_value, option.meaning, setup::option_choices(option.name)});
    return out;
  }();
  return list;
}

std::string option_problem(std::string_view name, std::string_view value) {
  const RunOptionInfo* option = find_option(name);
  if (option == nullptr) return "is not a run option";
  try {
    (void)setup::build_run_options({{std::string(name), std::string(value)}});
    return {};
  } catch (const InputError&) {
    return "is not valid: " + option->meaning;
  }
}

bool same_option(std::string_view a, std::string_view b) {
  if (a == b) return true;
  const std::optional<double> x = number_in(a), y = number_in(b);
  return x && y && *x == *y && std::abs(*x) < 1e15;  // beyond that whole numbers run together
}

fs::path OptionFile::path_for_deck(const fs::path& deck_file) {
  return deck_file.parent_path() / "ADORE.json";
}

OptionFile OptionFile::of_deck(const fs::path& deck_file) {
  const fs::path path = path_for_deck(deck_file);
  std::error_code error;
  if (!fs::exists(path, error)) return {};
  if (!is_plain_file(path)) {
    OptionFile out;
    out.exists_ = true;
    out.problem_ = "is not a file";
    return out;
  }
  InputFile file(path);
  OptionFile out = from_text({std::istreambuf_iterator<char>(file), {}});
  if (!file) out.problem_ = "cannot be read";
  return out;
}

OptionFile OptionFile::from_text(std::string text) {
  OptionFile out;
  out.exists_ = true;
  out.text_ = std::move(text);
  Json json;
  try {
    json = parse_json<Json>(out.text_, "");
  } catch (const InputError& error) {
    out.problem_ = error.what();
    return out;
  }
  if (!json.is_object()) {
    out.problem_ = "must contain one object of run options, such as {\"ellipseMajor\": 20}";
    return out;
  }
  for (const auto& [name, value] : json.items()) {
    if (name == kVersion) {
      if (!value.is_number_integer() || value != kExtensionVersion)
        out.problem_ = fmt::format("has \"version\": {}, but this program reads version {}",
                                   dump_json(value), kExtensionVersion);
      continue;
    }
    const bool option = find_option(name) != nullptr;
    const std::optional<std::string> as_text = option ? text_of(value) : variable_text(value);
    if ((!option && !is_variable(name)) || !as_text)
      out.unknown_names_.push_back(name);
    else if (option)
      out.values_[name] = *as_text;
    else
      out.variables_.emplace_back(name, *as_text);
  }
  if (!out.variables_.empty() && !json.contains(kVersion))
    out.problem_ = fmt::format("has the variable {}; a file with variables needs \"version\": {}",
                               out.variables_.front().first, kExtensionVersion);
  return out;
}

std::string unknown_name_text(std::string_view name) {
  if (find_option(name) != nullptr)
    return fmt::format("run option {} must be a number, a string or true/false", name);
  if (is_variable(name))
    return fmt::format("variable {} must be a number, a string with a unit, or a list of them",
                       name);
  std::string names;
  const auto add = [&](std::string_view similar) {
    names += (names.empty() ? "" : ", ") + std::string(similar);
  };
  for (const std::string_view similar : deck::similar_variables(name))
    if (is_variable(similar)) add(similar);
  for (const RunOptionInfo& option : run_options())
    if (edit_distance(name.substr(0, 40), option.name) <= 2) add(option.name);
  return fmt::format(
      "there is no run option named \"{}\" and no variable with this name in records X; {}", name,
      names.empty()
          ? std::string("`adore run --list-options` and `adore schema` list the valid names")
          : fmt::format("did you mean {}?", names));
}

OptionFile usable_options_of_deck(const fs::path& deck_file) {
  const fs::path path = OptionFile::path_for_deck(deck_file);
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return {};
  OptionFile out = OptionFile::from_text(read_text_file(path));
  if (!out.problem().empty()) throw InputError(fmt::format("{}: {}", path.string(), out.problem()));
  std::vector<Issue> issues;
  for (const std::string& name : out.unknown_names()) {
    Issue issue;
    issue.file = path.string();
    issue.message = unknown_name_text(name);
    issues.push_back(std::move(issue));
  }
  if (!issues.empty()) throw InputError(std::move(issues));
  return out;
}

std::vector<Issue> set_extension(deck::Deck& deck, const OptionFile& file,
                                 const fs::path& deck_file) {
  std::vector<Issue> issues;
  if (file.variables().empty()) return issues;
  const std::string path = OptionFile::path_for_deck(deck_file).string();
  const auto add = [&](Issue issue) {
    issue.file = path;
    issue.line = 0;
    issues.push_back(std::move(issue));
  };
  for (const auto& [name, value] : file.variables()) try {
      const bool given = deck.has(name);
      const std::vector<deck::RecordData> before = deck.records;
      deck.set(name, value);
      if (given && deck.records != before)
        add(deck.issue(Severity::Error, name, "has a different value in the deck file",
                       "give the variable either in the deck file or in this file"));
    } catch (const InputError& error) {
      for (const Issue& issue : error.issues()) add(issue);
    }
  for (const Issue& issue : deck::check_deck(deck))
    if (deck::is_extension(issue.record)) {
      if (issue.severity == Severity::Error)
        add(issue);
      else
        issues.push_back(issue);  // of the deck: a set may remove it
    }
  return issues;
}

deck::Deck without_extension(deck::Deck deck) {
  std::erase_if(deck.records,
                [](const deck::RecordData& data) { return deck::is_extension(data.id); });
  return deck;
}

std::string OptionFile::with(const std::map<std::string, std::string>& values) const {
  Json json = problem_.empty() && exists_ ? Json::parse(text_) : Json::object();
  bool changed = false;
  for (const RunOptionInfo& option : run_options()) {
    const auto given = values.find(option.name);
    const auto old = values_.find(option.name);
    const bool wanted = given != values.end() && !same_option(given->second, option.default_value);
    if (wanted && old != values_.end() && old->second == given->second) continue;
    if (!wanted && old == values_.end()) continue;
    changed = true;
    if (wanted)
      json[option.name] = json_of(given->second);
    else
      json.erase(option.name);
  }
  return changed ? dump_json(json, 2) + "\n" : text_;
}

std::string OptionFile::with_variables(const deck::Deck& deck) const {
  Json json = problem_.empty() && exists_ ? Json::parse(text_) : Json::object();
  deck::Deck before = without_extension(deck);
  for (const auto& [name, value] : variables_) try {
      before.set(name, value);
    } catch (const InputError&) {  // it is replaced
    }
  bool changed = false, any = false;
  for (const deck::RecordSpec& spec : deck::schema()) {
    if (!deck::is_extension(spec.id)) continue;
    const deck::RecordData* is = deck::find_record_data(deck, spec.id);
    const deck::RecordData* was = deck::find_record_data(before, spec.id);
    for (std::size_t v = 1; v < spec.variables.size(); ++v) {
      const std::string name(spec.variables[v].name);
      const auto elements = [&](const deck::RecordData* record) {
        const auto length = static_cast<std::size_t>(deck::array_length(deck, spec.variables[v]));
        return record == nullptr ? std::vector<deck::Value>(length) : record->values[v];
      };
      const std::vector<deck::Value> now = elements(is);
      const bool given = std::any_of(now.begin(), now.end(), [](const deck::Value& value) {
        return !std::holds_alternative<std::monostate>(value);
      });
      any = any || given;
      if (now == elements(was) && given == json.contains(name)) continue;
      changed = true;
      json.erase(name);
      if (!given) continue;
      Json list = Json::array();
      for (const deck::Value& value : now)
        if (const std::string* text = std::get_if<std::string>(&value))
          list.push_back(*text);
        else
          list.push_back(json_of(deck::value_text(value)));
      json[name] = list.size() == 1 ? list.front() : list;
    }
  }
  if (any && !json.contains(kVersion)) {
    changed = true;
    json[kVersion] = kExtensionVersion;
  }
  return changed ? dump_json(json, 2) + "\n" : text_;
}

}  // namespace adore::runs
