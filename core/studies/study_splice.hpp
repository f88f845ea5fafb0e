#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

/// Changes of a study's values that leave the rest of its text as people wrote it.
namespace adore::studies {

struct EditedText {
  std::string text;
  bool rewritten = false;  ///< as a whole: comments behind values and inside lists are gone
};

/// A text of `file`, with `values` instead of its present values. TOML: different values are
/// replaced in place; new and removed keys and rows add or remove whole lines, with
/// their comments. Other changes (a row in a list of [[tables]]), and JSON, are
/// written anew. Reading the text gives `values`, except for remarks ("// ...").
[[nodiscard]] EditedText edited_study_text(const std::string& text,
                                           const nlohmann::ordered_json& values,
                                           const std::filesystem::path& file);

}  // namespace adore::studies
