#pragma once

#include "studies/study_text.hpp"

#include <map>
#include <vector>

/// The one place that knows the TOML library.
namespace adore::studies {

/// A value of a TOML text, and its position [bytes].
struct TomlNode {
  nlohmann::json value;
  std::size_t key_begin = 0;       ///< of the key in front of it
  std::size_t begin = 0, end = 0;  ///< of its text
  bool simple = true;  ///< begin to end is all of it; not so under [headers] and behind dotted keys
  bool lines = false;  ///< a table with one key per line
  std::size_t keys_begin = 0;            ///< of such a table: where its first key may stand
  std::map<std::string, TomlNode> keys;  ///< of a table
  std::vector<TomlNode> items;           ///< of a list
};

/// @throws InputError as parse_toml()
[[nodiscard]] TomlNode parse_toml_nodes(const std::string& text, const std::string& name);

/// @throws InputError "a.toml, line 3: ..." for text that is not TOML.
[[nodiscard]] StudyText parse_toml(const std::string& text, const std::string& name);

}  // namespace adore::studies
