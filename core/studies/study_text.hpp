#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

/// The two ways to write a study file, JSON and TOML, as one value and back.
namespace adore::studies {

struct StudyText {
  nlohmann::ordered_json json;       ///< remarks are keys that begin with "//"
  std::map<std::string, int> lines;  ///< "variables[2].normal" -> line, from 1; TOML only
  /// Comments of a TOML file that are not a value of `json`: after a value, or inside a list.
  bool loose_comments = false;
};

/// "clearance.toml" is TOML, all others are JSON.
[[nodiscard]] bool is_toml(const std::filesystem::path& file);

/// @throws InputError with the place of the mistake. TOML: lines of comments before a key of the
/// first level become its remark.
[[nodiscard]] StudyText read_study_text(const std::string& text, const std::filesystem::path& file);

/// The text of a study, one key of the first level per line, lists of long rows with one
/// line per row. Reading it gives `json` again.
[[nodiscard]] std::string write_study_text(const nlohmann::ordered_json& json, bool toml);

/// A value as write_study_text() writes it in TOML, and a key with it on a separate line.
[[nodiscard]] std::string toml_text(const nlohmann::ordered_json& value);
[[nodiscard]] std::string toml_line(const std::string& key, const nlohmann::ordered_json& value);

}  // namespace adore::studies
