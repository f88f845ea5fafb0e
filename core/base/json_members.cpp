#include "base/json_members.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace adore {

using Json = nlohmann::json;

JsonMembers::JsonMembers(const Json& object, std::string where)
    : object_(&object), where_(std::move(where)) {
  if (!object.is_object()) reject("must be an object { ... }");
}

void JsonMembers::reject(const std::string& problem) const {
  throw InputError(fmt::format("{}: {}", where_, problem));
}

const Json* JsonMembers::find(std::string_view name) {
  queried_names_.emplace(name);
  const auto found = object_->find(name);
  return found == object_->end() ? nullptr : &*found;
}

const Json& JsonMembers::at(std::string_view name) {
  const Json* const found = find(name);
  if (found == nullptr) reject(fmt::format("member \"{}\" is missing", name));
  return *found;
}

std::string JsonMembers::text(std::string_view name) {
  const Json& value = at(name);
  if (!value.is_string() || value.get_ref<const std::string&>().empty())
    reject(fmt::format("member \"{}\" must be a text in quotes", name));
  return value.get<std::string>();
}

std::string JsonMembers::text(std::string_view name, std::string fallback) {
  return find(name) == nullptr ? std::move(fallback) : text(name);
}

double JsonMembers::number(std::string_view name) {
  const Json& value = at(name);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    reject(fmt::format("member \"{}\" must be a finite number", name));
  return value.get<double>();
}

double JsonMembers::number(std::string_view name, double fallback) {
  return find(name) == nullptr ? fallback : number(name);
}

int JsonMembers::integer(std::string_view name) {
  const double value = number(name);
  if (value != std::floor(value) || std::abs(value) > 1e9)
    reject(fmt::format("member \"{}\" must be a whole number", name));
  return static_cast<int>(value);
}

std::vector<double> JsonMembers::numbers(std::string_view name) {
  const Json& value = at(name);
  if (!value.is_array() || value.empty())
    reject(fmt::format("member \"{}\" must be a list of numbers", name));
  std::vector<double> out;
  for (const Json& one : value) {
    if (!one.is_number() || !std::isfinite(one.get<double>()))
      reject(fmt::format("member \"{}\" must be a list of finite numbers", name));
    out.push_back(one.get<double>());
  }
  return out;
}

std::vector<std::string> JsonMembers::texts(std::string_view name) {
  std::vector<std::string> out;
  const Json* const value = find(name);
  if (value == nullptr) return out;
  if (!value->is_array()) reject(fmt::format("member \"{}\" must be a list of strings", name));
  for (const Json& one : *value) {
    if (!one.is_string()) reject(fmt::format("member \"{}\" must be a list of strings", name));
    out.push_back(one.get<std::string>());
  }
  return out;
}

std::vector<JsonMembers> JsonMembers::objects(std::string_view name, std::string_view item) {
  std::vector<JsonMembers> out;
  const Json* const value = find(name);
  if (value == nullptr) return out;
  if (!value->is_array()) reject(fmt::format("member \"{}\" must be a list of objects", name));
  for (const Json& one : *value)
    out.emplace_back(one, fmt::format("{}, {} {}", where_, item, out.size() + 1));
  return out;
}

void JsonMembers::finish() const {
  for (const auto& [name, value] : object_->items())
    if (queried_names_.count(name) == 0)
      reject(fmt::format("unknown member \"{}\". Use one of {}", name,
                         fmt::join(queried_names_, ", ")));
}

}  // namespace adore
