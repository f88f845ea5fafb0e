#pragma once

#include <filesystem>

/// How studies are reached from the window of a deck.
namespace adore::adrinput {

/// By its name: decks are never called so.
[[nodiscard]] bool has_study_file_name(const std::filesystem::path& file);

}  // namespace adore::adrinput
