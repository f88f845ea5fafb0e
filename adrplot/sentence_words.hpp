#pragma once

#include <cctype>
#include <string>

/// First letters within the sentences of a page.
namespace adore::adrplot {

/// Begins a sentence.
inline std::string capitalize_first(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// The title of a panel within a sentence; "FTF" stays.
inline std::string lowercase_first(std::string text) {
  const bool word = text.size() > 1 && std::islower(static_cast<unsigned char>(text[1]));
  if (word) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace adore::adrplot
