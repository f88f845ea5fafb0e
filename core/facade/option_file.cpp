#include "facade/option_file.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "setup/option_choices.hpp"
#include "setup/run_control.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

namespace adore::facade {
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

fs::path OptionFile::path_beside(const fs::path& deck_file) {
  return deck_file.parent_path() / "ADORE.json";
}

OptionFile OptionFile::beside(const fs::path& deck_file) {
  const fs::path path = path_beside(deck_file);
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
    const std::optional<std::string> as_text = text_of(value);
    if (find_option(name) == nullptr || !as_text)
      out.strange_.push_back(name);
    else
      out.values_[name] = *as_text;
  }
  return out;
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

}  // namespace adore::facade
