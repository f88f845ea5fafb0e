#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Keys of a study file, read one by one; unread keys are rejected at the end.
namespace adore::studies {

class JsonObject {
 public:
  /// @param where "clearance.json: variables[2]", for messages; the file itself with its colon,
  /// "clearance.json:". @throws InputError for no object
  JsonObject(const nlohmann::ordered_json& json, std::string where);

  [[nodiscard]] bool has(std::string_view key) const;
  /// "clearance.json: variables[2].normal"
  [[nodiscard]] std::string at(std::string_view key) const;

  /// @throws InputError when the key is missing or has another type; `valid` describes valid
  /// values.
  [[nodiscard]] const nlohmann::ordered_json& get(std::string_view key, std::string_view valid);
  [[nodiscard]] std::string text(std::string_view key, std::string_view valid);
  [[nodiscard]] double number(std::string_view key, std::string_view valid);
  [[nodiscard]] long whole(std::string_view key, long least, long most, std::string_view valid);
  [[nodiscard]] bool boolean(std::string_view key);
  /// `least` to `most` finite numbers.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t least,
                                            std::size_t most, std::string_view valid);
  [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::string_view valid);
  /// @throws InputError for keys that nobody asked for, with the nearest known one. Keys that
  /// begin with "//" are remarks.
  void reject_unknown_keys() const;

  /// "KEY = VALUE: valid"
  [[noreturn]] void refuse(std::string_view key, std::string_view valid) const;

 private:
  const nlohmann::ordered_json& json_;
  std::string where_;
  std::vector<std::string> asked_;
  mutable std::vector<std::string> known_;
};

}  // namespace adore::studies
