#include "studies/study_json.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::studies {
namespace {

constexpr std::size_t kMaxValueLength = 80;

std::string shown(const nlohmann::ordered_json& value) {
  std::string text = dump_json(value);
  if (text.size() > kMaxValueLength) text = text.substr(0, kMaxValueLength) + "...";
  return text;
}

}  // namespace

JsonObject::JsonObject(const nlohmann::ordered_json& json, std::string where)
    : json_(json), where_(std::move(where)) {
  if (!json.is_object())
    throw InputError(fmt::format("{}{} {}: give an object {{\"key\": value, ...}}", where_,
                                 where_.ends_with(':') ? "" : " =", shown(json)));
}

bool JsonObject::has(std::string_view key) const {
  known_.emplace_back(key);
  return json_.contains(std::string(key));
}

std::string JsonObject::at(std::string_view key) const {
  return fmt::format("{}{}{}", where_, where_.ends_with(':') ? " " : ".", key);
}

void JsonObject::refuse(std::string_view key, std::string_view valid) const {
  const auto found = json_.find(std::string(key));
  throw InputError(found == json_.end()
                       ? fmt::format("{} is missing: give {}", at(key), valid)
                       : fmt::format("{} = {}: give {}", at(key), shown(*found), valid));
}

const nlohmann::ordered_json& JsonObject::get(std::string_view key, std::string_view valid) {
  asked_.emplace_back(key);
  const auto found = json_.find(std::string(key));
  if (found == json_.end()) refuse(key, valid);
  return *found;
}

std::string JsonObject::text(std::string_view key, std::string_view valid) {
  const auto& value = get(key, valid);
  if (!value.is_string()) refuse(key, valid);
  return value.get<std::string>();
}

double JsonObject::number(std::string_view key, std::string_view valid) {
  const auto& value = get(key, valid);
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(key, valid);
  return value.get<double>();
}

long JsonObject::whole(std::string_view key, long least, long most, std::string_view valid) {
  const auto& value = get(key, valid);
  // 1e3 is written as a real number but is whole.
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number == std::floor(number) && number >= static_cast<double>(least) &&
        number <= static_cast<double>(most)))
    refuse(key, valid);
  return static_cast<long>(number);
}

bool JsonObject::boolean(std::string_view key) {
  const auto& value = get(key, "true or false");
  if (!value.is_boolean()) refuse(key, "true or false");
  return value.get<bool>();
}

std::vector<double> JsonObject::numbers(std::string_view key, std::size_t least, std::size_t most,
                                        std::string_view valid) {
  const auto& value = get(key, valid);
  if (!value.is_array() || value.size() < least || value.size() > most) refuse(key, valid);
  std::vector<double> out;
  for (const auto& item : value) {
    if (!item.is_number() || !std::isfinite(item.get<double>())) refuse(key, valid);
    out.push_back(item.get<double>());
  }
  return out;
}

std::vector<std::string> JsonObject::texts(std::string_view key, std::string_view valid) {
  const auto& value = get(key, valid);
  if (!value.is_array()) refuse(key, valid);
  std::vector<std::string> out;
  for (const auto& item : value) {
    if (!item.is_string()) refuse(key, valid);
    out.push_back(item.get<std::string>());
  }
  return out;
}

void JsonObject::reject_unknown_keys() const {
  for (const auto& [key, value] : json_.items()) {
    if (key.starts_with("//")) continue;
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    std::vector<std::string> known = known_;
    known.insert(known.end(), asked_.begin(), asked_.end());
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    std::erase(known, key);  // known, but not used with the others
    const auto nearest =
        std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
          return edit_distance(a, key) < edit_distance(b, key);
        });
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    throw InputError(fmt::format(
        "{} is not used here{}; valid keys are {}, and keys that begin with \"//\" (comments)",
        at(key),
        nearest != known.end() && edit_distance(*nearest, key) <= 3
            ? fmt::format("; do you mean \"{}\"?", *nearest)
            : std::string(),
        list));
  }
}

}  // namespace adore::studies
