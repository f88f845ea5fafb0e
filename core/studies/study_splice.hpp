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

/// A text of `file`, whose values were others, with `values` instead. TOML: values that differ are
/// replaced where they stand; keys and rows that come or go take or leave lines of their own, with
/// the comment behind them. What cannot be placed so (a row in a list of [[tables]]), and JSON, is
/// written anew. Reading the text gives `values`, remarks ("// ...") apart.
[[nodiscard]] EditedText edited_study_text(const std::string& text,
                                           const nlohmann::ordered_json& values,
                                           const std::filesystem::path& file);

}  // namespace adore::studies
