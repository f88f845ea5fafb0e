#pragma once

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Members of a JSON object that a schema describes: each is read by name and type, and
/// finish() rejects unread members.
namespace adore {

class JsonMembers {
 public:
  /// @param where begins every message: "experiments.json, NASA-35, run 2"
  /// @throws InputError when it is not an object
  JsonMembers(const nlohmann::json& object, std::string where);

  /// nullptr when there is none.
  [[nodiscard]] const nlohmann::json* find(std::string_view name);
  /// @throws InputError when it is missing
  [[nodiscard]] const nlohmann::json& at(std::string_view name);
  /// @throws InputError when it is missing or has another type; a text must not be empty
  [[nodiscard]] std::string text(std::string_view name);
  [[nodiscard]] double number(std::string_view name);
  [[nodiscard]] int integer(std::string_view name);
  [[nodiscard]] std::vector<double> numbers(std::string_view name);
  [[nodiscard]] std::vector<std::string> texts(std::string_view name);
  /// The fallback when it is missing.
  [[nodiscard]] std::string text(std::string_view name, std::string fallback);
  [[nodiscard]] double number(std::string_view name, double fallback);
  /// Objects of an array, each with its place: "where, run 2". Empty when it is missing.
  [[nodiscard]] std::vector<JsonMembers> objects(std::string_view name, std::string_view item);

  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  void set_where(std::string where) { where_ = std::move(where); }
  /// @throws InputError "where: <problem>"
  [[noreturn]] void reject(const std::string& problem) const;
  /// @throws InputError naming the members that nobody asked for, and those that the schema knows
  void finish() const;

 private:
  const nlohmann::json* object_;
  std::string where_;
  std::set<std::string, std::less<>> queried_names_;
};

}  // namespace adore
